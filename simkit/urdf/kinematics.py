"""Where the links of a robot are, for given positions of its joints.

Transforms are (translation [m], rotation as quaternion x, y, z, w), and T_ab takes coordinates in b
to coordinates in a. `T_parent_child = origin * motion`: first the fixed place of the joint, then its
motion about or along its axis.

Source: kdl_parser and robot_state_publisher. As there, axes get unit length, and the numbers of a
rotation have the sign that a rotation matrix gives them. Floating and planar joints do not move:
they stand at their origin, as KDL takes them. An axis of zeros moves nothing either, where KDL
computes numbers that are none.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from simkit.errors import UnknownNameError
from simkit.geometry import (
    IDENTITY,
    ORIGIN,
    Quaternion,
    Vector,
    canonical,
    conjugate,
    multiply,
    rotate,
)
from simkit.urdf.loading import UrdfError
from simkit.urdf.model import Joint, JointType, Pose, Robot
from simkit.urdf.urdfdom.tree import children_by_link


class Placement(NamedTuple):
    """T_ab: where a frame b is in a frame a."""

    translation: Vector
    """Origin of b in a [m]."""
    rotation: Quaternion
    """Orientation of b in a, xyzw."""


def pose_transform(pose: Pose) -> Placement:
    """T_ab of a frame b that stands at a pose in a frame a."""
    return Placement(pose.xyz, canonical(_rpy_quaternion(pose.rpy)))


def joint_transform(joint: Joint, position: float) -> Placement:
    """T_parent_child of a joint.

    Args:
        joint: The joint.
        position: Where it stands [rad or m]; without meaning for one that does not move.

    Returns:
        The transform; made of NaN if the position is not finite.
    """
    position = position if math.isfinite(position) else math.nan
    (x, y, z), rotation = joint.origin.xyz, _rpy_quaternion(joint.origin.rpy)
    if joint.type is JointType.PRISMATIC:
        dx, dy, dz = rotate(rotation, _scaled(_unit(joint.axis), position))
        return Placement((x + dx, y + dy, z + dz), canonical(rotation))
    if joint.type in (JointType.REVOLUTE, JointType.CONTINUOUS):
        rotation = multiply(rotation, _turn(_unit(joint.axis), position))
    return Placement((x, y, z), canonical(rotation))


def joint_positions(robot: Robot, positions: Mapping[str, float]) -> dict[str, float]:
    """The position of every joint [rad or m]: as given, else that of the joint it mimics, else 0.

    Args:
        robot: The robot.
        positions: By joint name [rad or m]. One that is given for a mimic joint counts.

    Raises:
        UnknownNameError: The robot has no joint of a name.
        UrdfError: Joints mimic each other in a circle.
    """
    for name in positions:
        if name not in robot.joints:
            raise UnknownNameError("joint", name, robot.joints)
    found = {name: float(position) for name, position in positions.items()}
    for name in robot.joints:
        _follow(robot, name, found)
    return {name: found[name] for name in robot.joints}


def forward_kinematics(
    robot: Robot, positions: Mapping[str, float], *, frame: str | None = None
) -> dict[str, Placement]:
    """Where each link is.

    Args:
        robot: The robot.
        positions: Of joints by name [rad or m]; one that is missing is at 0, or where its mimic tag puts it.
        frame: Link that they are seen from; the root if None.

    Returns:
        T_frame_link of each link that hangs on the root.

    Raises:
        UnknownNameError: The robot has no such joint, or no such link.
        UrdfError: Joints mimic each other in a circle.
    """
    where = joint_positions(robot, positions)
    below = children_by_link(_upper_joints(robot))
    found = {robot.root: Placement(ORIGIN, IDENTITY)}
    waiting = [robot.root]
    while waiting:
        link = waiting.pop()
        for joint in below.get(link, ()):
            found[joint.child] = compose(found[link], joint_transform(joint, where[joint.name]))
            waiting.append(joint.child)
    if frame is None or frame == robot.root:
        return found
    if frame not in found:
        raise UnknownNameError("link", frame, found)
    back = inverse(found[frame])
    return {link: compose(back, placement) for link, placement in found.items()}


def compose(outer: Placement, inner: Placement) -> Placement:
    """T_ac = T_ab T_bc, for T_ab = `outer` and T_bc = `inner`."""
    x, y, z = rotate(outer.rotation, inner.translation)
    tx, ty, tz = outer.translation
    return Placement(
        (tx + x, ty + y, tz + z), _normalised(multiply(outer.rotation, inner.rotation))
    )


def inverse(placement: Placement) -> Placement:
    """T_ba of T_ab."""
    back = conjugate(placement.rotation)
    return Placement(rotate(back, _scaled(placement.translation, -1.0)), back)


def _upper_joints(robot: Robot) -> dict[str, Joint]:
    """One joint above each link: of several, urdfdom keeps the last one by name."""
    last = {robot.joints[name].child: name for name in sorted(robot.joints)}
    return {name: robot.joints[name] for name in last.values()}


def _follow(robot: Robot, name: str, found: dict[str, float]) -> None:
    """Fill in the position of a joint, and of those that it mimics."""
    way: list[str] = []
    while name in robot.joints and name not in found:
        mimic = robot.joints[name].mimic
        way.append(name)
        if mimic is None:
            break
        name = mimic.joint
        if name in way:
            circle = " -> ".join([*way[way.index(name) :], name])
            raise UrdfError(f"{robot.name}: these joints mimic each other in a circle: {circle}")
    for follower in reversed(way):
        mimic = robot.joints[follower].mimic
        if mimic is None:
            found[follower] = 0.0
        else:
            found[follower] = mimic.multiplier * found.get(mimic.joint, 0.0) + mimic.offset


def _rpy_quaternion(rpy: Vector) -> Quaternion:
    """Rz Ry Rx of roll, pitch, yaw about fixed axes."""
    sin_r, sin_p, sin_y = (math.sin(angle / 2.0) for angle in rpy)
    cos_r, cos_p, cos_y = (math.cos(angle / 2.0) for angle in rpy)
    return (
        sin_r * cos_p * cos_y - cos_r * sin_p * sin_y,
        cos_r * sin_p * cos_y + sin_r * cos_p * sin_y,
        cos_r * cos_p * sin_y - sin_r * sin_p * cos_y,
        cos_r * cos_p * cos_y + sin_r * sin_p * sin_y,
    )


def _turn(axis: Vector, angle: float) -> Quaternion:
    x, y, z = _scaled(axis, math.sin(angle / 2.0))
    return (x, y, z, math.cos(angle / 2.0)) if any(axis) else IDENTITY


def _unit(axis: Vector) -> Vector:
    length = math.hypot(*axis)
    return (axis[0] / length, axis[1] / length, axis[2] / length) if length > 0.0 else ORIGIN


def _scaled(v: Vector, factor: float) -> Vector:
    return (v[0] * factor, v[1] * factor, v[2] * factor)


def _normalised(q: Quaternion) -> Quaternion:
    """The same rotation at unit length: so a long chain does not drift."""
    x, y, z, w = q
    length = math.sqrt(x * x + y * y + z * z + w * w)
    return (x / length, y / length, z / length, w / length)
