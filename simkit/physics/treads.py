"""Wheels: a cylinder that turns about its own axis touches the ground with the middle of its tread.

Two bodies that touch along a line share the load along it; an engine that knows points gives it to the
two ends of the line, in any shares that hold the body up. For a wheel that means an edge: the robot
turns as if its wheels were as far apart as these edges, by ten per cent off and another amount in each
curve. A tyre is rounder. So the solid that the engine is given for a wheel is narrow, in the middle of the
one that is seen, and that lasers see.
"""

from __future__ import annotations

import math

from simkit.physics.plan import JointKind, JointPlan, ShapePlan, Solid
from simkit.urdf.matrix import apply
from simkit.urdf.model import Cylinder

WIDTH = 0.002
"""Width of what touches [m]: how far wheels are apart is off by less than that."""
ASKEW = math.radians(2.0)
"""By so much the axis of a wheel may be off that of its joint: numbers like 1.57 are rounded [rad]."""
OFF_CENTRE = 0.05
"""Share of its radius by which the centre of a wheel may be off the axis of its joint."""
LONGEST = 2.0
"""A wheel is no longer than so many radii; what is longer is a roller, and touches along a line."""


def contact_solid(shape: ShapePlan, joint: JointPlan) -> Solid:
    """What the engine computes contacts of for a shape that hangs on a joint.

    Args:
        shape: The shape, in the frame of the child of the joint.
        joint: The joint.
    """
    solid = shape.solid
    if isinstance(solid, Cylinder) and _is_wheel(solid, shape, joint):
        return Cylinder(radius=solid.radius, length=min(solid.length, WIDTH))
    return solid


def _is_wheel(solid: Cylinder, shape: ShapePlan, joint: JointPlan) -> bool:
    """Whether a cylinder turns round and round about its own axis."""
    if joint.kind is not JointKind.REVOLUTE or solid.length > LONGEST * solid.radius:
        return False
    if math.isfinite(joint.lower) or math.isfinite(joint.upper):
        return False
    axis = apply(joint.anchor.rotation, joint.axis)
    own = tuple(row[2] for row in shape.frame.rotation)
    along = sum(a * b for a, b in zip(axis, own, strict=True))
    if abs(along) < math.cos(ASKEW):
        return False
    arm = [c - o for c, o in zip(shape.frame.origin, joint.anchor.origin, strict=True)]
    forward = sum(a * b for a, b in zip(axis, arm, strict=True))
    off = math.dist(arm, [forward * a for a in axis])
    return off <= OFF_CENTRE * solid.radius
