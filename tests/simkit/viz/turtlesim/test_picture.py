from __future__ import annotations

import io
import math
import xml.etree.ElementTree as ET
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest

from simkit.errors import UnknownNameError
from simkit.nodes.turtlesim import Frame, Pen, TurtleReading, Velocity
from simkit.viz.turtlesim.picture import Picture

Drive = Callable[..., list[TurtleReading]]
SVG = "{http://www.w3.org/2000/svg}"
BACKGROUND = (69, 86, 255)
PEN = (179, 184, 255)


def trails(svg: str) -> list[list[tuple[float, float]]]:
    """Points of each polyline that is not part of a turtle."""
    found = []
    for line in ET.fromstring(svg).findall(f"{SVG}polyline"):
        pairs = (pair.split(",") for pair in line.attrib["points"].split())
        found.append([(float(x), float(y)) for x, y in pairs])
    return found


def length(points: list[tuple[float, float]]) -> float:
    return math.fsum(math.dist(a, b) for a, b in pairwise(points))


def pixels(png: bytes) -> np.ndarray:
    image = matplotlib.image.imread(io.BytesIO(png), format="png")
    return np.rint(image[:, :, :3] * 255).astype(int)


def test_svg_has_a_title_and_a_group_for_each_turtle(frame: Frame) -> None:
    frame.spawn("ann", x=1, y=2, theta=math.pi / 2)
    root = ET.fromstring(Picture(frame).to_svg())
    assert root.attrib["viewBox"] == "0 0 500 500"
    assert root.attrib["role"] == "img"
    assert root[0].tag == f"{SVG}title"
    assert root[0].text == "turtlesim with 2 turtles"
    groups = root.findall(f"{SVG}g")
    titles = [group.findtext(f"{SVG}title") for group in groups]
    assert titles == [
        "ann at x = 1.00 m, y = 2.00 m, heading 90 degrees.",
        "turtle1 at x = 5.54 m, y = 5.54 m, heading 0 degrees.",
    ]
    assert groups[0].attrib["transform"] == "translate(45.5 409.5) rotate(-90)"
    assert groups[1].attrib["transform"] == "translate(250 250) rotate(0)"


def test_names_are_drawn_when_asked_for(frame: Frame) -> None:
    assert "<text" not in Picture(frame).to_svg()
    root = ET.fromstring(Picture(frame, names=True).to_svg())
    assert [text.text for text in root.findall(f"{SVG}text")] == ["turtle1"]


def test_a_straight_trail_is_two_points_and_45_pixels_a_metre(frame: Frame, drive: Drive) -> None:
    drive(frame, 250, Velocity(x=1.0))
    (points,) = trails(Picture(frame).to_svg())
    assert points == [(250.0, 250.0), (430.0, 250.0)]


def test_a_circle_keeps_its_length_in_a_small_svg(frame: Frame, drive: Drive) -> None:
    drive(frame, 785, Velocity(x=1.0, angular=0.5))
    svg = Picture(frame).to_svg()
    (points,) = trails(svg)
    assert length(points) == pytest.approx(785 * 0.016 * 45, rel=1e-3)
    assert len(svg) < 6000


def test_pens_colour_and_width_are_drawn(frame: Frame, drive: Drive) -> None:
    for color, width in (((255, 0, 0), 1), ((0, 128, 255), 9)):
        frame.turtle("turtle1").pen = Pen(color=color, width=width)
        drive(frame, 20, Velocity(x=1.0))
    root = ET.fromstring(Picture(frame).to_svg())
    lines = root.findall(f"{SVG}polyline")
    assert [line.attrib["stroke"] for line in lines] == ["#ff0000", "#0080ff"]
    assert [line.attrib["stroke-width"] for line in lines] == ["1", "9"]


def test_turtles_have_distinct_colours(frame: Frame) -> None:
    frame.spawn()
    first, second = ET.fromstring(Picture(frame).to_svg()).findall(f"{SVG}g")
    fills = [
        {part.attrib["fill"] for part in group if "fill" in part.attrib}
        for group in (first, second)
    ]
    assert fills[0] & fills[1] == {"none"}


