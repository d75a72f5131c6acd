"""The frames of a robot: each hangs on its parent by a joint, fixed or moving."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from simkit.geometry import Quaternion, Vector
from simkit.msgs import Time, message_class
from simkit.urdf import Joint, JointType, Robot
from simkit.urdf.kinematics import joint_transform

ROOT_INERTIA = (
    "The root link {root} has an inertia specified in the URDF, but KDL does not support a root "
    "link with an inertia.  As a workaround, you can add an extra dummy link to your URDF."
)
"""The warning of KDL for a robot whose root has a mass."""


@dataclass(frozen=True, slots=True)
class LinkSegment:
    """One link and the joint that it hangs on."""

    joint: Joint
    """The joint."""

    def pose(self, position: float) -> tuple[Vector, Quaternion]:
        """Where the link is in its parent, for a position of the joint [rad or m]."""
        if self.joint.moves:
            return joint_transform(self.joint, position)
        return self.joint.origin.transform

    def message(self, position: float, stamp: Time, prefix: str) -> Any:
        """The geometry_msgs/TransformStamped.

        Args:
            position: Of the joint [rad or m].
            stamp: Time for which it holds.
            prefix: What stands before each frame name, see `prefixed`.
        """
        message: Any = message_class("geometry_msgs/TransformStamped")()
        message.header.stamp = stamp
        message.header.frame_id = prefixed(self.joint.parent, prefix)
        message.child_frame_id = prefixed(self.joint.child, prefix)
        translation, rotation = self.pose(position)
        t, q = message.transform.translation, message.transform.rotation
        t.x, t.y, t.z = translation
        q.x, q.y, q.z, q.w = rotation
        return message


@dataclass(frozen=True, slots=True, kw_only=True)
class Segments:
    """All segments of a robot by name of their joint, sorted by it."""

    fixed: dict[str, LinkSegment]
    """Those that never move."""
    moving: dict[str, LinkSegment]
    """Those whose joint has a position."""
    mimics: dict[str, Joint]
    """The joints that follow another one."""


def segments_of(
    robot: Robot, *, info: Callable[[str], None], warn: Callable[[str], None]
) -> Segments:
    """Take a robot apart, as kdl_parser and robot_state_publisher do.

    Args:
        robot: The robot.
        info: Logs floating joints, which have no transform.
        warn: Logs what KDL does not support.
    """
    if robot.links[robot.root].inertial is not None:
        warn(ROOT_INERTIA.format(root=robot.root))
    fixed: dict[str, LinkSegment] = {}
    moving: dict[str, LinkSegment] = {}
    for name, joint in sorted(_reachable(robot), key=lambda pair: pair[0]):
        if joint.type in (JointType.FLOATING, JointType.PLANAR):
            warn(f"Converting unknown joint type of joint '{name}' into a fixed joint")
        if joint.type is JointType.FLOATING:
            info(
                f"Floating joint. Not adding segment from {joint.parent} to {joint.child}. "
                "This TF can not be published based on joint_states info"
            )
        else:
            (moving if joint.moves else fixed)[name] = LinkSegment(joint)
    mimics = {name: robot.joints[name] for name in sorted(robot.joints)}
    return Segments(
        fixed=fixed,
        moving=moving,
        mimics={name: joint for name, joint in mimics.items() if joint.mimic is not None},
    )


def prefixed(frame: str, prefix: str) -> str:
    """A frame name as it is broadcast: `arm` becomes `left/arm`; `/arm` becomes `arm`, always."""
    if frame.startswith("/"):
        return frame[1:]
    return f"{prefix.removeprefix('/')}/{frame}" if prefix else frame


def _reachable(robot: Robot) -> Iterator[tuple[str, Joint]]:
    """The joints on the way from the root to each link; of two above one link the last by name."""
    above = {robot.joints[name].child: robot.joints[name] for name in sorted(robot.joints)}
    below: dict[str, list[str]] = {}
    for joint in robot.joints.values():
        below.setdefault(joint.parent, []).append(joint.child)
    waiting, seen = [robot.root], {robot.root}
    while waiting:
        for link in below.get(waiting.pop(), ()):
            if link not in seen:
                seen.add(link)
                waiting.append(link)
                yield above[link].name, above[link]
