"""What every widget of a notebook is: controls in the browser, a picture beside them, and a still for later.

Controls live in a script; it shows a state, and sends what a person does. Both go over the notebook's
own channel. Widgets need a kernel, and a saved notebook has none: what is left there is the still.
"""

from __future__ import annotations

import base64
import html
from collections.abc import Callable, Mapping
from functools import cache
from importlib import resources
from typing import Any, ClassVar, Final

from simkit.errors import SimkitError
from simkit.viz.page.html import png_image
from simkit.viz.widgets.kernel_loop import KernelLoop, Later, running_notebook

_PAUSE: Final = 0.1
"At most so often the picture is drawn [s of wall-clock time]."
_CLASS: Final = "simkit-still"
_BESIDE_WIDTH: Final = "900px"
"In a narrower cell the controls are below the view that they move."
_PANEL: Final = ".jp-OutputArea-output.lm-Panel"
_STYLE: Final = (
    f"<style>.jp-OutputArea:has({_PANEL} > *) .{_CLASS},"
    f".jp-OutputArea:has(.{_CLASS}) {_PANEL}:not(:has(> *))"
    "{display:none}</style>"
)
"""Of the widgets and the still that lie in one output of JupyterLab, only one is seen.

Widgets are a panel there, which stays empty but for a complaint when no kernel knows them.
"""


class Panel:
    """Controls of a simulation in a notebook; a text where no widgets can be shown.

    Args:
        later: Where a run waits for its turn; the kernel's event loop if None.
        view: A view with a `widget`, which is shown beside the controls.
        png: Makes a small picture of the robot, which is shown where there is no view; without it, there is none.
    """

    SCRIPT: ClassVar[str]
    """Name of the script in the assets."""

    def __init__(
        self,
        *,
        later: Later | None = None,
        view: Any = None,
        png: Callable[[], bytes] | None = None,
    ) -> None:
        self._later = later or KernelLoop()
        self._message = ""
        self._view, self._png = view, png
        self._front: Any = None
        self._box: Any = None
        self._still: SavedStill | None = None
        self._is_drawing = self._is_waiting = False

    def state(self) -> dict[str, Any]:
        """What the script shows, as JSON."""
        raise NotImplementedError

    def hear(self, message: Mapping[str, Any]) -> None:
        """A person has done something.

        Args:
            message: What the script has sent.
        """
        raise NotImplementedError

    def picture(self) -> dict[str, str]:
        """The picture beside the controls: `svg`, or `png` in base64 with its `words`; empty without one."""
        if self._png is None:
            return {}
        stand = self.stand()
        return png_picture(self._png(), f"The robot with {stand}" if stand else "The robot")

    def stand(self) -> str:
        """How the robot in the picture stands, for screen readers; empty if nothing is known."""
        return ""

    @property
    def widget(self) -> Any:
        """The widget.

        Raises:
            SimkitError: anywidget is not installed.
        """
        if self._box is None:
            self._front = _front_class()(_esm=_script(self.SCRIPT), _css=_asset("panel.css"))
            self._front.on_msg(lambda _widget, content, _buffers: self.hear(content))
            self._front.state = self.state()
            self._front.picture = {} if self._view is not None else self.picture()
            self._box = _side_by_side(self._front, self._view)
        return self._box

    def refresh(self) -> None:
        """Show how things are now."""
        if self._front is None:
            return
        self._front.state = self.state()
        if self._front.picture and not self._is_drawing:
            self._is_drawing = True
            self._later.after(_PAUSE, self._draw)

    def say(self, text: str) -> None:
        """Show a fault below the controls; none if empty."""
        self._message = text
        if self._front is not None:
            self._front.state = self.state()

    def _attempt(self, act: Callable[[], None]) -> bool:
        """Do something; whether it could be done. A fault is said."""
        try:
            act()
        except SimkitError as error:
            self.say(str(error))
            return False
        return True

    def _soon(self, work: Callable[[], None]) -> None:
        """Do something when nothing else runs; once, however often it is asked for meanwhile."""
        if not self._is_waiting:
            self._is_waiting = True
            self._later.soon(lambda: self._work(work))

    def _work(self, work: Callable[[], None]) -> None:
        self._is_waiting = False
        work()

    def _draw(self) -> None:
        self._is_drawing = False
        if self._front is not None:
            self._front.picture = self.picture()

    def _repr_html_(self) -> str:
        lines = html.escape(repr(self))
        note = "<small>The widgets need a running notebook.</small>"
        return f"{picture_html(self.picture())}<pre>{lines}</pre>{note}"

    def _ipython_display_(self) -> None:
        if running_notebook() is None:
            raise NotImplementedError  # IPython falls back to the text
        self._still = self._still or SavedStill(self._repr_html_, self.__repr__, self.picture)
        self._still.show(self._widget_or_none())

    def _widget_or_none(self) -> Any:
        try:
            return self.widget
        except SimkitError:
            return None


