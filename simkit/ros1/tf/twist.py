"""Velocities from two poses."""

from __future__ import annotations

import math

from simkit.geometry import Quaternion, Vector, canonical, conjugate, multiply, rotate
from simkit.tf.buffer_core import BufferCore

_FIRST_TIME = 100_000
"Earliest start of an interval [ns], as 0 would ask for the latest."


def twist_between(
    core: BufferCore,
    tracking: str,
    observation: str,
    reference: str,
    point_frame: str,
    *,
    point: Vector,
    time: int,
    interval: int,
) -> tuple[Vector, Vector]:
    """Velocity of a point that moves with `tracking`, seen from `observation`.

    Args:
        core: The transforms.
        tracking: Frame that moves.
        observation: Frame of the observer.
        reference: Frame in whose axes the result is given.
        point_frame: Frame in which the point is given.
        point: The point [m].
        time: Middle of the interval [ns]; 0 for the latest common time.
        interval: Span over which positions are compared [ns].

    Returns:
        Linear [m/s] and angular [rad/s] velocity.

    Raises:
        TransformException: A lookup at one end of the interval fails.

    Source:
        tf `Transformer::lookupTwist`. Where the point is not the origin of `tracking`, or the
        axes are not those of `observation`, tf's Python rotates by another frame and adds a
        scalar; here the rigid body's formula v + ω x r is used.
    """
    latest = core.latest_common_time(observation, tracking)
    middle = time or latest
    end = min(middle + interval // 2, latest)
    start = max(_FIRST_TIME + interval, end) - interval
    first = core.lookup(observation, tracking, time=start)
    last = core.lookup(observation, tracking, time=end)
    seconds = (end - start) / 1e9
    velocity = _quotient(_difference(last.translation, first.translation), seconds)
    spin = _quotient(_turn(first.rotation, last.rotation), seconds)

    axes = canonical(core.lookup(reference, observation, time=middle).rotation)
    velocity, spin = rotate(axes, velocity), rotate(axes, spin)
    place = core.lookup(reference, point_frame, time=middle).transform.apply(point)
    arm = _difference(place, core.lookup(reference, tracking, time=middle).translation)
    return _sum(velocity, _cross(spin, arm)), spin


def _turn(start: Quaternion, end: Quaternion) -> Vector:
    """Rotation vector [rad], in the observer's axes, of the turn from `start` to `end`."""
    x, y, z, w = canonical(multiply(end, conjugate(start)))
    sine = math.sqrt(x * x + y * y + z * z)
    if sine == 0.0:
        return (0.0, 0.0, 0.0)
    angle = 2.0 * math.atan2(sine, w)
    # More than half a turn is a turn the other way.
    scale = (angle - 2.0 * math.pi if angle > math.pi else angle) / sine
    return (scale * x, scale * y, scale * z)


def _difference(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _sum(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def _quotient(a: Vector, divisor: float) -> Vector:
    return (a[0] / divisor, a[1] / divisor, a[2] / divisor)


def _cross(a: Vector, b: Vector) -> Vector:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )
