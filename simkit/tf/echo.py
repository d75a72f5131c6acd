"""Where one frame is in another: as `rosrun tf tf_echo` prints it, and in one sentence."""

from __future__ import annotations

import math

from simkit.geometry import Transform, canonical, roll_pitch_yaw
from simkit.msgs import Time
from simkit.tf.admission import without_slash
from simkit.tf.buffer import Buffer
from simkit.tf.errors import TransformException
from simkit.tf.path import StampedTransform


def echo_text(buffer: Buffer, source: str, target: str, now: Time, precision: int = 3) -> str:
    """One block of tf_echo's output, with the line break at its end.

    `tf_echo A B` prints the pose of B seen from A: what tf_echo calls the source is what a
    lookup calls the target.

    Args:
        buffer: The transforms.
        source: First argument of tf_echo (A); one leading slash is dropped.
        target: Second argument of tf_echo (B); one leading slash is dropped.
        now: Current time, shown when the lookup fails.
        precision: Digits after the point.

    Source:
        tf `tf_echo.cpp`; the quaternion has unit length and the sign of a matrix' quaternion.
    """
    a, b = without_slash(source), without_slash(target)
    try:
        found = buffer.core.lookup(a, b)
    except TransformException as error:
        return (
            f"Failure at {now.secs}.{now.nsecs:09d}\n"
            f"Exception thrown:{error}\n"
            "The current list of frames is:\n"
            f"{buffer.all_frames_as_string()}\n"
        )
    angles = roll_pitch_yaw(found.rotation)
    degrees = tuple(math.degrees(angle) for angle in angles)
    indent = " " * 12
    return (
        f"At time {found.stamp / 1e9:.{precision}f}\n"
        f"- Translation: {_row(found.translation, precision)}\n"
        f"- Rotation: in Quaternion {_row(canonical(found.rotation), precision)}\n"
        f"{indent}in RPY (radian) {_row(angles, precision)}\n"
        f"{indent}in RPY (degree) {_row(degrees, precision)}\n"
    )


def _row(values: tuple[float, ...], precision: int) -> str:
    return "[" + ", ".join(f"{v:.{precision}f}" for v in values) + "]"


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
