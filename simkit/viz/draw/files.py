"""Pictures as files: of the kind that their name asks for, and PNG of given pixels."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar, TypeAlias

from simkit.errors import UnknownNameError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from simkit.viz.draw.drawing import Drawing

Formats: TypeAlias = Mapping[str, Callable[[], str | bytes]]
"""What makes the content of a file, by its suffix, e.g. `.svg`."""


def save_as(path: str | Path, formats: Formats, *, kind: str = "picture format") -> None:
    """Write a file in the format of its suffix.

    Args:
        path: Where to.
        formats: What there is to choose from.
        kind: What a suffix chooses, for the message.

    Raises:
        UnknownNameError: There is no such format.
        OSError: The file cannot be written.
    """
    path = Path(path)
    make = formats.get(path.suffix.lower())
    if make is None:
        raise UnknownNameError(kind, path.suffix, formats)
    content = make()
    if isinstance(content, bytes):
        path.write_bytes(content)
    else:  # half a character, which a frame may have in its name, is written as what it is
        path.write_text(content, encoding="utf-8", errors="backslashreplace", newline="\n")


class DrawnPicture:
    """A drawing that shows itself in a notebook, and is saved."""

    SCALE: ClassVar[float] = 2.0
    """Pixels of a PNG file per pixel of the SVG, unless one says otherwise."""

    def drawing(self) -> Drawing:
        """What is drawn."""
        raise NotImplementedError

    def to_svg(self) -> str:
        """The picture as an SVG document; equal pictures give equal text."""
        from simkit.viz.draw.svg import svg_text

        return svg_text(self.drawing())

    def to_png(self, scale: float | None = None) -> bytes:
        """The picture as a PNG file.

        Args:
            scale: Pixels of the file per pixel of the SVG.
        """
        from simkit.viz.draw.figure import png_bytes

        return png_bytes(self.drawing(), scale=self.SCALE if scale is None else scale)

    def to_pdf(self) -> bytes:
        """The picture as a PDF file of one page."""
        from simkit.viz.draw.figure import pdf_bytes

        return pdf_bytes(self.drawing())

    def save(self, path: str | Path) -> None:
        """Write a file in the format of its suffix.

        Raises:
            UnknownNameError: There is no such format.
        """
        save_as(path, self.formats())

    def formats(self) -> Formats:
        """The files that it can be, by their suffix."""
        return {".pdf": self.to_pdf, ".png": lambda: self.to_png(2.0), ".svg": self.to_svg}

    def _repr_svg_(self) -> str:
        return self.to_svg()


def png_of_pixels(pixels: NDArray[np.uint8]) -> bytes:
    """A PNG file.

    Args:
        pixels: Red, green, blue, opacity of each pixel; shape (height, width, 4).
    """
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(pixels, "RGBA").save(buffer, "PNG", compress_level=9)
    return buffer.getvalue()


def few_colored_png(data: bytes) -> bytes:
    """A PNG file with a palette of 64 colours: a third of the bytes, and nobody sees the difference in a small picture."""
    from PIL import Image

    file = io.BytesIO()
    Image.open(io.BytesIO(data)).convert("RGB").quantize(64).save(file, "PNG", optimize=True)
    return file.getvalue()
