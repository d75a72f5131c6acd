"""The frames of tf in space, as a view to turn and as a still picture: RViz' TF display."""

from __future__ import annotations

from pathlib import Path

from simkit.errors import UnknownNameError
from simkit.msgs import Time
from simkit.tf import LATEST, Buffer
from simkit.viz.drawing import Drawing
from simkit.viz.frames_page import TITLE, frames_page, page_height, summary
from simkit.viz.frames_still import draw_scene
from simkit.viz.page import inline_frame
from simkit.viz.stage import stage_for
from simkit.viz.svg import svg_text
from simkit.viz.tf_scene import tf_scene

FORMATS = (".html", ".png", ".svg")
"""What `FramesView.save` writes, by suffix."""


class FramesView:
    """Axes, names and parents of all frames at one moment; it does not change afterwards.

    In a notebook it is drawn in place, to be turned by mouse, finger or arrow keys. It needs no
    server and no network, so it also works in a file and in a saved notebook.

    Args:
        buffer: The transforms.
        fixed_frame: The frame that all others are seen from.
        time: When; for each frame its latest time if `Time(0)`.
    """

    def __init__(self, buffer: Buffer, fixed_frame: str = "world", *, time: Time = LATEST) -> None:
        self._scene = tf_scene(buffer, fixed_frame=fixed_frame, time=time)
        self._stage = stage_for(self._scene)

    @property
    def error(self) -> str:
        """Why nothing can be shown, in RViz' words; empty if something can."""
        return self._scene.error

    @property
    def problems(self) -> tuple[str, ...]:
        """A sentence for each frame that cannot be shown."""
        return self._scene.problems

    def to_html(self) -> str:
        """The view as one HTML file; equal buffers give equal text."""
        return frames_page(self._scene, self._stage)

    def to_svg(self) -> str:
        """A still picture as an SVG document."""
        return svg_text(self._drawing())

    def to_png(self, *, scale: float = 2.0) -> bytes:
        """A still picture as a PNG file.

        Args:
            scale: Pixels of the file per pixel of the SVG.
        """
        from simkit.viz.figure import png_bytes

        return png_bytes(self._drawing(), scale=scale)

    def save(self, path: str | Path) -> None:
        """Write a file: the view as `.html`, a still picture as `.svg` or `.png`.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        path = Path(path)
        match path.suffix.lower():
            case ".html":
                path.write_text(self.to_html(), encoding="utf-8", newline="\n")
            case ".svg":
                path.write_text(self.to_svg(), encoding="utf-8", newline="\n")
            case ".png":
                path.write_bytes(self.to_png())
            case suffix:
                raise UnknownNameError("picture format", suffix, FORMATS)

    def __repr__(self) -> str:
        return f"FramesView({summary(self._scene)!r})"

    def _repr_html_(self) -> str:
        return inline_frame(self.to_html(), title=TITLE, height=page_height(self._scene))

    def _drawing(self) -> Drawing:
        return draw_scene(self._scene, self._stage)
