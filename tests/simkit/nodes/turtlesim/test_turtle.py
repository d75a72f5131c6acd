from __future__ import annotations

import math
import struct
from collections.abc import Callable

import pytest

from simkit.nodes.turtlesim import Frame, TurtleReading, Velocity

Drive = Callable[..., list[TurtleReading]]
DT = 0.016
SIDE = 11.088889


def test_turtle1_starts_in_the_centre_in_32_bits(frame: Frame) -> None:
    pose = frame.turtle("turtle1").pose
    assert pose.x == pose.y == pytest.approx(5.544444561, abs=1e-9)
    assert pose.x == struct.unpack("<f", struct.pack("<f", pose.x))[0]
    assert pose.theta == 0.0


def test_straight_ahead_is_speed_times_time(frame: Frame, drive: Drive) -> None:
    last = drive(frame, 100, Velocity(x=1.0))[-1].pose
    assert last.x == pytest.approx(5.5444446 + 100 * DT, abs=1e-6)
    assert last.y == pytest.approx(5.5444446, abs=1e-6)
    assert last.linear_velocity == 1.0


def test_sideways_is_to_the_left_and_speed_is_unsigned(frame: Frame, drive: Drive) -> None:
    last = drive(frame, 10, Velocity(x=-3.0, y=4.0))[-1].pose
    assert (last.x, last.y) == pytest.approx((5.5444446 - 0.48, 5.5444446 + 0.64), abs=1e-6)
    assert last.linear_velocity == 5.0


def test_circle_follows_the_discrete_law(frame: Frame, drive: Drive) -> None:
    # Each update turns first and then moves a chord v dt along the new heading, so the corners lie
    # on a circle of radius v dt / (2 sin(w dt / 2)), and heading k is k w dt.
    v, w = 1.0, 0.5
    radius = v * DT / (2 * math.sin(w * DT / 2))
    assert radius == pytest.approx(v / w, rel=1e-5)
    x0 = y0 = 5.5444446
    for k, reading in enumerate(drive(frame, 700, Velocity(x=v, angular=w)), start=1):
        turned = k * w * DT
        chord = 2 * radius * math.sin(turned / 2)
        direction = (k + 1) * w * DT / 2
        expected = (x0 + chord * math.cos(direction), y0 + chord * math.sin(direction))
        assert (reading.pose.x, reading.pose.y) == pytest.approx(expected, abs=2e-6)
        assert math.remainder(reading.pose.theta - turned, math.tau) == pytest.approx(0, abs=1e-6)
        assert -math.pi - 1e-6 <= reading.pose.theta < math.pi + 1e-6


def test_uses_the_new_heading_for_the_move(frame: Frame, drive: Drive) -> None:
    quarter = Velocity(x=1.0, angular=math.pi / 2 / DT)
    pose = drive(frame, 1, quarter)[-1].pose
    assert (pose.x, pose.y) == pytest.approx((5.5444446, 5.5444446 + DT), abs=1e-6)


def test_without_a_command_nothing_moves(frame: Frame, drive: Drive) -> None:
    readings = drive(frame, 100)
    assert {reading.pose for reading in readings} == {frame.turtle("turtle1").pose}
    assert frame.paper.strokes == ()
    assert len(frame.turtle("turtle1").history) == 1


def test_a_command_lives_for_one_second(frame: Frame, drive: Drive) -> None:
    drive(frame, 1, Velocity(x=2.0))
    readings = drive(frame, 100)
    moving = [reading for reading in readings if reading.pose.linear_velocity > 0]
    # Update 62 after the command is 0.992 s old, update 63 is 1.008 s old.
    assert len(moving) == 62
    assert readings[-1].pose.x == pytest.approx(5.5444446 + 63 * 2.0 * DT, abs=1e-6)


def test_the_last_of_several_commands_counts(frame: Frame, drive: Drive) -> None:
    frame.turtle("turtle1").command(Velocity(x=100.0))
    pose = drive(frame, 1, Velocity(x=1.0))[-1].pose
    assert pose.linear_velocity == 1.0


