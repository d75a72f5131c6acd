"""From a URDF to a plan, as Gazebo goes from URDF to SDF.

Source: sdformat 6 and 9, `parser_urdf.cc`. What the file says and the simulation does not do
stands in `notes` of the plan, one sentence each.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

from simkit.geometry import Transform
from simkit.physics.errors import ModelError
from simkit.physics.gazebo_tags import GazeboTags, LinkTags, read_gazebo_tags
from simkit.physics.plan import (
    BodyPlan,
    JointKind,
    JointPlan,
    ModelPlan,
    Mount,
    check_numbers,
    check_pose,
)
from simkit.physics.rigid_groups import (
    Branch,
    RigidGroup,
    body_of,
    find_rigid_groups,
    is_anchor,
    sound,
)
from simkit.physics.shapes import shapes_of, unit
from simkit.urdf.model import Joint, JointType, Robot

KINDS = {
    JointType.FIXED: JointKind.FIXED,
    JointType.REVOLUTE: JointKind.REVOLUTE,
    JointType.CONTINUOUS: JointKind.REVOLUTE,
    JointType.PRISMATIC: JointKind.PRISMATIC,
    JointType.FLOATING: JointKind.FREE,
    JointType.PLANAR: JointKind.FREE,
}
"""How the engine moves each type of joint."""

HUGE = 1e16
"""A limit of this size is none, as for sdformat."""


def plan_robot(robot: Robot) -> ModelPlan:
    """What is simulated of a robot.

    Args:
        robot: The robot; a root link named `world` fixes it to the world.

    Raises:
        ModelError: A mass is negative, an axis is zero, or a number is NaN.
    """
    return _Planner(robot, read_gazebo_tags(robot)).plan()


@dataclass(slots=True)
class _Planner:
    robot: Robot
    tags: GazeboTags
    bodies: dict[str, BodyPlan] = field(default_factory=dict)
    joints: dict[str, JointPlan] = field(default_factory=dict)
    mounts: dict[str, Mount] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)

    def plan(self) -> ModelPlan:
        self.notes += self.tags.notes
        self._note_mimics()
        groups = find_rigid_groups(self.robot, self.tags)
        rest = {self.robot.root: Transform()}  # T_model_group, with all joints at 0
        branches: dict[str, tuple[RigidGroup, Branch]] = {}
        for name, group in groups.items():
            if name in rest and self._take(group, rest[name], branches.get(name), groups):
                for branch in group.branches:
                    branches[branch.joint.child] = (group, branch)
                    inner = branch.frame @ branch.joint.origin.transform
                    rest[branch.joint.child] = rest[name] @ inner
        return ModelPlan(
            name=self.robot.name,
            bodies=self.bodies,
            joints=self.joints,
            mounts=self.mounts,
            is_static=self.tags.is_static,
            notes=tuple(dict.fromkeys(self.notes)),
        )

    def _take(
        self,
        group: RigidGroup,
        rest: Transform,
        above: tuple[RigidGroup, Branch] | None,
        groups: dict[str, RigidGroup],
    ) -> bool:
        """Take in a group and the joint above it; False if it is not simulated."""
        if is_anchor(self.robot, group.name):
            if self.robot.links[group.name].collisions or self.robot.links[group.name].inertial:
                self.notes.append(
                    "the root link world is the world itself: its mass and shapes are left out"
                )
            return True
        body = body_of(group)
        if body is None:
            self._note_lost(group, groups)
            return False
        body, note = sound(body, f"link {group.name}")
        shapes, notes = shapes_of(group, self.tags)
        self.notes += [*filter(None, [note]), *notes]
        tags = _merged_tags([self.tags.of_link(one.link.name) for one in group.members])
        self.bodies[group.name] = BodyPlan(
            name=group.name,
            body=body,
            shapes=shapes,
            gravity=tags.gravity is not False,
            self_collide=bool(tags.self_collide) or self.tags.self_collide,
            decay=min(tags.decay or 0.0, 1.0),
        )
        for member in group.members:
            self.mounts[member.link.name] = Mount(body=group.name, frame=member.frame)
        joint = _free(group.name, rest) if above is None else self._joint(*above, rest)
        self.joints[joint.name] = joint
        return True

    def _joint(self, parent: RigidGroup, branch: Branch, rest: Transform) -> JointPlan:
        joint = branch.joint
        check_pose(joint.origin, f"the origin of joint {joint.name}")
        kind = KINDS[joint.type]
        if kind is JointKind.FREE:
            self.notes.append(
                f"joint {joint.name} is {joint.type.value}: {joint.child} floats free, as in Gazebo"
            )
            return _free(joint.child, rest)
        base = JointPlan(
            name=joint.name,
            kind=kind,
            parent=None if is_anchor(self.robot, parent.name) else parent.name,
            child=joint.child,
            frame=branch.frame @ joint.origin.transform,
        )
        return base if kind is JointKind.FIXED else self._moving(base, joint)

    def _moving(self, base: JointPlan, joint: Joint) -> JointPlan:
        lower, upper, effort, velocity = self._limits(joint)
        check_numbers((joint.damping, joint.friction), f"the dynamics of joint {joint.name}")
        tags = self.tags.of_joint(joint.name)
        return replace(
            base,
            axis=unit(joint.axis, f"the axis of joint {joint.name}"),
            lower=lower,
            upper=upper,
            effort=effort,
            velocity=velocity,
            damping=max(joint.damping, 0.0),
            friction=max(joint.friction, 0.0),
            stiffness=tags.stiffness,
            rest=tags.rest,
        )

    def _limits(self, joint: Joint) -> tuple[float, float, float, float]:
        limit = joint.limit
        if limit is None:
            return (-math.inf, math.inf, math.inf, math.inf)
        effort = limit.effort if limit.effort >= 0.0 else math.inf
        velocity = limit.velocity if limit.velocity >= 0.0 else math.inf
        if joint.type is JointType.CONTINUOUS:
            return (-math.inf, math.inf, effort, velocity)
        lower, upper = limit.lower, limit.upper
        if math.isnan(lower) or math.isnan(upper):
            raise ModelError(f"a limit of joint {joint.name} is not a number")
        if lower > upper:
            self.notes.append(
                f"joint {joint.name} has lower = {lower:g} above upper = {upper:g}: they are swapped"
            )
            lower, upper = upper, lower
        return (_bound(lower), _bound(upper), effort, velocity)

    def _note_lost(self, group: RigidGroup, groups: dict[str, RigidGroup]) -> None:
        lost = [member.link.name for member in group.members]
        waiting = [branch.joint.child for branch in group.branches]
        while waiting:
            name = waiting.pop(0)
            lost += [member.link.name for member in groups[name].members]
            waiting += [branch.joint.child for branch in groups[name].branches]
        more = f", and with it {', '.join(lost[1:])}" if len(lost) > 1 else ""
        self.notes.append(f"link {group.name} has no mass, so Gazebo leaves it out{more}: give it an <inertial>")  # fmt: skip

    def _note_mimics(self) -> None:
        for joint in self.robot.joints.values():
            if joint.mimic is not None:
                self.notes.append(
                    f"joint {joint.name} does not follow {joint.mimic.joint}: Gazebo ignores <mimic>"
                )


def _free(body: str, rest: Transform) -> JointPlan:
    return JointPlan(
        name=f"{body} (free)", kind=JointKind.FREE, parent=None, child=body, frame=rest
    )


def _bound(limit: float) -> float:
    return limit if abs(limit) < HUGE else math.copysign(math.inf, limit)


def _merged_tags(tags: list[LinkTags]) -> LinkTags:
    """What is said of a group: of several words about one thing the last one counts."""
    merged = LinkTags()
    for one in tags:
        merged.gravity = merged.gravity if one.gravity is None else one.gravity
        merged.self_collide = merged.self_collide if one.self_collide is None else one.self_collide
        merged.decay = merged.decay if one.decay is None else one.decay
    return merged
