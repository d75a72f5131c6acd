"""A picture in a notebook that is drawn anew whenever it has changed."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any, Protocol

_LEAST_PAUSE = 0.05
"At most so often is a picture sent [s of wall-clock time]: more would choke the notebook."


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


def running_notebook() -> Any:
    """IPython's shell in the kernel of a notebook; None elsewhere."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell if hasattr(shell, "kernel") else None


def _new_handle() -> Any:
    from IPython.display import DisplayHandle

    return DisplayHandle()  # type: ignore[no-untyped-call]


def _bundle(svg: str) -> dict[str, str]:
    return {"image/svg+xml": svg, "text/plain": "a live view: run the simulation"}
