"""Coming to rest: holding, and the ramp."""

from __future__ import annotations

import pytest

from simkit.plugins.control.trajectory.segment import sample
from simkit.plugins.control.trajectory.spline import State
from simkit.plugins.control.trajectory.stopping import hold, stop

SECOND = 1_000_000_000


def test_to_hold_is_to_stay_for_ever():
    trajectory = hold(0.3, SECOND)
    assert {sample(trajectory, t * SECOND) for t in range(4)} == {State(0.3)}


@pytest.mark.parametrize(("position", "velocity", "duration_s"), [(0.2, 1.0, 1), (-1.0, -0.5, 2)])
def test_a_ramp_begins_as_the_joint_moves_and_ends_at_rest(position, velocity, duration_s):
    trajectory = stop(State(position, velocity), SECOND, duration_s * SECOND)
    begin = sample(trajectory, SECOND)
    assert (begin.position, begin.velocity) == (position, velocity)
    end = sample(trajectory, (1 + duration_s) * SECOND)
    assert end.velocity == pytest.approx(0.0, abs=1e-12)
    # The middle of the quintic from (p, v, 0) to (p, -v, 0) in a time 2 d is 5/8 of v d away.
    assert end.position == pytest.approx(position + 0.625 * velocity * duration_s, abs=1e-12)
    assert sample(trajectory, 9 * SECOND) == State(end.position)


def test_a_joint_at_rest_stays():
    trajectory = stop(State(0.4), 0, SECOND)
    assert {sample(trajectory, t * SECOND // 4).position for t in range(8)} == {0.4}
