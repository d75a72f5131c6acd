"""What stands beside widgets for later: they live in the kernel, and a saved notebook has none."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from simkit.viz.live_view import running_notebook

_CLASS: Final = "simkit-still"
_PANEL: Final = ".jp-OutputArea-output.lm-Panel"
_STYLE: Final = (
    f"<style>.jp-OutputArea:has({_PANEL} > *) .{_CLASS},"
    f".jp-OutputArea:has(.{_CLASS}) {_PANEL}:not(:has(> *))"
    "{display:none}</style>"
)
"""Of the widgets and the still that lie in one output of JupyterLab, only one is seen.

Widgets are a panel there, which stays empty but for a complaint when no kernel knows them.
"""


class SavedStill:
    """A second output of a cell, with the state of its widgets as HTML that needs no kernel.

    JupyterLab hides it as long as the widgets are alive. Without a kernel, on a page that nbconvert
    makes and in a viewer of notebooks it is what is left.

    Args:
        html: Makes the HTML of this moment.
        text: Makes the same as plain text.
    """

    def __init__(self, html: Callable[[], str], text: Callable[[], str]) -> None:
        self._html, self._text = html, text
        self._handle: Any = None
        self._told = ""

    def show(self, widget: Any) -> None:
        """Show widgets in the cell that runs, and the still behind them.

        Args:
            widget: What has the widgets; None if there are none, and the still is all.
        """
        from IPython.display import DisplayHandle, display

        if widget is not None:
            view = {**widget._repr_mimebundle_(), "text/plain": "(widgets; they need a kernel)"}
            display(view, raw=True)  # type: ignore[no-untyped-call]
        self._handle = self._handle or DisplayHandle()  # type: ignore[no-untyped-call]
        self._told = self._text()
        self._handle.display(self._bundle(), raw=True)
        shell = running_notebook()
        if shell is not None:
            shell.events.register("post_run_cell", self._after_cell)

    def refresh(self) -> None:
        """Make it anew if its text is another one, so that what is saved is how things are."""
        if self._handle is not None and self._text() != self._told:
            self._told = self._text()
            self._handle.update(self._bundle(), raw=True)

    def _after_cell(self, *_: object) -> None:
        self.refresh()

    def _bundle(self) -> dict[str, str]:
        html = f'{_STYLE}<div class="{_CLASS}">{self._html()}</div>'
        return {"text/html": html, "text/plain": self._told}
