"""From a plan to a skeleton of the engine, joint by joint; nothing is loaded from files by the engine."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from simkit.geometry import Transform
from simkit.physics.engine import dart, isometry
from simkit.physics.plan import BodyPlan, JointKind, JointPlan, ModelPlan, Plane, ShapePlan, Solid
from simkit.physics.shapes import contact_solid
from simkit.urdf.model import Box, Cylinder, Sphere

_CREATORS = {
    JointKind.FIXED: "createWeldJointAndBodyNodePair",
    JointKind.REVOLUTE: "createRevoluteJointAndBodyNodePair",
    JointKind.PRISMATIC: "createPrismaticJointAndBodyNodePair",
    JointKind.FREE: "createFreeJointAndBodyNodePair",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Built:
    """A model in the engine."""

    skeleton: Any
    """The skeleton; it owns the rest."""
    bodies: Mapping[str, Any]
    """Its body nodes, by the names of the plan."""
    joints: Mapping[str, Any]
    """Its joints, by the names of the plan."""
    shapes: Mapping[str, tuple[Any, ShapePlan]]
    """The shape nodes, by their names in the engine, with what they are."""


def build(plan: ModelPlan, *, name: str, pose: Transform) -> Built:
    """Build a model.

    Args:
        plan: What to build.
        name: Name of the model in the world.
        pose: Where its frame is in the world.
    """
    skeleton = dart().dynamics.Skeleton(name)
    bodies: dict[str, Any] = {}
    joints: dict[str, Any] = {}
    shapes: dict[str, tuple[Any, ShapePlan]] = {}
    for planned in plan.joints.values():
        parent = None if planned.parent is None else bodies[planned.parent]
        joint, body = getattr(skeleton, _CREATORS[planned.kind])(parent)
        joint.setName(planned.name)
        body.setName(planned.child)
        _fill_body(body, plan.bodies[planned.child])
        joint.setTransformFromChildBodyNode(isometry(planned.anchor))
        place_joint(joint, planned, pose)
        if planned.moves:
            _set_up(joint, planned)
        bodies[planned.child], joints[planned.name] = body, joint
        for number, shape in enumerate(plan.bodies[planned.child].shapes):
            label = f"{name}::{planned.child}::{number}"
            solid = contact_solid(shape, planned)
            shapes[label] = (_add_shape(body, shape, solid, label), shape)
    skeleton.setMobile(not plan.is_static)
    _choose_collisions(skeleton, plan)
    return Built(skeleton=skeleton, bodies=bodies, joints=joints, shapes=shapes)


def place_joint(joint: Any, plan: JointPlan, pose: Transform) -> None:
    """Put a joint where it belongs, for a model whose frame stands at `pose` in the world."""
    frame = (pose @ plan.frame if plan.parent is None else plan.frame) @ plan.anchor
    if plan.kind is JointKind.FREE:
        joint.setRelativeTransform(isometry(frame))
    else:
        joint.setTransformFromParentBodyNode(isometry(frame))


def start_position(plan: JointPlan) -> float:
    """Where a joint stands first: at 0, or at the limit nearest to it [rad or m]."""
    return min(max(0.0, plan.lower), plan.upper)


def _fill_body(body: Any, plan: BodyPlan) -> None:
    inertia = dart().dynamics.Inertia
    body.setInertia(inertia(plan.body.mass, list(plan.body.centre), np.array(plan.body.tensor)))
    body.setGravityMode(plan.gravity)


def _set_up(joint: Any, plan: JointPlan) -> None:
    joint.setAxis(list(plan.axis))
    joint.setPosition(0, start_position(plan))
    if math.isfinite(plan.lower) or math.isfinite(plan.upper):
        joint.setPositionLowerLimit(0, plan.lower)
        joint.setPositionUpperLimit(0, plan.upper)
        joint.setLimitEnforcement(True)
    joint.setDampingCoefficient(0, plan.damping)
    joint.setCoulombFriction(0, plan.friction)
    joint.setSpringStiffness(0, plan.stiffness)
    joint.setRestPosition(0, plan.rest)


def _add_shape(body: Any, plan: ShapePlan, solid: Solid, label: str) -> Any:
    node = body.createShapeNode(_engine_shape(solid), label)
    node.setRelativeTransform(isometry(plan.frame))
    node.createCollisionAspect()
    node.createDynamicsAspect()
    aspect = node.getDynamicsAspect()
    aspect.setFrictionCoeff(plan.friction)
    aspect.setRestitutionCoeff(0.0)
    return node


def _engine_shape(solid: Solid) -> Any:
    dynamics = dart().dynamics
    match solid:
        case Box():
            return dynamics.BoxShape(list(solid.size))
        case Cylinder():
            return dynamics.CylinderShape(solid.radius, solid.length)
        case Sphere():
            return dynamics.SphereShape(solid.radius)
        case Plane():
            return dynamics.PlaneShape(list(solid.normal), 0.0)


def _choose_collisions(skeleton: Any, plan: ModelPlan) -> None:
    """Bodies of one model pass through each other, unless one of the two says that it does not.

    Bodies that a joint connects always do.
    """
    if any(body.self_collide for body in plan.bodies.values()):
        skeleton.enableSelfCollisionCheck()
    else:
        skeleton.disableSelfCollisionCheck()
    skeleton.disableAdjacentBodyCheck()


def non_colliding_pairs(plan: ModelPlan) -> list[tuple[str, str]]:
    """Pairs of bodies of a model that pass through each other although others of it do not."""
    names = list(plan.bodies)
    if not any(body.self_collide for body in plan.bodies.values()):
        return []
    return [
        (one, other)
        for number, one in enumerate(names)
        for other in names[number + 1 :]
        if not plan.bodies[one].self_collide and not plan.bodies[other].self_collide
    ]
