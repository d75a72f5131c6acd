"""view_frames: the tree of frames, with what is known about each transform, as a picture."""

from __future__ import annotations

from pathlib import Path

from simkit.msgs import Time
from simkit.saving import save_as
from simkit.tf import Buffer
from simkit.viz.draw.drawing import Drawing
from simkit.viz.draw.svg import svg_text
from simkit.viz.forest import Forest, forest_of
from simkit.viz.frames_dot import dot_text
from simkit.viz.frames_sheet import draw_forest


class FramesPicture:
    """What `rosrun tf2_tools view_frames.py` finds out, at one moment; it does not change later.

    Args:
        buffer: The transforms.
        now: Current time, shown as the time of recording; left out if None.

    Source:
        tf2_tools `view_frames.py`: the same facts on each edge. The layout is our own.
    """

    def __init__(self, buffer: Buffer, *, now: Time | None = None) -> None:
        self._forest: Forest = forest_of(buffer.core)
        self._yaml = buffer.all_frames_as_yaml()
        self._now = now

    @property
    def warnings(self) -> tuple[str, ...]:
        """Sentences on trees that are not connected, and on loops."""
        return self._forest.warnings

    def to_svg(self) -> str:
        """The tree as an SVG document; equal buffers give equal text."""
        return svg_text(self._drawing())

    def to_png(self, *, scale: float = 2.0) -> bytes:
        """The tree as a PNG file.

        Args:
            scale: Pixels of the file per pixel of the SVG.
        """
        from simkit.viz.draw.figure import png_bytes

        return png_bytes(self._drawing(), scale=scale)

    def to_pdf(self) -> bytes:
        """The tree as a PDF file of one page."""
        from simkit.viz.draw.figure import pdf_bytes

        return pdf_bytes(self._drawing())

    def to_dot(self) -> str:
        """The tree in graphviz' language, as `frames.gv` has it."""
        return dot_text(self._forest, self._now)

    def to_yaml(self) -> str:
        """Parent, broadcaster, rate and stamps of each frame, as tf2 writes them."""
        return self._yaml

    def save(self, path: str | Path) -> None:
        """Write a file: `.svg`, `.pdf`, `.png`, `.gv` or `.yaml` by its suffix.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        save_as(
            path,
            {
                ".gv": self.to_dot,
                ".pdf": self.to_pdf,
                ".png": self.to_png,
                ".svg": self.to_svg,
                ".yaml": self.to_yaml,
            },
        )

    def __repr__(self) -> str:
        return f"FramesPicture({self._forest.frame_count} frames, {len(self._forest.trees)} trees)"

    def _repr_svg_(self) -> str:
        return self.to_svg()

    def _drawing(self) -> Drawing:
        return draw_forest(self._forest, self._now)
