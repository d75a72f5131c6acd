"""What a model did in the last looks."""

from __future__ import annotations

import math

import pytest

from simkit.gazebo.watchers.motion import Moment, means, signed, turn_between


def moment(x: float, y: float, yaw: float, command: tuple[float, float] = (0.0, 0.0)) -> Moment:
    return Moment(
        place=(x, y, 0.1), yaw=yaw, speed=0.0, spin=0.0, command=command, rolled=(0.0, 0.0)
    )


def test_on_a_circle_the_speed_is_that_along_it():
    radius, spin = 0.5, 1.2
    angles = [0.1 * spin * look for look in range(9)]
    found = means(
        [moment(radius * math.sin(a), -radius * math.cos(a), a, (0.6, 1.2)) for a in angles]
    )
    assert found.command == pytest.approx((0.6, 1.2))
    assert found.moved == pytest.approx((radius * spin, spin), rel=1e-3)


def test_backward_is_negative():
    found = means([moment(-0.02 * look, 0.0, 0.0) for look in range(6)])
    assert found.moved == pytest.approx((-0.2, 0.0))


def test_a_turn_goes_the_short_way():
    assert turn_between(3.0, -3.0) == pytest.approx(math.tau - 6.0)
    assert turn_between(-3.0, 3.0) == pytest.approx(6.0 - math.tau)


@pytest.mark.parametrize(("speed", "text"), [(0.5, "+0.50"), (-0.5, "-0.50"), (-0.001, "+0.00")])
def test_speeds_have_a_sign(speed, text):
    assert signed(speed) == text


def test_it_forgets_what_was_before_a_jump(watched):
    spawned = watched.car()
    motion = watched.watch._scenes["car"].motion
    watched.run(1.0)
    assert len(motion.last(10)) == 11
    spawned.model.set_pose(watched.at(0.3, 0.0, 0.1))
    watched.run(0.3)
    assert motion.last(3) == []
    assert {round(one.place[0], 3) for one in motion.last(2)} == {0.3}
