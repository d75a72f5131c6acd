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
