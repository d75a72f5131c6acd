from __future__ import annotations

import io

import matplotlib
import matplotlib.image
import numpy as np
import pytest

from simkit.viz.draw.drawing import Area, Curve, Drawing, Group, Label, Polyline, RoundedBox
from simkit.viz.draw.figure import pdf_bytes, png_bytes


@pytest.fixture
def drawing():
    shapes = (
        RoundedBox(corner=(10, 10), size=(40, 20), fill="#ff0000", edge="#000000", radius=4),
        Polyline(points=((0, 80), (100, 80)), color="#0000ff", width=4),
        Curve(points=((60, 10), (60, 30), (90, 30), (90, 50)), color="#00aa00", width=3),
        Group(title="g", shapes=(Area(points=((10, 50), (30, 50), (20, 70)), fill="#00ff00"),)),
        Label(place=(50, 95), text="$x$ 世界 <b>", color="#000000", align="middle", halo="#eeeeee"),
    )
    return Drawing(title="t", description="d", size=(100, 100), background="#ffffff", shapes=shapes)


def pixels(png):
    image = matplotlib.image.imread(io.BytesIO(png), format="png")
    return np.rint(image[:, :, :3] * 255).astype(int)


def test_shapes_are_where_they_should_be(drawing):
    image = pixels(png_bytes(drawing, scale=1))
    assert image.shape == (100, 100, 3)
    assert tuple(image[20, 30]) == (255, 0, 0)
    assert tuple(image[80, 50]) == (0, 0, 255)
    assert tuple(image[55, 20]) == (0, 255, 0)
    assert tuple(image[5, 5]) == (255, 255, 255)
    assert image[85:99, 20:80].min() < 100


def test_scale_gives_more_pixels(drawing):
    assert pixels(png_bytes(drawing, scale=3)).shape == (300, 300, 3)


def test_the_readers_settings_change_nothing(drawing):
    png, pdf = png_bytes(drawing), pdf_bytes(drawing)
    odd = {
        "savefig.bbox": "tight",
        "font.size": 30,
        "pdf.compression": 0,
        "lines.antialiased": False,
    }
    with matplotlib.rc_context(odd):
        assert png_bytes(drawing) == png
        assert pdf_bytes(drawing) == pdf
        assert matplotlib.rcParams["font.size"] == 30


def test_pdf_has_no_date_and_no_version(drawing):
    pdf = pdf_bytes(drawing)
    assert pdf.startswith(b"%PDF-")
    assert b"CreationDate" not in pdf
    assert b"Matplotlib" not in pdf
