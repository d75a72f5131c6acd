from __future__ import annotations

import io

import numpy as np
from matplotlib.image import imread

from simkit.viz.draw.pixels import png_of_pixels


def test_the_file_holds_the_pixels():
    pixels = np.random.default_rng(0).integers(0, 256, (7, 5, 4), dtype=np.uint8)
    read = imread(io.BytesIO(png_of_pixels(pixels)), format="png")
    assert np.array_equal(np.round(255 * read).astype(np.uint8), pixels)


def test_even_areas_are_short():
    assert len(png_of_pixels(np.zeros((450, 720, 4), np.uint8))) < 3000
