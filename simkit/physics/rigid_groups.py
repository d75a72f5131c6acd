"""Rigid groups: links that fixed joints hold together are one body, whose inertia is fit for an engine that checks nothing."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np

from simkit.geometry import Transform
from simkit.physics.errors import ModelError
from simkit.physics.gazebo_tags import GazeboTags
from simkit.physics.plan import check_numbers, check_pose
from simkit.urdf.fixed_joints import WORLD, merged_links
from simkit.urdf.inertia import Body, eigenvalues, merged, placed_body
from simkit.urdf.model import Inertial, Joint, JointType, Link, Robot


@dataclass(frozen=True, slots=True, kw_only=True)
class Member:
    """A link in a rigid group."""

    link: Link
    """The link."""
    frame: Transform
    """Where it is in the frame of the group."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Branch:
    """A joint that leads from one group to another."""

    joint: Joint
    """The joint; its child leads the other group."""
    frame: Transform
    """Where its parent link is in the frame of the group."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RigidGroup:
    """Links that are one body."""

    name: str
    """The link nearest to the root: the group has its name and frame."""
    members: tuple[Member, ...]
    """Its links, that one first."""
    branches: tuple[Branch, ...]
    """The joints that lead away from it."""


def find_rigid_groups(robot: Robot, tags: GazeboTags) -> dict[str, RigidGroup]:
    """The rigid groups of a robot by name, parents before their children; `world` is one of its own."""
    below = _joints_below(robot)
    merged = _merged_links(robot, below, tags)
    found: dict[str, RigidGroup] = {}
    waiting = [robot.root]
    while waiting:
        group = _group(robot, waiting.pop(), below, merged)
        found[group.name] = group
        waiting.extend(branch.joint.child for branch in reversed(group.branches))
    return found


def is_anchor(robot: Robot, link: str) -> bool:
    """Whether a link is the world itself."""
    return link == WORLD and link == robot.root


def _group(
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


NO_MASS = 1e-6
"""A smaller mass [kg] is none, as for sdformat."""
THINNEST = 1e-7
"""Smallest principal moment of inertia per mass [m^2]: all of it within 0.3 mm of an axis."""


def body_of(group: RigidGroup) -> Body | None:
    """The body that the links of a group make, in the frame of the group; None if it has no mass.

    Raises:
        ModelError: A mass is negative, or a number is NaN.
    """
    bodies = [
        placed_body(body, member.frame)
        for member in group.members
        if member.link.inertial is not None
        and (body := link_body(member.link.inertial, member.link.name)) is not None
    ]
    if sum(body.mass for body in bodies) < NO_MASS:
        return None
    return merged(bodies)


def link_body(inertial: Inertial, link: str) -> Body | None:
    """The body of one link in its own frame, None if it weighs nothing.

    Raises:
        ModelError: Its mass is negative, or a number is NaN.
    """
    one = inertial
    tensor = ((one.ixx, one.ixy, one.ixz), (one.ixy, one.iyy, one.iyz), (one.ixz, one.iyz, one.izz))
    check_numbers((one.mass, *np.ravel(tensor)), f"the inertial of link {link}")
    check_pose(one.origin, f"the inertial of link {link}")
    if one.mass < 0.0:
        raise ModelError(f"link {link} has a mass of {one.mass:g} kg: a mass is positive")
    if one.mass < NO_MASS:
        return None
    return placed_body(Body(one.mass, (0.0, 0.0, 0.0), tensor), one.origin.transform)


def sound(body: Body, name: str) -> tuple[Body, str]:
    """A body that the engine can turn, and what was changed in it; the note is empty if nothing.

    A tensor with a moment that is zero or negative turns without effort, or away from every push:
    the numbers would leave all bounds within a few steps.
    """
    low, _, _ = eigenvalues(body.tensor)
    least = THINNEST * body.mass
    if low >= least:
        return body, ""
    moments, axes = np.linalg.eigh(np.array(body.tensor))
    raised = np.maximum(moments, least)
    tensor = axes @ np.diag(raised) @ axes.T
    rows = [tuple(float(x) for x in row) for row in (tensor + tensor.T) / 2.0]
    note = (
        f"the inertia of {name} is impossible (its smallest principal moment is {low:.3g} kg m^2): "
        f"simulated with {least:.3g} kg m^2 instead"
    )
    return Body(body.mass, body.centre, (rows[0], rows[1], rows[2])), note  # type: ignore[arg-type]
