from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from simkit.viz.draw.drawing import Area, Curve, Drawing, Group, Label, Polyline, RoundedBox
from simkit.viz.draw.svg import number, svg_text

SVG = "{http://www.w3.org/2000/svg}"


def drawing(*shapes, title="a title", description="what is seen"):
    return Drawing(
        title=title, description=description, size=(40, 30), background="#ffffff", shapes=shapes
    )


def test_every_shape_becomes_its_element(texts):
    shapes = (
        Polyline(points=((0, 0), (3, 4)), color="#000000", dashed=True),
        Curve(points=((0, 0), (1, 0), (2, 1), (3, 1)), color="#000000"),
        Area(points=((0, 0), (1, 0), (0, 1)), fill="#123456"),
        RoundedBox(corner=(1, 2), size=(3, 4), fill="#123456", radius=1),
        Label(place=(1, 2), text="hello", color="#000000", align="middle", halo="#ffffff"),
    )
    svg = svg_text(drawing(Group(title="all", shapes=shapes)))
    group = ET.fromstring(svg).find(f"{SVG}g")
    tags = [element.tag.removeprefix(SVG) for element in group]
    assert tags == ["title", "polyline", "path", "polygon", "rect", "text"]
    assert group[1].attrib["stroke-dasharray"]
    assert group[2].attrib["d"] == "M0,0 C1,0 2,1 3,1"
    assert group[5].attrib["text-anchor"] == "middle"
    assert texts(svg) == ["hello"]


def test_it_is_described_for_those_who_do_not_see_it():
    root = ET.fromstring(svg_text(drawing()))
    assert root.attrib["role"] == "img"
    assert root.findtext(f"{SVG}title") == "a title"
    assert root.findtext(f"{SVG}desc") == "what is seen"


def test_any_text_is_safe(texts):
    bad = "<script>\x00&\"'\ud800"
    text = Label(place=(0, 0), text=bad, color="#000000")
    svg = svg_text(drawing(text, Group(title=bad, shapes=()), title=bad, description=bad))
    assert texts(svg) == ["<script>\ufffd&\"'\ufffd"]
    svg.encode("utf-8")


@pytest.mark.parametrize(
    ("value", "text"), [(1.0, "1"), (-0.001, "0"), (1.005, "1"), (2.5, "2.5"), (100, "100")]
)
def test_numbers_are_short(value, text):
    assert number(value) == text
