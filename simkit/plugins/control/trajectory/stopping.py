"""How joints come to rest when a controller starts, a goal is cancelled, or an empty command comes.

Source: `hold_trajectory_builder.h` and `stop_trajectory_builder.h` of joint_trajectory_controller.
"""

from __future__ import annotations

from simkit.plugins.control.trajectory.segment import Trajectory, segment_between
from simkit.plugins.control.trajectory.spline import Knot, State


def hold(position: float, time_ns: int) -> Trajectory:
    """Stay at a position [rad or m] from a time on [ns]."""
    here = State(position).knot()
    return (segment_between(time_ns, here, time_ns, here),)


def stop(state: State, time_ns: int, duration_ns: int) -> Trajectory:
    """Come to rest in a time.

    It ends in the middle of the motion that would come back to where it starts, with the velocity
    turned round, in twice the time: there the velocity is 0.

    Args:
        state: Where the joint is meant to be, and how it moves.
        time_ns: When it begins to stop [ns].
        duration_ns: How long it takes; more than 0 [ns].
    """
    start = Knot(position=state.position, velocity=state.velocity, acceleration=0.0)
    back = Knot(position=state.position, velocity=-state.velocity, acceleration=0.0)
    there_and_back = segment_between(time_ns, start, time_ns + 2 * duration_ns, back)
    end_ns = time_ns + duration_ns
    middle = there_and_back.sample(end_ns)
    return (segment_between(time_ns, start, end_ns, middle.knot()),)
