"""A view that follows a simulation: the page of `RvizView`, and a server of this computer that tells it what moves."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING

from simkit.viz.page.html import inline_frame
from simkit.viz.page.live_state import LiveNews, NewsSource
from simkit.viz.page.scene_data import scene_data
from simkit.viz.page.view_page import page_height, view_page

if TYPE_CHECKING:
    from simkit.viz.page.live_server import LiveServer


_STATUS = '<p id="live" class="quiet" role="status">connecting to the simulation ...</p>'
_STATUS_HEIGHT = 40


class LiveRviz:
    """Frames and robot as they are now, in a notebook or in a window of the browser.

    A small server on 127.0.0.1 tells the page what has moved, at most thirty times a second. Where
    the browser does not reach this computer (JupyterHub, Colab), the page stays as it was at first.
    What is shown never reaches the simulation.

    Args:
        source: Where the scenes come from.
        is_over: Asked before each look; the server ends when it holds.

    Attributes:
        settings: What is to be seen.

    Raises:
        SimkitError: There is no port for the server.
    """

    def __init__(self, source: NewsSource, *, is_over: Callable[[], bool] = lambda: False) -> None:
        from simkit.viz.page.live_server import LiveServer

        self.settings: object = source.settings
        self._source = source
        self._is_over = is_over
        self._news = LiveNews(source)
        self._server: LiveServer = LiveServer(self._news.state)
        self._server.page = self.to_html()
        # Also at the end of the interpreter, and when nobody has the simulation any more.
        self._end = weakref.finalize(self, self._server.close)

    @property
    def url(self) -> str:
        """Address of the view, for a browser on this computer."""
        return self._server.url

    @property
    def alive(self) -> bool:
        """Whether it still follows."""
        return self._server.alive

    def refresh(self) -> None:
        """Look at the simulation, and tell the viewers; returns at once."""
        if not self._server.alive:
            return
        if self._is_over():
            self.close()
            return
        self._server.update(self._news.look())

    def close(self) -> None:
        """End the server; the pages stay as they are."""
        self._end()

    def to_html(self) -> str:
        """The page, with the scene as it is now."""
        scene = self._source.scene()
        data = {**scene_data(scene), "socket": self._server.socket_url}
        return view_page(
            scene,
            data=data,
            controls=[_STATUS],
            scripts=["live", "rviz_live"],
            connects_to=self._server.socket_url,
        )

    def __repr__(self) -> str:
        if not self.alive:
            return f"{type(self).__name__}(ended)"
        return f"{type(self).__name__}({self.url})"

    def _repr_html_(self) -> str:
        height = page_height(self._news.scene) + _STATUS_HEIGHT
        return inline_frame(self.to_html(), title=self._news.scene.window.title, height=height)


class LiveWorld(LiveRviz):
    """The window of Gazebo as it is now; see `LiveRviz`."""
