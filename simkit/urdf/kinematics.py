"""Where the links of a robot are, for given positions of its joints.

Transforms are (translation [m], rotation as quaternion x, y, z, w), and T_ab takes coordinates in b
to coordinates in a. `T_parent_child = origin * motion`: first the fixed place of the joint, then its
motion about or along its axis.

Source: kdl_parser and robot_state_publisher. As there, axes get unit length, and the numbers of a
rotation have the sign that a rotation matrix gives them. Floating and planar joints do not move:
they stand at their origin, as KDL takes them. An axis of zeros moves nothing either, where KDL
computes NaN.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from simkit.errors import UnknownNameError
from simkit.geometry import (
    ORIGIN,
    Transform,
    Vector,
    canonical,
    multiply,
    quaternion_from_axis,
    quaternion_from_rpy,
    rotate,
)
from simkit.urdf.loader import UrdfError
from simkit.urdf.model import Joint, JointType, Robot
from simkit.urdf.urdfdom.tree import children_by_link


def joint_transform(joint: Joint, position: float) -> Transform:
    """T_parent_child of a joint.

    Args:
        joint: The joint.
        position: Where it stands [rad or m]; without meaning for one that does not move.

    Returns:
        The transform; made of NaN if the position is not finite.
    """
    position = position if math.isfinite(position) else math.nan
    (x, y, z), rotation = joint.origin.xyz, quaternion_from_rpy(joint.origin.rpy)
    if joint.type is JointType.PRISMATIC:
        along = _unit(joint.axis)
        dx, dy, dz = rotate(
            rotation, (along[0] * position, along[1] * position, along[2] * position)
        )
        return Transform((x + dx, y + dy, z + dz), canonical(rotation))
    if joint.type in (JointType.REVOLUTE, JointType.CONTINUOUS):
        rotation = multiply(rotation, quaternion_from_axis(_unit(joint.axis), position))
    return Transform((x, y, z), canonical(rotation))


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
) -> dict[str, Transform]:
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
    found = {robot.root: Transform()}
    waiting = [robot.root]
    while waiting:
        link = waiting.pop()
        for joint in below.get(link, ()):
            found[joint.child] = (
                found[link] @ joint_transform(joint, where[joint.name])
            ).normalised()
            waiting.append(joint.child)
    if frame is None or frame == robot.root:
        return found
    if frame not in found:
        raise UnknownNameError("link", frame, found)
    back = found[frame].inverse()
    return {link: back @ transform for link, transform in found.items()}


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


def _unit(axis: Vector) -> Vector:
    length = math.hypot(*axis)
    return (axis[0] / length, axis[1] / length, axis[2] / length) if length > 0.0 else ORIGIN
