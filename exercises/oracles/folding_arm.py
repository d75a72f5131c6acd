"""The arm of the book with an elbow: where its lower arm is, by forward kinematics on paper.

Lower and upper arm lie beside each other, as torso and upper arm do. At angle 0 of the elbow the lower
arm goes on straight.
"""

from __future__ import annotations

import math

from grader.checks.rotations import Point, Rotation, about_y, about_z, dot, times

UPPER = 0.4
"""Length of the upper arm [m]."""
LOWER = 0.3
"""Length of the lower arm [m]."""
BESIDE = -0.1
"""Each link is so far beside the one that carries it, along y [m]."""
_SHOULDER = (0.0, BESIDE, 0.45)
_FOOT = 0.05
"""Height of the torso's foot [m]."""


def elbow_and_tip(hip: float, shoulder: float, elbow: float) -> tuple[Point, Point]:
    """The two ends of the lower arm in the world [m]: the one at the elbow, and the free one.

    Args:
        hip: Angle [rad].
        shoulder: Angle [rad]; 0 is horizontal.
        elbow: Angle [rad]; 0 is straight on.
    """
    torso = about_z(hip)
    upper = times(torso, about_y(math.pi / 2 + shoulder))
    lower = times(upper, about_y(elbow))
    x, y, z = _turned(torso, _SHOULDER)
    joint = _sum((x, y, z + _FOOT), _turned(upper, (0.0, BESIDE, UPPER)))
    return joint, _sum(joint, _turned(lower, (0.0, 0.0, LOWER)))


def middle(ends: tuple[Point, Point]) -> Point:
    """The point between two ends."""
    one, other = ends
    x, y, z = ((a + b) / 2 for a, b in zip(one, other, strict=True))
    return (x, y, z)


def _turned(turn: Rotation, point: Point) -> Point:
    x, y, z = (dot(row, point) for row in turn)
    return (x, y, z)


def _sum(one: Point, other: Point) -> Point:
    x, y, z = (a + b for a, b in zip(one, other, strict=True))
    return (x, y, z)
