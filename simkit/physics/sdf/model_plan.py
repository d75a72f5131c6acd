"""From an SDF model to a plan."""

from __future__ import annotations

import functools

from simkit.geometry import Transform, Vector
from simkit.physics.errors import ModelError
from simkit.physics.plan import (
    BodyPlan,
    JointKind,
    JointPlan,
    ModelPlan,
    Mount,
    Plane,
    ShapePlan,
    check_pose,
)
from simkit.physics.rigid_groups import link_body, sound
from simkit.physics.sdf.description import SdfCollision, SdfJoint, SdfLink, SdfModel
from simkit.physics.sdf.library import BUILT_IN
from simkit.physics.sdf.models import WORLD
from simkit.physics.sdf.world_file import read_model_text
from simkit.physics.shapes import PLACEHOLDER, note_friction, unit, with_solid
from simkit.urdf.inertia import Body
from simkit.urdf.model import Inertial

_KINDS = {
    "fixed": JointKind.FIXED,
    "revolute": JointKind.REVOLUTE,
    "prismatic": JointKind.PRISMATIC,
}


def plan_model(model: SdfModel) -> ModelPlan:
    """What is simulated of an SDF model; where it is in the world is not part of the plan.

    Args:
        model: The model.

    Raises:
        ModelError: A mass or number cannot be, or joints hold a link in two ways.
    """
    notes: list[str] = []
    above = _joints_above(model)
    bodies: dict[str, BodyPlan] = {}
    joints: dict[str, JointPlan] = {}
    for link in _parents_first(model, above):
        bodies[link.name] = _body(model, link, notes)
        joint = _joint(model, link, above.get(link.name))
        joints[joint.name] = joint
    return ModelPlan(
        name=model.name,
        bodies=bodies,
        joints=joints,
        mounts={name: Mount(body=name, frame=Transform()) for name in bodies},
        is_static=model.is_static,
        notes=tuple(dict.fromkeys(notes)),
    )


def _joints_above(model: SdfModel) -> dict[str, SdfJoint]:
    above: dict[str, SdfJoint] = {}
    for joint in model.joints:
        if joint.child in above:
            raise ModelError(
                f"joints {above[joint.child].name} and {joint.name} both hold {joint.child}: "
                "loops are not supported"
            )
        above[joint.child] = joint
    return above


def _parents_first(model: SdfModel, above: dict[str, SdfJoint]) -> list[SdfLink]:
    """The links of a model, each behind the one that it hangs on."""
    waiting = list(model.links)
    done: dict[str, SdfLink] = {}
    while waiting:
        ready = [
            link
            for link in waiting
            if link.name not in above or above[link.name].parent in (WORLD, *done)
        ]
        if not ready:
            names = ", ".join(link.name for link in waiting)
            raise ModelError(f"the links {names} of {model.name} hang on each other in a circle")
        done |= {link.name: link for link in ready}
        waiting = [link for link in waiting if link.name not in done]
    return list(done.values())


def _body(model: SdfModel, link: SdfLink, notes: list[str]) -> BodyPlan:
    body, note = sound(_mass(link), f"link {link.name}")
    shapes = tuple(one for c in link.collisions if (one := _shape(link, c, notes)))
    notes += filter(None, [note])
    collides = model.self_collide if link.self_collide is None else link.self_collide
    return BodyPlan(
        name=link.name,
        body=body,
        shapes=shapes,
        gravity=link.gravity,
        self_collide=collides,
        decay=link.decay,
    )


def _mass(link: SdfLink) -> Body:
    inertial = link.inertial or Inertial(mass=1.0, ixx=1.0, iyy=1.0, izz=1.0)
    body = link_body(inertial, link.name)
    if body is None:
        raise ModelError(f"link {link.name} has a mass of {inertial.mass:g} kg: a mass is positive")
    return body


def _shape(link: SdfLink, collision: SdfCollision, notes: list[str]) -> ShapePlan | None:
    check_pose(collision.pose, f"a collision of link {link.name}")
    if not isinstance(collision.geometry, Plane):
        note_friction(link.name, collision.friction, collision.across, notes)
    base = ShapePlan(
        name=collision.name,
        link=link.name,
        solid=PLACEHOLDER,
        frame=collision.pose.transform,
        friction=collision.friction,
        retro=collision.retro,
    )
    return with_solid(base, collision.geometry, notes)


def _joint(model: SdfModel, link: SdfLink, joint: SdfJoint | None) -> JointPlan:
    """The joint that holds a link: that of the file, else one that fixes or frees it."""
    check_pose(link.pose, f"the pose of link {link.name}")
    here = link.pose.transform
    if joint is None:
        kind = JointKind.FIXED if model.is_static else JointKind.FREE
        return JointPlan(
            name=f"{link.name} ({kind.value})", kind=kind, parent=None, child=link.name, frame=here
        )
    check_pose(joint.pose, f"the pose of joint {joint.name}")
    poses = {one.name: one.pose.transform for one in model.links}
    is_anchored = joint.parent == WORLD
    return JointPlan(
        name=joint.name,
        kind=_KINDS[joint.type],
        parent=None if is_anchored else joint.parent,
        child=link.name,
        frame=here if is_anchored else poses[joint.parent].inverse() @ here,
        anchor=joint.pose.transform,
        axis=_axis(joint, here),
        lower=min(joint.lower, joint.upper),
        upper=max(joint.lower, joint.upper),
        effort=joint.effort,
        velocity=joint.velocity,
        damping=joint.damping,
        friction=joint.friction,
        stiffness=joint.stiffness,
        rest=joint.rest,
    )


def _axis(joint: SdfJoint, link: Transform) -> Vector:
    """The axis at unit length in the frame of the joint."""
    axis = joint.axis
    if joint.axis_in_model:
        axis = (link @ joint.pose.transform).rotate_back(axis)
    return unit(axis, f"the axis of joint {joint.name}")


GROUND = "ground_plane"
"""Name of the model of the ground."""


@functools.cache
def ground_plan() -> ModelPlan:
    """The plan of the ground: a plane without end at z = 0 that nothing moves.

    Its friction is 100: of two that touch the smaller coefficient counts, so that of the robot does.
    """
    model, _ = read_model_text(BUILT_IN[GROUND], file=f"model://{GROUND}/model.sdf")
    return plan_model(model)
