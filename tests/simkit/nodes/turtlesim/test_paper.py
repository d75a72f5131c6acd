from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from simkit.nodes.turtlesim import Frame, Paper, Pen, TurtleReading, Velocity

Drive = Callable[..., list[TurtleReading]]
BACKGROUND = (69, 86, 255)
PEN = (179, 184, 255)


def test_a_drive_is_one_stroke_of_its_length(frame: Frame, drive: Drive) -> None:
    drive(frame, 125, Velocity(x=1.0, angular=0.5))
    (stroke,) = frame.paper.strokes
    assert stroke.turtle == "turtle1"
    assert stroke.pen == Pen()
    assert len(stroke.points) == 126
    assert stroke.length == pytest.approx(125 * 0.016, abs=1e-9)


def test_a_lifted_pen_leaves_a_gap(frame: Frame, drive: Drive) -> None:
    turtle = frame.turtle("turtle1")
    drive(frame, 10, Velocity(x=1.0))
    turtle.pen = turtle.pen.lifted()
    drive(frame, 10, Velocity(x=1.0))
    turtle.pen = Pen()
    drive(frame, 10, Velocity(x=1.0))
    first, second = frame.paper.strokes
    assert first.points[-1][0] == pytest.approx(5.5444446 + 0.16, abs=1e-6)
    assert second.points[0][0] == pytest.approx(5.5444446 + 0.32, abs=1e-6)


def test_another_pen_begins_another_stroke_where_the_last_ended(frame: Frame, drive: Drive) -> None:
    drive(frame, 10, Velocity(x=1.0))
    frame.turtle("turtle1").pen = Pen(color=(1, 2, 3), width=7)
    drive(frame, 10, Velocity(x=1.0))
    first, second = frame.paper.strokes
    assert first.points[-1] == second.points[0]
    assert second.pen == Pen(color=(1, 2, 3), width=7)


def test_two_turtles_draw_a_stroke_each(frame: Frame, drive: Drive) -> None:
    frame.spawn("ann", x=2, y=2)
    for _ in range(20):
        frame.turtle("ann").command(Velocity(x=0.5))
        drive(frame, 1, Velocity(x=1.0))
    assert [(stroke.turtle, len(stroke.points)) for stroke in frame.paper.strokes] == [
        ("ann", 21),
        ("turtle1", 21),
    ]


def test_the_sensor_sees_background_then_its_own_trail(frame: Frame, drive: Drive) -> None:
    assert drive(frame, 1)[0].color == BACKGROUND
    readings = drive(frame, 20, Velocity(x=1.0))
    assert readings[0].color == BACKGROUND  # this update's line is drawn after the reading
    assert {reading.color for reading in readings[3:]} == {PEN}


def test_the_sensor_sees_background_without_a_pen(frame: Frame, drive: Drive) -> None:
    turtle = frame.turtle("turtle1")
    turtle.pen = turtle.pen.lifted()
    assert {reading.color for reading in drive(frame, 20, Velocity(x=1.0))} == {BACKGROUND}


@pytest.mark.parametrize("degrees", range(0, 360, 15))
@pytest.mark.parametrize("width", [1, 2, 3, 10])
def test_pixels_of_a_line_are_those_within_half_its_width(width: int, degrees: int) -> None:
    paper = Paper()
    angle = math.radians(degrees)
    along, across = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
    middle, half = (5.5003, 5.4997), 2.0

    def at(ahead: float, aside: float) -> tuple[float, float]:
        x, y = (m + ahead * u + aside * n for m, u, n in zip(middle, along, across, strict=True))
        return (x, y)

    paper.draw_line(at(-half, 0), at(half, 0), turtle="ann", pen=Pen(width=width))
    # The colour is that of the nearest pixel; its centre is up to 0.71 px from the point asked for.
    inside, outside = width / 2 - 0.72, width / 2 + 0.72
    for step in range(-20, 21):
        ahead = half * step / 20
        assert paper.color_at(at(ahead, 0)) == PEN or width < 2
        if inside > 0:
            assert paper.color_at(at(ahead, inside / 45)) == PEN
        assert paper.color_at(at(ahead, outside / 45)) == BACKGROUND
        assert paper.color_at(at(ahead, -outside / 45)) == BACKGROUND
    for end in (-1, 1):
        assert paper.color_at(at(end * (half + outside / 45), 0)) == BACKGROUND


def test_an_axis_parallel_line_is_exactly_as_wide_as_its_pen() -> None:
    paper = Paper()
    paper.draw_line((1.0, 5.0), (9.0, 5.0), turtle="ann", pen=Pen(width=4))
    column = [paper.color_at((5.0, row / 45)) for row in range(500)]
    assert column.count(PEN) == 4
    row = [paper.color_at((column / 45, 5.0)) for column in range(500)]
    assert row.count(PEN) == 8 * 45 + 4


def test_the_newest_line_is_on_top() -> None:
    paper = Paper()
    for color in ((255, 0, 0), (0, 255, 0)):
        paper.draw_line((1.0, 5.0), (9.0, 5.0), turtle="ann", pen=Pen(color=color))
    assert paper.color_at((5.0, 5.0)) == (0, 255, 0)


def test_clear_takes_strokes_and_pixels_and_a_new_colour() -> None:
    paper = Paper()
    paper.draw_line((1.0, 5.0), (9.0, 5.0), turtle="ann", pen=Pen())
    paper.clear((9, 9, 9))
    assert paper.strokes == ()
    assert paper.color_at((5.0, 5.0)) == (9, 9, 9)


def test_lines_beyond_the_window_and_to_nowhere_are_harmless() -> None:
    paper = Paper()
    paper.draw_line((5.0, 5.0), (1e37, -1e37), turtle="ann", pen=Pen(width=255))
    paper.draw_line((5.0, 5.0), (math.nan, 5.0), turtle="ann", pen=Pen())
    assert len(paper.strokes) == 1
    assert paper.color_at((math.nan, 5.0)) == BACKGROUND


def test_strokes_know_when_they_were_drawn(frame: Frame, drive: Drive) -> None:
    drive(frame, 3, Velocity(x=1.0))
    (stroke,) = frame.paper.strokes
    assert stroke.times_ns == (16_000_000, 16_000_000, 32_000_000, 48_000_000)
    assert len(stroke.times_ns) == len(stroke.points)


def test_what_was_cleared_away_is_kept_with_its_time(frame: Frame, drive: Drive) -> None:
    drive(frame, 3, Velocity(x=1.0))
    frame.paper.clear((1, 2, 3))
    drive(frame, 2, Velocity(x=1.0))
    old, new = frame.paper.sheets
    assert (old.from_ns, new.from_ns) == (0, 48_000_000)
    assert (old.background, new.background) == (BACKGROUND, (1, 2, 3))
    assert [len(sheet.strokes) for sheet in (old, new)] == [1, 1]
    assert new.strokes == frame.paper.strokes
    assert new.strokes[0].times_ns[0] == 64_000_000
