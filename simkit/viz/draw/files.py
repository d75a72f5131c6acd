"""Files of pictures: of the kind that their name asks for, and PNG of given pixels."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from simkit.errors import UnknownNameError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

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
