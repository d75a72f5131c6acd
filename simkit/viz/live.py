"""A view that follows a simulation: the page of `RvizView`, and a server of this computer that sends it what moves."""

from __future__ import annotations

import json
import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simkit.viz.page.meshcat_window import MeshcatWindow, visualizer
from simkit.viz.page.scene_data import LiveScene, LiveSource, scene_data, scene_summary
from simkit.viz.page.view_page import LIVE_STATUS, view_page
from simkit.viz.still.picture import still_image
from simkit.viz.widgets.kernel_loop import running_notebook
from simkit.viz.widgets.panel import SavedStill

if TYPE_CHECKING:
    from simkit.viz.page.live_server import LiveServer
    from simkit.viz.widgets.scene_widget import SceneWidget


class LiveRviz:
    """Frames and robot as they are now, in a notebook or in a window of the browser.

    In a notebook it is a widget, which gets over the notebook's own channel what has moved: no port is
    opened, so that it also works on JupyterHub, on Colab and in an editor. For a terminal, `url` starts a small
    server on 127.0.0.1, which sends the page what has moved at most thirty times a second. What is shown
    never reaches the simulation.

    Args:
        source: Where the scenes come from.
        is_over: Asked before each look; the view ends when it holds.

    Attributes:
        settings: What is to be seen.
    """

    def __init__(self, source: LiveSource, *, is_over: Callable[[], bool] = lambda: False) -> None:
        self.settings: object = source.settings
        self._source = source
        self._is_over = is_over
        self._has_ended = False
        self._window = MeshcatWindow(self._show_meshcat)
        self._server: LiveServer | None = None
        self._live: LiveScene | None = None
        self._widget: SceneWidget | None = None
        self._still: SavedStill | None = None

    @property
    def url(self) -> str:
        """Address of the view, for a browser on this computer; the first question starts its server.

        Raises:
            SimkitError: There is no port for the server.
        """
        return self._started().url

    @property
    def widget(self) -> SceneWidget:
        """The view as a widget of a notebook, to be put into a box beside others."""
        if self._widget is None:
            from simkit.viz.widgets.scene_widget import SceneWidget

            self._widget = SceneWidget(self._source)
            self._show_meshcat()
            if not self.alive:
                self._widget.end()
        return self._widget

    @property
    def meshcat(self) -> Any:
        """A `meshcat.Visualizer`: objects that are set there are seen in this view, in the fixed frame."""
        return visualizer(self._window)

    def _show_meshcat(self) -> None:
        if self._widget is not None:
            self._widget.meshcat = json.dumps(self._window.commands)

    @property
    def alive(self) -> bool:
        """Whether it still follows."""
        return not self._has_ended and (self._server is None or self._server.alive)

    def refresh(self, *, now: bool = False) -> None:
        """Look at the simulation, and tell the viewers; returns at once.

        Args:
            now: Also if something was sent to a notebook a moment ago.
        """
        if not self.alive:
            return
        if self._is_over():
            self.close()
            return
        if self._server is not None and self._live is not None:
            self._server.update(self._live.look())
        if self._widget is not None:
            self._widget.refresh(now=now)

    def close(self) -> None:
        """End the server and the widget; what they show stays as it is."""
        if self._widget is not None and not self._has_ended:
            self._widget.refresh(now=True)
            self._widget.end()
        self._has_ended = True
        if self._server is not None:
            self._end()

    def _started(self) -> LiveServer:
        if self._server is None:
            from simkit.viz.page.live_server import LiveServer

            self._live = LiveScene(self._source)
            self._server = LiveServer(self._live.state)
            # Also at the end of the interpreter, and when nobody has the simulation any more.
            self._end = weakref.finalize(self, self._server.close)
            self._server.page = self.to_html()
        return self._server

    def to_html(self) -> str:
        """The page, with the scene as it is now."""
        scene = self._source.scene()
        data = {
            **scene_data(scene),
            "socket": self._started().socket_url,
            "meshcat": self._window.commands,
        }
        return view_page(
            scene,
            data=data,
            controls=[LIVE_STATUS],
            scripts=["live", "rviz_live"],
            connects_to=self._started().socket_url,
        )

    def __repr__(self) -> str:
        if not self.alive:
            return f"{type(self).__name__}(ended)"
        if self._server is None and running_notebook() is not None:
            return f"{type(self).__name__}({scene_summary(self._source.scene())!r})"
        return f"{type(self).__name__}({self.url})"

    def _ipython_display_(self) -> None:
        shell = running_notebook()
        if shell is None:
            raise NotImplementedError  # IPython falls back to the text
        self._still = self._still or SavedStill(self._still_html, self._still_text)
        self._still.show(self.widget)
        # The last moment of a cell must not be lost to the pause.
        shell.events.register("post_run_cell", self._after_cell)

    def _after_cell(self, *_: object) -> None:
        self.refresh(now=True)

    def _still_text(self) -> str:
        return scene_summary(self._source.scene())

    def _still_html(self) -> str:
        return still_image(self._source.scene())


class LiveWorld(LiveRviz):
    """The window of Gazebo as it is now; see `LiveRviz`."""
