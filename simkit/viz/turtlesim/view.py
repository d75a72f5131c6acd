"""The window of turtlesim to look at: as a picture, as a replay, and live, in a notebook or for a terminal."""

from __future__ import annotations

import json
import time
import weakref
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, Protocol

from simkit.nodes.turtlesim import Frame, TurtlesimNode
from simkit.viz.page.html import html_page
from simkit.viz.turtlesim.picture import Picture
from simkit.viz.turtlesim.replay import TurtleReplay
from simkit.viz.widgets.kernel_loop import running_notebook

if TYPE_CHECKING:
    from simkit.viz.page.live_server import LiveServer

_LEAST_PAUSE: Final = 0.05
"At most so often is a picture drawn [s of wall-clock time]: more would choke a notebook."
_SHARE: Final = 0.2
"At most this part of the time is spent on drawing for a terminal."


class TurtlesimView:
    """What `sim.turtlesim` is.

    Args:
        node: The turtlesim that runs.
        add_view: Is given a function to call after each stretch of virtual time.
    """

    def __init__(
        self, node: TurtlesimNode, *, add_view: Callable[[Callable[[], None]], object]
    ) -> None:
        self._node = node
        self._add_view = add_view

    @property
    def frame(self) -> Frame:
        """The turtles and their trails."""
        return self._node.frame

    def picture(self, *, names: bool = False) -> Picture:
        """What the window shows now.

        Args:
            names: Write each turtle's name below it.
        """
        return Picture(self._node.frame, names=names)

    def replay(self) -> TurtleReplay:
        """Everything that happened in the window so far, to be played again."""
        return TurtleReplay(self._node.frame)

    def live(self, *, names: bool = True) -> LiveView:
        """A window in a notebook that follows the simulation.

        Args:
            names: Write each turtle's name below it.
        """
        view = LiveView(lambda: self.picture(names=names))
        self._add_view(view.refresh)
        return view


class SvgPicture(Protocol):
    """Anything that a notebook shows as SVG."""

    def _repr_svg_(self) -> str: ...


class LiveView:
    """Shows a picture in the cell that it is displayed in, and keeps it up to date there.

    Outside a notebook everything here is harmless and does nothing. What is shown never reaches
    the simulation, so the pace of the wall clock decides only how often a picture is sent.

    Args:
        draw: Makes the picture of this moment.
        clock: Wall-clock time [s].
    """

    def __init__(
        self, draw: Callable[[], SvgPicture], *, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._draw = draw
        self._clock = clock
        self._handle: Any = None
        self._sent = ""
        self._next_time = 0.0

    def refresh(self) -> None:
        """Draw again if the picture has changed, unless the last one is a moment old."""
        if self._handle is not None and self._clock() >= self._next_time:
            self._send()

    def close(self) -> None:
        """Leave the last picture as it is."""
        self._handle = None

    def __repr__(self) -> str:
        return "LiveView(seen in a notebook only)"

    def _ipython_display_(self) -> None:
        shell = running_notebook()
        if shell is None:
            raise NotImplementedError  # IPython falls back to the plain text
        self._handle = self._handle or _new_handle()
        self._sent = self._draw()._repr_svg_()
        self._handle.display(_bundle(self._sent), raw=True)
        # The last picture of a cell must not be lost to the pause.
        shell.events.register("post_run_cell", self._after_cell)

    def _after_cell(self, *_: object) -> None:
        if self._handle is not None:
            self._send()

    def _send(self) -> None:
        svg = self._draw()._repr_svg_()
        self._next_time = self._clock() + _LEAST_PAUSE
        if svg != self._sent:
            self._sent = svg
            self._handle.update(_bundle(svg), raw=True)


def _new_handle() -> Any:
    from IPython.display import DisplayHandle

    return DisplayHandle()  # type: ignore[no-untyped-call]


def _bundle(svg: str) -> dict[str, str]:
    return {"image/svg+xml": svg, "text/plain": "a live view: run the simulation"}


@dataclass(frozen=True, slots=True, kw_only=True)
class TurtlesimState:
    """The window at one moment."""

    svg: str
    """Its picture."""

    def changes(self, known: TurtlesimState | None) -> str | None:
        """The picture as JSON; None if it is the known one."""
        if known is not None and known.svg == self.svg:
            return None
        return json.dumps({"svg": self.svg}, separators=(",", ":"))


class LiveTurtlesim:
    """A page that shows the turtles as they are now, in a browser on this computer.

    It is drawn only while somebody looks. What is shown never reaches the simulation.

    Args:
        frame: The window of turtlesim.
        is_over: Asked before each look; the server ends when it holds.
        clock: Wall-clock time [s].

    Raises:
        SimkitError: There is no port for the server.
    """

    def __init__(
        self,
        frame: Frame,
        *,
        is_over: Callable[[], bool] = lambda: False,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        from simkit.viz.page.live_server import LiveServer

        self._frame = frame
        self._is_over = is_over
        self._clock = clock
        self._next_time = 0.0
        state = self._state()
        self._server: LiveServer = LiveServer(state)
        self._server.page = self._page(state.svg)
        # Also at the end of the interpreter, and when nobody has the simulation any more.
        self._end = weakref.finalize(self, self._server.close)

    @property
    def url(self) -> str:
        """Address of the page, for a browser on this computer."""
        return self._server.url

    @property
    def alive(self) -> bool:
        """Whether it still follows."""
        return self._server.alive

    def refresh(self) -> None:
        """Look at the turtles, and tell the viewers, if there are any and the last picture is not new."""
        if not self._server.alive:
            return
        if self._is_over():
            self.close()
            return
        begin = self._clock()
        if not self._server.viewer_count or begin < self._next_time:
            return
        self._server.update(self._state())
        end = self._clock()
        self._next_time = end + max(_LEAST_PAUSE, (end - begin) / _SHARE)

    def close(self) -> None:
        """End the server; the pages stay as they are."""
        self._end()

    def _state(self) -> TurtlesimState:
        return TurtlesimState(svg=Picture(self._frame, names=True).to_svg())

    def _page(self, svg: str) -> str:
        return html_page(
            title="turtlesim",
            name="turtlesim_live",
            body=f'<div id="window">{svg}</div>\n'
            '<p id="live" class="quiet" role="status">connecting to turtlesim ...</p>',
            data={"socket": self._server.socket_url},
            scripts=("live", "turtlesim_live"),
            connects_to=self._server.socket_url,
        )
