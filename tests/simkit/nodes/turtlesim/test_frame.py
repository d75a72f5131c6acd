from __future__ import annotations

import cmath
import math
from collections.abc import Callable

import pytest

from simkit.errors import UnknownNameError
from simkit.nodes.turtlesim import Frame, TurtleExistsError, TurtleReading, Velocity

Drive = Callable[..., list[TurtleReading]]


def test_empty_names_count_up_and_skip_what_is_taken(frame: Frame) -> None:
    frame.spawn("turtle2")
    assert [frame.spawn().name, frame.spawn().name] == ["turtle3", "turtle4"]


def test_a_freed_name_is_not_used_again(frame: Frame) -> None:
    frame.spawn()
    frame.kill("turtle2")
    assert frame.spawn().name == "turtle3"


def test_a_taken_name_is_refused(frame: Frame) -> None:
    with pytest.raises(TurtleExistsError, match="'turtle1' is here already"):
        frame.spawn("turtle1")


def test_kill_leaves_the_trail(frame: Frame, drive: Drive) -> None:
    drive(frame, 10, Velocity(x=1.0))
    frame.kill("turtle1")
    assert frame.turtles == ()
    assert len(frame.paper.strokes) == 1


def test_killing_nobody_names_who_is_there(frame: Frame) -> None:
    with pytest.raises(UnknownNameError, match="did you mean 'turtle1'"):
        frame.kill("turtel1")


def test_reset_starts_over(frame: Frame, drive: Drive) -> None:
    frame.spawn("zoe", x=1, y=1)
    drive(frame, 10, Velocity(x=1.0))
    frame.reset((1, 2, 3))
    assert [turtle.name for turtle in frame.turtles] == ["turtle1"]
    assert frame.turtle("turtle1").pose.x == pytest.approx(5.5444446)
    assert frame.paper.strokes == ()
    assert frame.paper.background == (1, 2, 3)
    assert frame.spawn().name == "turtle2"


def test_turtles_are_updated_in_the_order_of_their_names(frame: Frame) -> None:
    for name in ("turtle2", "zoe", "ann"):
        frame.spawn(name)
    for _ in range(9):
        frame.spawn()
    names = [turtle.name for turtle, _ in frame.update(0)]
    assert names == sorted(names)
    assert names[:4] == ["ann", "turtle1", "turtle10", "turtle11"]


def test_the_earlier_name_draws_first(frame: Frame) -> None:
    # Both jump to the same place in one update: zoe is drawn last, so her colour is on top.
    for name, color in (("ann", (255, 0, 0)), ("zoe", (0, 255, 0))):
        turtle = frame.spawn(name, x=2, y=2)
        turtle.pen = type(turtle.pen)(color=color, width=9)
        turtle.teleport_absolute(4.0, 4.0, theta=0.0)
    colors = {turtle.name: reading.color for turtle, reading in frame.update(0)}
    assert colors["ann"] == (255, 0, 0)
    assert colors["zoe"] == (0, 255, 0)
    assert frame.paper.color_at((3.0, 11.088889 - 3.0)) == (0, 255, 0)


def test_spawn_outside_is_clamped_by_the_next_update(frame: Frame) -> None:
    turtle = frame.spawn("far", x=20.0, y=-1.0)
    assert turtle.pose.x == 20.0
    frame.update(0)
    assert (turtle.pose.x, turtle.pose.y) == pytest.approx((11.088889, 0.0), abs=1e-6)


def test_a_follower_settles_where_theory_says(frame: Frame) -> None:
    # turtle1 on a circle of radius 2 at 1 m/s; turtle2 steers by 4 bearing, 0.5 distance, about 10 Hz.
    # Steady state without delay: the distance d with bearing b = 0.125 rad is 2 / sqrt(2 - 2 sin b).
    follower = frame.spawn(x=4.0, y=2.0)
    leader = frame.turtle("turtle1")
    for tick in range(1, 3600):
        if tick % 6 == 0:
            to_leader = complex(leader.pose.x - follower.pose.x, leader.pose.y - follower.pose.y)
            ahead = to_leader * cmath.rect(1.0, -follower.pose.theta)
            leader.command(Velocity(x=1.0, angular=0.5))
            follower.command(Velocity(x=0.5 * abs(ahead), angular=4.0 * cmath.phase(ahead)))
        frame.update(tick * 16_000_000)
    distance = math.dist((leader.pose.x, leader.pose.y), (follower.pose.x, follower.pose.y))
    assert distance == pytest.approx(2 / math.sqrt(2 - 2 * math.sin(0.125)), abs=0.01)
    assert follower.pose.linear_velocity == pytest.approx(0.754, abs=0.002)
    assert follower.pose.angular_velocity == pytest.approx(0.5, abs=0.001)


def test_everyone_who_ever_was_here_is_remembered(frame: Frame, drive: Drive) -> None:
    frame.spawn("ann")
    drive(frame, 5)
    frame.kill("ann")
    drive(frame, 5)
    frame.reset((0, 0, 0))
    assert [(turtle.name, turtle.gone_ns) for turtle in frame.everyone] == [
        ("turtle1", 160_000_000),
        ("ann", 80_000_000),
        ("turtle1", None),
    ]
    assert frame.turtles == (frame.everyone[-1],)
