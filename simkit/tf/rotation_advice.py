"""What to tell a learner whose quaternion is none."""

from __future__ import annotations

import math

from simkit.geometry import Quaternion
from simkit.tf.admission import NORM_TOLERANCE


def rotation_advice(child: str, rotation: Quaternion) -> str:
    """Sentences about a rotation that is no unit quaternion; empty for one that is.

    Args:
        child: Frame whose orientation it is.
        rotation: What was broadcast, xyzw.
    """
    norm = math.sqrt(sum(c * c for c in rotation))
    if abs(norm * norm - 1.0) < NORM_TOLERANCE:
        return ""
    if math.isnan(norm):
        return f'The rotation of "{child}" contains nan: a division by zero or an empty message?'
    if norm == 0.0:
        return (
            f'The rotation of "{child}" is all zeros, as in a new message; "not turned" is '
            "(0, 0, 0, 1)."
        )
    return (
        f'The rotation of "{child}" has the norm {norm:.3g} instead of 1. If these are angles, '
        "use quaternion_from_euler(roll, pitch, yaw), which gives (x, y, z, w)."
    )
