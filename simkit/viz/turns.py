"""Turns that point somewhere."""

from __future__ import annotations

import math

from simkit.tf.transform import Quaternion, Vector


def turn_from_z(direction: Vector) -> Quaternion:
    """A turn, as quaternion xyzw, that takes z to a direction of unit length."""
    x, y, z = direction
    if z < -0.999999:
        return (1.0, 0.0, 0.0, 0.0)
    norm = math.sqrt(2.0 * (1.0 + z))
    return (-y / norm, x / norm, 0.0, norm / 2.0)