def test_equal_runs_give_equal_bytes(drive: Drive) -> None:
    def picture() -> Picture:
        frame = Frame()
        frame.spawn()
        drive(frame, 100, Velocity(x=1.0, angular=1.0))
        return Picture(frame, names=True)

    assert picture().to_svg() == picture().to_svg()
    assert picture().to_png() == picture().to_png()


def test_a_picture_does_not_change_afterwards(frame: Frame, drive: Drive) -> None:
    picture = Picture(frame)
    before = picture.to_svg()
    drive(frame, 50, Velocity(x=1.0))
    assert picture.to_svg() == before
    assert Picture(frame).to_svg() != before


def test_png_has_the_size_and_the_colours_of_the_window(frame: Frame, drive: Drive) -> None:
    drive(frame, 250, Velocity(x=1.0))
    image = pixels(Picture(frame).to_png())
    assert image.shape == (500, 500, 3)
    assert tuple(image[10, 10]) == BACKGROUND
    assert tuple(image[250, 300]) == PEN
    assert tuple(image[230, 300]) == BACKGROUND
    turtle = image[245:255, 425:435].reshape(-1, 3)
    assert BACKGROUND not in {tuple(pixel) for pixel in turtle}
    assert pixels(Picture(frame).to_png(scale=2)).shape == (1000, 1000, 3)


def test_png_and_sensor_agree_on_what_is_drawn(frame: Frame, drive: Drive) -> None:
    frame.turtle("turtle1").pen = Pen(width=6)
    drive(frame, 300, Velocity(x=1.0, angular=0.8))
    frame.kill("turtle1")
    image = pixels(Picture(frame).to_png())
    drawn = np.linalg.norm(image - np.array(BACKGROUND), axis=2) > 70
    seen = np.array(
        [
            [frame.paper.color_at((column / 45, row / 45)) == PEN for column in range(100, 420)]
            for row in range(100, 420)
        ]
    )
    differing = np.count_nonzero(drawn[100:420, 100:420] != seen)
    # The picture is smooth and has round ends, so only pixels of the border may differ.
    assert seen.sum() > 1000
    assert differing < 0.06 * seen.sum()


def test_save_writes_by_suffix(frame: Frame, tmp_path: Path) -> None:
    picture = Picture(frame)
    picture.save(tmp_path / "a.svg")
    picture.save(str(tmp_path / "a.PNG"))
    assert (tmp_path / "a.svg").read_text(encoding="utf-8") == picture.to_svg()
    assert (tmp_path / "a.PNG").read_bytes().startswith(b"\x89PNG")
    with pytest.raises(UnknownNameError, match=r"no picture format '\.jpg'.*\.png, \.svg"):
        picture.save(tmp_path / "a.jpg")


def test_notebooks_find_both_forms(frame: Frame) -> None:
    picture = Picture(frame)
    assert picture._repr_svg_() == picture.to_svg()
    assert picture._repr_png_() == picture.to_png()


def test_odd_names_and_lost_turtles_still_give_a_picture(frame: Frame, drive: Drive) -> None:
    frame.spawn('<&"\x00>', x=1, y=1)
    frame.turtle("turtle1").teleport_absolute(math.nan, 1.0, theta=0.0)
    drive(frame, 1)
    picture = Picture(frame, names=True)
    root = ET.fromstring(picture.to_svg())
    assert root.findtext(f"{SVG}text") == '<&">'
    assert root[0].text == "turtlesim with 1 turtle"
    assert pixels(picture.to_png()).shape == (500, 500, 3)


def test_an_empty_window_says_so(frame: Frame) -> None:
    frame.kill("turtle1")
    root = ET.fromstring(Picture(frame).to_svg())
    assert root.findtext(f"{SVG}desc") == "The window is empty."
