"""`SceneWidget`: a scene that moves, as a widget of a notebook; other widgets stand beside it in a box of ipywidgets.

`SceneWidget(source)` shows what a source of scenes shows, `refresh()` looks at it again. Of a live view,
`sim.rviz(live=True).widget` is it. It needs no port: traits of the widget carry the scene and the moment.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from importlib import resources
from typing import Any, Final

import anywidget
import traitlets

from simkit.viz.page.scene_data import LiveScene, LiveSource, SceneState, scene_data
from simkit.viz.page.view_page import LIVE_STATUS, page_height, view_page

LEAST_PAUSE: Final = 0.05
"""At most so often is the notebook sent a moment [s of wall-clock time]: more would choke it."""
OVER: Final = "Not live any more: the simulation is over."
"""What is written below a scene that has ended."""
_STATUS_HEIGHT: Final = 40


class SceneWidget(anywidget.AnyWidget):
    """The page of a scene in a frame of its own, which gets each moment by traits.

    The page is the same as that of a saved view. Whoever opens the notebook later, or a second
    time, sees the last moment, for traits are kept.

    Args:
        source: Where the scenes come from.
        clock: Wall-clock time [s].
    """

    _esm = resources.files("simkit.viz.page").joinpath("assets", "widget.js").read_text("utf-8")

    page = traitlets.Unicode().tag(sync=True)
    """The HTML, with the scene as it was at first."""
    title = traitlets.Unicode().tag(sync=True)
    """What it shows, for screen readers."""
    height = traitlets.Int().tag(sync=True)
    """Room that the page needs [px]."""
    scene = traitlets.Unicode().tag(sync=True)
    """A later scene as JSON, once shapes or frames have come or gone; empty before that."""
    moment = traitlets.Unicode().tag(sync=True)
    """Where everything is now, as JSON."""
    meshcat = traitlets.Unicode().tag(sync=True)
    """Commands of meshcat for objects that a person has added, as JSON; empty if there are none."""
    status = traitlets.Unicode().tag(sync=True)
    """What is written below the picture; empty as long as it is live."""

    def __init__(
        self, source: LiveSource, *, clock: Callable[[], float] = time.monotonic, **traits: Any
    ) -> None:
        self._live = LiveScene(source)
        self._clock = clock
        self._next_time = 0.0
        self._sent = self._live.state
        first = self._live.scene
        page = view_page(
            first,
            data={**scene_data(first), "socket": ""},
            controls=[LIVE_STATUS],
            scripts=["live", "rviz_live"],
        )
        height = page_height(first) + _STATUS_HEIGHT
        super().__init__(page=page, title=first.window.title, height=height, **traits)

    @property
    def live(self) -> LiveScene:
        """The scene as it was seen last."""
        return self._live

    def refresh(self, *, now: bool = False) -> None:
        """Look again, and send what has changed.

        Args:
            now: Also if the last moment was sent a moment ago.
        """
        if self.status or not (now or self._clock() >= self._next_time):
            return
        self._publish(self._live.look())
        self._next_time = self._clock() + LEAST_PAUSE

    def end(self) -> None:
        """Leave the last moment as it is, and say so."""
        self.status = OVER

    def _publish(self, state: SceneState) -> None:
        if state.number != self._sent.number:
            self.scene = (
                json.dumps({"number": state.number})[:-1]
                + f',"scene":{state.scene},"changes":{{}}}}'
            )
        if state != self._sent:
            self.moment = state.moment()
        self._sent = state
