"""Pixels as a PNG file."""

from __future__ import annotations

import io

import numpy as np
from numpy.typing import NDArray
from PIL import Image


def png_of_pixels(pixels: NDArray[np.uint8]) -> bytes:
    """A PNG file.

    Args:
        pixels: Red, green, blue, opacity of each pixel; shape (height, width, 4).
    """
    buffer = io.BytesIO()
    Image.fromarray(pixels, "RGBA").save(buffer, "PNG", compress_level=9)
    return buffer.getvalue()


def few_colored_png(data: bytes) -> bytes:
    """A PNG file with a palette of 64 colours: a third of the bytes, and nobody sees the difference in a small picture."""
    file = io.BytesIO()
    Image.open(io.BytesIO(data)).convert("RGB").quantize(64).save(file, "PNG", optimize=True)
    return file.getvalue()