def test_the_wall_clamps_and_says_from_where(frame: Frame, drive: Drive) -> None:
    readings = drive(frame, 400, Velocity(x=1.0))
    hits = [reading for reading in readings if reading.clamped_from is not None]
    first = hits[0].clamped_from
    assert first is not None
    assert first[0] > SIDE
    assert first[1] == pytest.approx(SIDE / 2, abs=1e-5)
    assert all(hit.pose.x == pytest.approx(SIDE, abs=1e-6) for hit in hits)
    assert len(hits) == 400 - math.floor(SIDE / 2 / DT)


def test_below_the_window_the_reported_y_is_that_of_the_screen(frame: Frame, drive: Drive) -> None:
    frame.turtle("turtle1").teleport_absolute(1.0, -2.0, theta=0.0)
    reading = drive(frame, 1)[0]
    assert reading.clamped_from == pytest.approx((1.0, SIDE + 2.0), abs=1e-5)
    assert (reading.pose.x, reading.pose.y) == pytest.approx((1.0, 0.0), abs=1e-6)


def test_above_the_window_a_teleport_is_clamped_silently(frame: Frame, drive: Drive) -> None:
    frame.turtle("turtle1").teleport_absolute(1.0, 50.0, theta=0.0)
    reading = drive(frame, 1)[0]
    assert reading.clamped_from is None
    assert reading.pose.y == pytest.approx(SIDE, abs=1e-6)


def test_teleports_wait_for_the_update_and_apply_in_order(frame: Frame, drive: Drive) -> None:
    turtle = frame.turtle("turtle1")
    turtle.teleport_absolute(2.0, 3.0, theta=0.0)
    turtle.teleport_relative(1.0, math.pi / 2)
    turtle.teleport_relative(2.0, -math.pi / 2)
    assert turtle.pose.x == pytest.approx(5.5444446)
    pose = drive(frame, 1)[0].pose
    assert (pose.x, pose.y, pose.theta) == pytest.approx((4.0, 4.0, 0.0), abs=1e-6)
    (stroke,) = frame.paper.strokes
    assert len(stroke.points) == 4


def test_a_teleported_heading_is_wrapped_by_the_same_update(frame: Frame, drive: Drive) -> None:
    frame.turtle("turtle1").teleport_absolute(5.0, 5.0, theta=7.0)
    assert drive(frame, 1)[0].pose.theta == pytest.approx(7.0 - math.tau, abs=1e-6)


@pytest.mark.parametrize("value", [math.inf, -math.inf, math.nan, 1e300, -1e300])
def test_impossible_numbers_do_not_stop_the_window(
    frame: Frame, drive: Drive, value: float
) -> None:
    drive(frame, 2, Velocity(x=value))
    drive(frame, 2, Velocity(x=1.0, y=value, angular=value))
    frame.turtle("turtle1").teleport_absolute(value, value, theta=value)
    frame.turtle("turtle1").teleport_relative(value, value)
    drive(frame, 2, Velocity(x=1.0))
    frame.turtle("turtle1").teleport_absolute(3.0, 3.0, theta=0.0)
    pose = drive(frame, 1, Velocity())[0].pose
    assert (pose.x, pose.y, pose.theta) == pytest.approx((3.0, 3.0, 0.0), abs=1e-6)


def test_history_holds_every_change_with_its_time(frame: Frame, drive: Drive) -> None:
    drive(frame, 5)
    readings = drive(frame, 10, Velocity(x=1.0))
    drive(frame, 100, Velocity())
    history = frame.turtle("turtle1").history
    assert [sample.pose for sample in history[1:11]] == [reading.pose for reading in readings]
    assert [sample.time_ns for sample in history[:2]] == [16_000_000, 6 * 16_000_000]
    assert len(history) == 12  # the last one differs by its speed


def test_same_commands_same_values(drive: Drive) -> None:
    def run() -> list[TurtleReading]:
        frame = Frame()
        frame.spawn()
        return drive(frame, 200, Velocity(x=1.3, y=0.2, angular=-0.7))

    assert run() == run()
