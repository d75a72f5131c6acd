from __future__ import annotations

import math
from dataclasses import dataclass

import pytest

from oracles import pursuit
from oracles.turtles import TurtlePose, last_before
from simkit import Simulation


@dataclass
class Pose:
    x: float
    y: float
    theta: float = 0.0


def test_a_place_to_the_left() -> None:
    turtle, place = Pose(1, 1, math.pi / 2), Pose(0, 1)
    assert pursuit.gap(turtle, place) == pytest.approx(1)
    assert pursuit.bearing(turtle, place) == pytest.approx(math.pi / 2)
    assert pursuit.seen_from(turtle, place) == pytest.approx((0, 1))


def test_seen_from_is_the_inverse_of_ahead() -> None:
    turtle = Pose(3, -2, 0.7)
    x, y = pursuit.ahead_of(turtle, 2.5)
    assert pursuit.seen_from(turtle, Pose(x, y)) == pytest.approx((2.5, 0))


def test_most_of_the_time() -> None:
    turtle = Pose(0, 0)
    seen = [(Pose(1, 0), turtle)] * 95 + [(Pose(-1, 0), turtle)] * 5
    assert pursuit.usual_bearing(seen) == 0
    assert pursuit.usual_bearing(seen[40:]) == 0
    assert pursuit.usual_bearing(seen[60:]) > 3


def test_the_last_pose_before_a_time() -> None:
    poses = [TurtlePose(time=time, x=time, y=0, theta=0) for time in (1.0, 2.0)]
    assert last_before(poses, 0.5) is None
    assert last_before(poses, 1.0) == poses[0]
    assert last_before(poses, 9.0) == poses[1]


@pytest.fixture
def turtles() -> Simulation:
    sim = Simulation(screen=None)
    sim.rosrun("turtlesim", "turtlesim_node")
    sim.call("/spawn", 4, 2, 0, "turtle2")
    sim.run(0.1)
    return sim


def test_coming_near(turtles: Simulation) -> None:
    assert pursuit.come_near(turtles, 1.0, timeout=0.5) == pytest.approx(3.865, abs=0.01)
    turtles.call("/turtle2/teleport_absolute", 5, 5, 0)
    turtles.run(0.1)
    assert pursuit.come_near(turtles, 1.0, timeout=0.5) < 1.0


def test_how_late_a_turtle_sets_out(turtles: Simulation) -> None:
    assert pursuit.reaction_time(turtles, (9, 9, 0), timeout=1.0) is None
    release = pursuit.drive(turtles, speed=1.0, turn_rate=0.0, turtle="turtle2")
    late = pursuit.reaction_time(turtles, (1, 1, 0), timeout=1.0)
    release()
    assert late == pytest.approx(0.16, abs=0.03)


def test_a_turtle_comes_to_rest(turtles: Simulation) -> None:
    pursuit.drive(turtles, speed=1.0, turn_rate=0.0, turtle="turtle2")()
    turtles.run(0.1)
    begin = turtles.now
    pursuit.come_to_rest(turtles, timeout=5.0)
    assert 0.8 < (turtles.now - begin).to_sec() < 1.2
    one, two = pursuit.samples(turtles, 0.2)[-1]
    assert (one.linear_velocity, two.linear_velocity) == (0, 0)
