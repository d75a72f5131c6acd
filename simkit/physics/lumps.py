"""Lumps: links that fixed joints hold together are one body, with where its links and joints are in it."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from simkit.geometry import Transform
from simkit.physics.gazebo_tags import GazeboTags
from simkit.urdf.fixed_joints import WORLD, merged_links
from simkit.urdf.model import Joint, JointType, Link, Robot


@dataclass(frozen=True, slots=True, kw_only=True)
class Member:
    """A link in a lump."""

    link: Link
    """The link."""
    frame: Transform
    """Where it is in the frame of the lump."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Branch:
    """A joint that leads from one lump to another."""

    joint: Joint
    """The joint; its child leads the other lump."""
    frame: Transform
    """Where its parent link is in the frame of the lump."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RigidGroup:
    """Links that are one body."""

    name: str
    """The link nearest to the root: the lump has its name and frame."""
    members: tuple[Member, ...]
    """Its links, that one first."""
    branches: tuple[Branch, ...]
    """The joints that lead away from it."""


def find_lumps(robot: Robot, tags: GazeboTags) -> dict[str, RigidGroup]:
    """The lumps of a robot by name, parents before their children; `world` is one of its own."""
    below = _joints_below(robot)
    merged = _merged_links(robot, below, tags)
    found: dict[str, RigidGroup] = {}
    waiting = [robot.root]
    while waiting:
        lump = _lump(robot, waiting.pop(), below, merged)
        found[lump.name] = lump
        waiting.extend(branch.joint.child for branch in reversed(lump.branches))
    return found


def is_anchor(robot: Robot, link: str) -> bool:
    """Whether a link is the world itself."""
    return link == WORLD and link == robot.root


def _lump(
    robot: Robot, leader: str, below: Mapping[str, list[Joint]], merged: Collection[str]
) -> RigidGroup:
    members: list[Member] = []
    branches: list[Branch] = []
    waiting = [Member(link=robot.links[leader], frame=Transform())]
    while waiting:
        member = waiting.pop()
        members.append(member)
        inner: list[Member] = []
        for joint in below.get(member.link.name, ()):
            if joint.child in merged:
                frame = member.frame @ joint.origin.transform
                inner.append(Member(link=robot.links[joint.child], frame=frame))
            else:
                branches.append(Branch(joint=joint, frame=member.frame))
        waiting.extend(reversed(inner))
    return RigidGroup(name=leader, members=tuple(members), branches=tuple(branches))


def _merged_links(
    robot: Robot, below: Mapping[str, list[Joint]], tags: GazeboTags
) -> dict[str, str]:
    """For each link that is merged into its parent: the parent."""
    joints = [joint for same in below.values() for joint in same]
    return merged_links(
        [(one.name, one.parent, one.child) for one in joints if one.type is JointType.FIXED],
        kept=[one.name for one in joints if tags.of_joint(one.name).is_kept],
        has_ground=is_anchor(robot, WORLD),
    )


def _joints_below(robot: Robot) -> dict[str, list[Joint]]:
    """The joints below each link, by name; of several above one link, urdfdom keeps the last by name."""
    above = {robot.joints[name].child: name for name in sorted(robot.joints)}
    below: dict[str, list[Joint]] = {}
    for name in sorted(above.values()):
        joint = robot.joints[name]
        below.setdefault(joint.parent, []).append(joint)
    return below
