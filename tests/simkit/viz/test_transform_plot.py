from __future__ import annotations

import io
import xml.etree.ElementTree as ET

import matplotlib
import matplotlib.image
import pytest

from simkit.errors import UnknownNameError
from simkit.tf import LookupException
from simkit.viz import TransformPlot

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture
def plot(turtles):
    return TransformPlot(turtles, target="world", source="turtle1")


def test_the_figure_says_what_it_shows(plot, texts):
    shown = texts(plot.to_svg())
    assert {'"turtle1" seen from "world"', "position [m]", "yaw [rad]", "x", "y", "z", "yaw"} < set(
        shown
    )
    assert "virtual time [s] since 1600088400.000" in shown
    root = ET.fromstring(plot.to_svg())
    assert root.attrib["role"] == "img"
    assert root.findtext(f"{SVG}title") == '"turtle1" seen from "world"'


def test_a_static_transform_is_a_level_line(buffer, texts):
    buffer.put("a", "b", 0, (1, 2, 3), static=True)
    plot = TransformPlot(buffer, target="a", source="b")
    assert any("static transform" in text for text in texts(plot.to_svg()))
    assert plot.series.x == (1.0,)


def test_equal_data_give_equal_bytes_whatever_the_reader_set(plot, turtles):
    svg, png, pdf = plot.to_svg(), plot.to_png(), plot.to_pdf()
    with matplotlib.rc_context({"font.size": 30, "axes.facecolor": "black", "svg.hashsalt": "x"}):
        again = TransformPlot(turtles, target="world", source="turtle1")
        assert again.to_svg() == svg
        assert again.to_png() == png
        assert again.to_pdf() == pdf


def test_png_has_its_size(plot):
    image = matplotlib.image.imread(io.BytesIO(plot.to_png()), format="png")
    assert image.shape[:2] == (644, 1008)


def test_odd_names_are_only_names(hostile, texts):
    for name in ("<script>alert(1)</script>", "\"&'<b>", "a\x00b\x1bc\ud800", "x" * 5000, "世界"):
        svg = TransformPlot(hostile, target="wörld", source=name).to_svg()
        assert max(map(len, texts(svg))) < 120
        assert "<script" not in svg
        svg.encode("utf-8")


def test_unknown_frames_are_refused(turtles):
    with pytest.raises(LookupException, match="turtle9"):
        TransformPlot(turtles, target="world", source="turtle9")


def test_save_writes_by_suffix(plot, tmp_path):
    for suffix in (".svg", ".png", ".pdf"):
        plot.save(tmp_path / f"plot{suffix}")
    assert (tmp_path / "plot.svg").read_text(encoding="utf-8") == plot.to_svg()
    assert (tmp_path / "plot.png").read_bytes() == plot.to_png()
    assert (tmp_path / "plot.pdf").read_bytes() == plot.to_pdf()
    with pytest.raises(UnknownNameError, match=r"no picture format '\.eps'"):
        plot.save(str(tmp_path / "plot.eps"))


def test_notebooks_show_it(plot):
    assert plot._repr_svg_() == plot.to_svg()
    assert repr(plot) == 'TransformPlot(\'"turtle1" seen from "world"\')'
