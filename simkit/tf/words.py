"""A pose in words, against the oldest confusion of TF: which frame is seen from which."""

from __future__ import annotations

import math

from simkit.geometry import Transform, roll_pitch_yaw
from simkit.tf.transform import StampedTransform

_NOTHING = 0.0005
"Below this [m, rad] nothing is said."


def in_words(target: str, source: str, transform: Transform | StampedTransform) -> str:
    """One sentence for T_ab: where b (source) is, seen from a (target).

    Args:
        target: Frame of the observer: x ahead, y left, z up.
        source: Frame that is observed.
        transform: T_ab.
    """
    roll, pitch, yaw = roll_pitch_yaw(transform.rotation)
    x, y, z = transform.translation
    places = [
        f"{abs(value):.3f} m {positive if value > 0.0 else negative}"
        for value, positive, negative in (
            (x, "ahead", "behind"),
            (y, "left", "right"),
            (z, "up", "down"),
        )
        if abs(value) >= _NOTHING
    ]
    turns = [
        f"{verb} {abs(math.degrees(angle)):.1f}° {positive if angle > 0.0 else negative}"
        for angle, verb, positive, negative in (
            (yaw, "turned", "to the left", "to the right"),
            (pitch, "pitched", "down", "up"),
            (roll, "rolled", "to the right", "to the left"),
        )
        if abs(angle) >= _NOTHING
    ]
    place = ", ".join(places) or "at the same place"
    return f'"{source}" seen from "{target}": {place}; {", ".join(turns) or "not turned"}'
