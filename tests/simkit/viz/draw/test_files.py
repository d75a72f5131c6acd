"""What can be seen goes into a file of the kind that its name asks for."""

from __future__ import annotations

import io

import numpy as np
import pytest
from matplotlib.image import imread

from simkit.errors import UnknownNameError
from simkit.viz.draw.files import png_of_pixels, save_as

FORMATS = {".svg": lambda: "<svg>\u00e9\n\ud800</svg>\n", ".png": lambda: b"\x89PNG\r\n"}


def test_the_suffix_chooses_whatever_its_case(tmp_path):
    save_as(tmp_path / "a.SVG", FORMATS)
    save_as(str(tmp_path / "a.png"), FORMATS)
    assert (tmp_path / "a.SVG").read_bytes() == "<svg>\u00e9\n\\ud800</svg>\n".encode()
    assert (tmp_path / "a.png").read_bytes() == b"\x89PNG\r\n"


@pytest.mark.parametrize("name", ["a.jpg", "a", ".svg"])
def test_another_suffix_is_refused_with_those_that_there_are(tmp_path, name):
    with pytest.raises(UnknownNameError, match=r"\.svg") as refused:
        save_as(tmp_path / name, FORMATS, kind="replay format")
    assert "replay format" in str(refused.value)
    assert list(tmp_path.iterdir()) == []


def test_the_file_holds_the_pixels():
    pixels = np.random.default_rng(0).integers(0, 256, (7, 5, 4), dtype=np.uint8)
    read = imread(io.BytesIO(png_of_pixels(pixels)), format="png")
    assert np.array_equal(np.round(255 * read).astype(np.uint8), pixels)


def test_even_areas_are_short():
    assert len(png_of_pixels(np.zeros((450, 720, 4), np.uint8))) < 3000
