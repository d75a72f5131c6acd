"""A scene to turn and zoom, in a notebook or as a file: at one moment, or live as it follows a simulation."""

from __future__ import annotations

import json
import weakref
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from simkit.viz.draw.files import save_as
from simkit.viz.page.html import inline_frame
from simkit.viz.page.meshcat_window import MeshcatWindow, visualizer
from simkit.viz.page.scene_data import LiveScene, LiveSource, scene_data, scene_summary
from simkit.viz.page.view_page import LIVE_STATUS, page_height, view_page
from simkit.viz.stage.scene import Scene
from simkit.viz.still.picture import still_image
from simkit.viz.widgets.kernel_loop import running_notebook
from simkit.viz.widgets.panel import SavedStill

if TYPE_CHECKING:
    from simkit.viz.page.live_server import LiveServer
    from simkit.viz.widgets.scene_widget import SceneWidget

SMALL_SIZE = (360.0, 225.0)
"""Width and height of a thumbnail [px]."""


class RvizView:
    """Frames, grid and robot at one moment; it does not change afterwards.

    In a notebook it is drawn in place, to be turned by mouse, finger or arrow keys. It needs no
    server and no network, so it also works in a file and in a saved notebook.

    Args:
        scene: What it shows.

    Attributes:
        scene: What it shows, as plain data.
    """

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._window = MeshcatWindow()

    @property
    def meshcat(self) -> Any:
        """A `meshcat.Visualizer`: objects that are set there are in the page, in the fixed frame; not in a still picture."""
        return visualizer(self._window)

    @property
    def error(self) -> str:
        """Why no frame can be shown, in RViz' words; empty if some can."""
        return self.scene.tf.error

    @property
    def problems(self) -> tuple[str, ...]:
        """A sentence for each frame, link or robot that cannot be shown."""
        return self.scene.problems

    def to_html(self) -> str:
        """The view as one HTML file; equal scenes give equal text."""
        data = {**scene_data(self.scene), "meshcat": self._window.commands}
        return view_page(self.scene, data=data)

    def to_png(self, *, scale: int = 2) -> bytes:
        """A still picture as a PNG file; it needs no browser.

        Args:
            scale: Pixels of the file per pixel of the page.
        """
        from simkit.viz.still.picture import still_png

        return still_png(self.scene, scale=scale)

    def thumbnail(self) -> bytes:
        """A small still picture as a PNG file, without any words, on a ground that is seen through."""
        from simkit.viz.draw.files import png_of_pixels
        from simkit.viz.still.scene_raster import scene_pixels

        return png_of_pixels(scene_pixels(self.scene, size=SMALL_SIZE))

    def save(self, path: str | Path) -> None:
        """Write a file: the view as `.html`, a still picture as `.png`.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        save_as(path, {".html": self.to_html, ".png": self.to_png})

    def __repr__(self) -> str:
        return f"RvizView({scene_summary(self.scene)!r})"

    def _repr_html_(self) -> str:
        return inline_frame(
            self.to_html(),
            title=self.scene.window.title,
            height=page_height(self.scene),
            still=still_image(self.scene),
        )

    def _repr_png_(self) -> bytes:
        return self.to_png(scale=1)


class WorldView(RvizView):
    """The models of a world at one moment; it does not change afterwards.

    In a notebook it is drawn in place, to be turned by mouse, finger or arrow keys. It needs no
    server and no network. `save("world.png")` and `save("world.html")` keep it.

    Args:
        scene: What it shows.
    """

    def __repr__(self) -> str:
        return f"WorldView({self.scene.headline!r})"


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