class SavedStill:
    """A second output of a cell, with the state of its widgets as HTML that needs no kernel.

    JupyterLab hides it as long as the widgets are alive. Without a kernel, on a page that nbconvert
    makes and in a viewer of notebooks it is what is left.

    Args:
        page: Makes the HTML of this moment.
        text: Makes the same as plain text.
        picture: Makes the picture in it, for readers that strip HTML.
    """

    def __init__(
        self,
        page: Callable[[], str],
        text: Callable[[], str],
        picture: Callable[[], Mapping[str, str]] = dict,
    ) -> None:
        self._page, self._text, self._picture = page, text, picture
        self._handle: Any = None
        self._shown = ""

    def show(self, widget: Any) -> None:
        """Show widgets in the cell that runs, and the still behind them.

        Args:
            widget: What has the widgets; None if there are none, and the still is all.
        """
        from IPython.display import DisplayHandle, display

        if widget is not None:
            found = widget._repr_mimebundle_()
            data = found[0] if isinstance(found, tuple) else found
            view = {**data, "text/plain": "(widgets; they need a kernel)"}
            display(view, raw=True)  # type: ignore[no-untyped-call]
        self._handle = self._handle or DisplayHandle()  # type: ignore[no-untyped-call]
        self._shown = self._text()
        self._handle.display(self._bundle(), raw=True)
        shell = running_notebook()
        if shell is not None:
            shell.events.register("post_run_cell", self._after_cell)

    def refresh(self) -> None:
        """Make it anew if its text is another one, so that what is saved is how things are."""
        if self._handle is not None and self._text() != self._shown:
            self._shown = self._text()
            self._handle.update(self._bundle(), raw=True)

    def _after_cell(self, *_: object) -> None:
        self.refresh()

    def _bundle(self) -> dict[str, str]:
        page = f'{_STYLE}<div class="{_CLASS}">{self._page()}</div>'
        kinds = {"svg": "image/svg+xml", "png": "image/png"}
        picture = {kinds[key]: data for key, data in self._picture().items() if key in kinds}
        return {**picture, "text/html": page, "text/plain": self._shown}


def png_picture(data: bytes, words: str) -> dict[str, str]:
    """A PNG file as a picture of a panel.

    Args:
        data: The file.
        words: What it shows, for screen readers.
    """
    return {"png": base64.b64encode(data).decode("ascii"), "words": words}


def picture_html(picture: Mapping[str, str]) -> str:
    """A picture of a panel as HTML; nothing if it is empty."""
    if "svg" in picture:
        return picture["svg"]
    if "png" not in picture:
        return ""
    data = base64.b64decode(picture["png"])
    return png_image(data, picture["words"], style="display:block")


@cache
def _front_class() -> Any:
    try:
        import anywidget
        import traitlets
    except ImportError as error:
        raise SimkitError("widgets need anywidget: pip install anywidget") from error

    class Front(anywidget.AnyWidget):
        """The side of a panel that is in the browser."""

        _esm = traitlets.Unicode().tag(sync=True)
        _css = traitlets.Unicode().tag(sync=True)
        state = traitlets.Dict().tag(sync=True)
        picture = traitlets.Dict().tag(sync=True)

    return Front


def _side_by_side(front: Any, view: Any) -> Any:
    """A view beside the controls that move it; above them where a cell is too narrow for both."""
    if view is None:
        return front
    import ipywidgets

    # In a cell that is narrower than this the view asks for far more than there is, and gets a row of its own; in a wider
    # one it asks for nothing, and gets what the controls leave. (It may be shown elsewhere too: the room is that of a box.)
    room = {
        "flex": f"1 1 calc(({_BESIDE_WIDTH} - 100%) * 999)",
        "min_width": "18em",
        "max_width": "100%",
    }
    beside = ipywidgets.VBox([view.widget], layout=room)
    layout = {
        "flex_flow": "row-reverse wrap",
        "justify_content": "flex-end",
        "align_items": "flex-start",
        "width": "100%",
    }
    return ipywidgets.HBox([beside, front], layout=layout)


def _script(name: str) -> str:
    return _asset("panel.js") + _asset(f"{name}.js")


def _asset(name: str) -> str:
    return resources.files(__package__).joinpath("assets", name).read_text(encoding="utf-8")
