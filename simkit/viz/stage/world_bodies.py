"""What Gazebo shows of bodies and joints: centres of mass, boxes of equal inertia, axes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

import numpy as np

from simkit.geometry import Quaternion, Vector, multiply, quaternion_from_matrix, quaternion_from_z
from simkit.physics import BodyPlan, JointKind, JointPlan, Model
from simkit.urdf import Box, Cylinder, Sphere
from simkit.viz.stage.parts import Color, Role, Solid
from simkit.viz.stage.world_models import link_frame

LEAD: Final = 11_340.0
"""Density of lead [kg/m^3]: a ball of it, as heavy as the body, stands for a centre of mass."""
CENTRE_COLOR: Final[Color] = (0.85, 0.1, 0.1)
"""Of a centre of mass."""
INERTIA_COLOR: Final[Color] = (0.62, 0.16, 0.8)
"""Of a box of equal inertia; purple, as in Gazebo."""
INERTIA_ALPHA: Final = 0.5
"""Its opacity."""
JOINT_COLOR: Final[Color] = (0.95, 0.75, 0.0)
"""Of an axis; yellow, as in Gazebo."""
_ROD, _DISC, _THICK = 0.035, 0.22, 0.05
"Radius of the rod and of the disc of a joint that turns, and how thick the disc is, in lengths of the rod."


def body_solids(model: Model, *, name: str, size: float) -> Iterator[Solid]:
    """The centres of mass, boxes of equal inertia and axes of a model.

    Args:
        model: The model.
        name: What it is called in the view.
        size: How long the axis of a joint shall be [m].

    Source:
        Gazebo's menu View: Center of mass, Inertias, Joints.
    """
    if model.plan.is_static:
        return
    for body in model.plan.bodies.values():
        frame = link_frame(name, body.name)
        yield _centre(body, frame)
        yield _inertia(body, frame)
    for joint in model.plan.joints.values():
        yield from _joint(joint, link_frame(name, joint.child), size)


def _centre(body: BodyPlan, frame: str) -> Solid:
    radius = (0.75 * body.body.mass / (math.pi * LEAD)) ** (1 / 3)
    return Solid(
        link=frame,
        role=Role.CENTRE,
        shape=Sphere(radius),
        translation=body.body.centre,
        color=CENTRE_COLOR,
    )


def _inertia(body: BodyPlan, frame: str) -> Solid:
    size, rotation = inertia_box(body)
    return Solid(
        link=frame,
        role=Role.INERTIA,
        shape=Box(size),
        translation=body.body.centre,
        rotation=rotation,
        color=INERTIA_COLOR,
        alpha=INERTIA_ALPHA,
    )


def inertia_box(body: BodyPlan) -> tuple[Vector, Quaternion]:
    """Sides [m] of the box of the same mass that is as hard to turn, and how it is turned in the frame of the body."""
    moments, axes = np.linalg.eigh(np.array(body.body.tensor))
    if np.linalg.det(axes) < 0.0:
        axes[:, 2] = -axes[:, 2]
    a, b, c = (max(0.0, value) for value in moments.tolist())
    x, y, z = (
        math.sqrt(max(0.0, 6.0 * (p + q - r) / body.body.mass))
        for p, q, r in ((b, c, a), (a, c, b), (a, b, c))
    )
    (m0, m1, m2), (m3, m4, m5), (m6, m7, m8) = axes.tolist()
    return (x, y, z), quaternion_from_matrix(((m0, m1, m2), (m3, m4, m5), (m6, m7, m8)))


def _joint(joint: JointPlan, frame: str, size: float) -> Iterator[Solid]:
    """A rod along the axis; around it a disc if the joint turns, a box if it slides."""
    if not joint.moves:
        return
    turn = multiply(joint.anchor.rotation, quaternion_from_z(joint.axis))
    middle = (
        Cylinder(_DISC * size, _THICK * size)
        if joint.kind is JointKind.REVOLUTE
        else Box((2 * _THICK * size, 2 * _THICK * size, _DISC * size))
    )
    for shape in (Cylinder(_ROD * size, size), middle):
        yield Solid(
            link=frame,
            role=Role.JOINT,
            shape=shape,
            translation=joint.anchor.translation,
            rotation=turn,
            color=JOINT_COLOR,
        )
