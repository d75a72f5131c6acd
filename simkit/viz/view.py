"""A scene at one moment: a view to turn, in a notebook or as a file, and a still picture."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from simkit.viz.draw.files import save_as
from simkit.viz.page.html import inline_frame
from simkit.viz.page.meshcat_window import MeshcatWindow, visualizer
from simkit.viz.page.scene_data import scene_data, scene_summary
from simkit.viz.page.view_page import page_height, view_page
from simkit.viz.stage.scene import Scene
from simkit.viz.still.picture import still_image

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
