from __future__ import annotations

import math

import pytest


def test_it_draws_squares_of_two_metres(bench) -> None:
    window = bench.start("turtlesim_node")
    bench.start("draw_square")
    bench.run(30.0)
    (stroke,) = window.frame.paper.strokes
    xs, ys = zip(*stroke.points, strict=True)
    assert max(xs) - min(xs) == pytest.approx(2.0, abs=0.15)
    assert max(ys) - min(ys) == pytest.approx(2.0, abs=0.15)
    assert min(xs) == pytest.approx(5.544, abs=0.15)
    assert min(ys) == pytest.approx(5.544, abs=0.15)
    assert math.dist(stroke.points[-1], stroke.points[0]) < 3.0


def test_it_resets_the_window_and_reports_its_goals(bench) -> None:
    bench.start("turtlesim_node")
    bench.start("draw_square")
    bench.run(5.0)
    said = bench.said("INFO")
    assert "Resetting turtlesim." in said
    assert "New goal [7.544445 5.544445, 0.000000]" in said
    assert "Reached goal" in said


def test_without_a_turtlesim_it_waits(bench) -> None:
    bench.start("draw_square")
    bench.run(1.0)
    window = bench.start("turtlesim_node")
    bench.run(1.0)
    assert window.frame.turtle("turtle1").pose.linear_velocity == 1.0
