"""The tree of a robot as text: links under links, and beside each the joint that it hangs on."""

from __future__ import annotations

import math

from simkit.geometry import Vector
from simkit.urdf.model import Joint, JointType, Pose, Robot
from simkit.urdf.urdfdom.tree import children_by_link

_AXES = {(1.0, 0.0, 0.0): "x", (0.0, 1.0, 0.0): "y", (0.0, 0.0, 1.0): "z"}
_TURNS = (JointType.REVOLUTE, JointType.CONTINUOUS)


def tree_text(robot: Robot) -> str:
    """The links as a tree, with joint, motion and place of each; lengths in m, angles in rad.

    A link that several joints hang somewhere stands below the first of them with all that is below
    it, and again, by name only, below the others.
    """
    rows = _rows(robot)
    moving = sum(joint.moves for joint in robot.joints.values())
    heading = (
        f"{robot.name}: {_count(len(robot.links), 'link')}, {_count(len(robot.joints), 'joint')} "
        f"({moving or 'none'} move{'s' * (moving < 2)})"
    )
    widths = [max(len(row[column]) for row in rows) for column in range(3)]
    lines = [
        "  ".join(cell.ljust(width) for cell, width in zip(row, [*widths, 0], strict=True)).rstrip()
        for row in rows
    ]
    return "\n".join([heading, *lines]) + "\n"


def motion_text(joint: Joint) -> str:
    """How a joint moves, e.g. `revolute about z, -1.57 to 1.57`."""
    kind: str = joint.type.value
    if not joint.moves:
        return kind
    text = f"{kind} {'about' if joint.type in _TURNS else 'along'} {axis_text(joint.axis)}"
    if joint.limit is not None and joint.type is not JointType.CONTINUOUS:
        text += f", {number_text(joint.limit.lower)} to {number_text(joint.limit.upper)}"
    if joint.mimic is not None:
        text += f", follows {joint.mimic.joint}"
    return text


def axis_text(axis: Vector) -> str:
    """An axis: `z`, `-z`, or its three numbers."""
    back = (0.0 - axis[0], 0.0 - axis[1], 0.0 - axis[2])
    return _AXES.get(axis) or ("-" + _AXES[back] if back in _AXES else f"({vector_text(axis)})")


def pose_text(pose: Pose) -> str:
    """Where a pose is, e.g. `at 0 0 0.25, rpy 0 1.5708 0`; nothing for the identity."""
    parts = []
    if any(pose.xyz):
        parts.append(f"at {vector_text(pose.xyz)}")
    if any(pose.rpy):
        parts.append(f"rpy {vector_text(pose.rpy)}")
    return ", ".join(parts)


def vector_text(vector: Vector) -> str:
    """Three numbers with spaces between them."""
    return " ".join(number_text(value) for value in vector)


def number_text(value: float) -> str:
    """A number as a person writes it, with at most six digits."""
    return f"{value:.6g}" if value and math.isfinite(value) else f"{value + 0.0:g}"


def _rows(robot: Robot) -> list[tuple[str, str, str, str]]:
    """Link with its branch, joint, motion, place."""
    below = children_by_link(robot.joints)
    rows = [(robot.root, "", "", "")]
    seen = {robot.root}
    waiting = [("", below.get(robot.root, [])[::-1])]
    while waiting:
        indent, joints = waiting[-1]
        if not joints:
            waiting.pop()
            continue
        joint = joints.pop()
        branch = f"{indent}|-- " if joints else f"{indent}`-- "
        is_new = joint.child not in seen
        name = joint.child if is_new else f"{joint.child} (again)"
        rows.append((branch + name, joint.name, motion_text(joint), pose_text(joint.origin)))
        if is_new:
            seen.add(joint.child)
            deeper = f"{indent}|   " if joints else f"{indent}    "
            waiting.append((deeper, below.get(joint.child, [])[::-1]))
    return rows


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'s' * (number != 1)}"
