"""The window of turtlesim in a browser, for a simulation in a terminal: a page of this computer that follows it."""

from __future__ import annotations

import json
import time
import weakref
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from simkit.nodes.turtlesim import Frame
from simkit.viz.page.html import html_page
from simkit.viz.turtlesim.picture import Picture

if TYPE_CHECKING:
    from simkit.viz.page.live_server import LiveServer

_LEAST_PAUSE: Final = 0.05
"At most so often is a picture drawn [s of wall-clock time]."
_SHARE: Final = 0.2
"At most this part of the time is spent on drawing."


@dataclass(frozen=True, slots=True, kw_only=True)
class TurtlesimState:
    """The window at one moment."""

    svg: str
    """Its picture."""

    def news(self, known: TurtlesimState | None) -> str | None:
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
