"""A transform as the programs named static_transform_publisher are given it on their command line."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from simkit.errors import SimkitError
from simkit.geometry import Quaternion, Vector, multiply
from simkit.graph import Node
from simkit.msgs import message_class
from simkit.nodes.tf_tools.numbers import is_number

YPR = ("x", "y", "z", "yaw", "pitch", "roll")
"""Numbers of a transform whose rotation is given as angles."""
XYZW = ("x", "y", "z", "qx", "qy", "qz", "qw")
"""Numbers of a transform whose rotation is given as a quaternion."""


class WrongNumberError(SimkitError):
    """The command line has too few or too many words."""


class BadTransformError(SimkitError):
    """The command line has the right number of words, but they make no transform."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FixedTransform:
    """Where a frame is, for ever."""

    parent: str
    "Frame that the transform is expressed in."
    child: str
    "Frame that is placed."
    translation: Vector
    "Origin of the child in the parent [m]."
    rotation: Quaternion
    "Orientation of the child in the parent, xyzw."
    angles: Vector | None
    "Yaw, pitch and roll [rad] if they were given."

    def message(self) -> Any:
        """The geometry_msgs/TransformStamped, without a stamp."""
        message: Any = message_class("geometry_msgs/TransformStamped")()
        message.header.frame_id, message.child_frame_id = self.parent, self.child
        t, q = message.transform.translation, message.transform.rotation
        t.x, t.y, t.z = self.translation
        q.x, q.y, q.z, q.w = self.rotation
        return message


def parse_transform(words: Sequence[str]) -> FixedTransform:
    """Read `x y z yaw pitch roll parent child` or `x y z qx qy qz qw parent child`.

    Raises:
        WrongNumberError: There are neither 8 nor 9 words.
        BadTransformError: A number is none, or the two frames are the same.
    """
    names = {8: YPR, 9: XYZW}.get(len(words))
    if names is None:
        raise WrongNumberError("not the right number of arguments")
    *numbers, parent, child = words
    for name, number in zip(names, numbers, strict=True):
        if not is_number(number):
            raise BadTransformError(
                f"{name} must be a number, not {number!r}; "
                f"the order is {' '.join(names)} parent child"
            )
    if parent == child:
        raise BadTransformError(
            f"target_frame and source frame are the same ({parent}, {child}) this cannot work"
        )
    x, y, z, *rest = map(float, numbers)
    angles = (rest[0], rest[1], rest[2]) if names is YPR else None
    return FixedTransform(
        parent=parent,
        child=child,
        translation=(x, y, z),
        rotation=_from_angles(*angles) if angles else (rest[0], rest[1], rest[2], rest[3]),
        angles=angles,
    )


def tell_reading(node: Node, transform: FixedTransform) -> None:
    """Say how three angles were read, where the order of a URDF would give another rotation."""
    if transform.angles is None or transform.angles == transform.angles[::-1]:
        return
    yaw, pitch, roll = transform.angles
    node.info(
        f"{transform.child}: read as yaw {yaw:g}, pitch {pitch:g}, roll {roll:g} [rad]; "
        f"the rpy of a URDF counts the other way round and would mean "
        f"yaw {roll:g}, pitch {pitch:g}, roll {yaw:g}"
    )


def _from_angles(yaw: float, pitch: float, roll: float) -> Quaternion:
    """Roll about x, then pitch about y, then yaw about z, all about fixed axes."""
    about_z = (0.0, 0.0, math.sin(yaw / 2.0), math.cos(yaw / 2.0))
    about_y = (0.0, math.sin(pitch / 2.0), 0.0, math.cos(pitch / 2.0))
    about_x = (math.sin(roll / 2.0), 0.0, 0.0, math.cos(roll / 2.0))
    return multiply(about_z, multiply(about_y, about_x))
