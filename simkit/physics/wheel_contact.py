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
from simkit.urdf.model import Cylinder
from simkit.urdf.wheel import is_wheel

WIDTH = 0.002
"""Width of what touches [m]: how far wheels are apart is off by less than that."""


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
    is_endless = not math.isfinite(joint.lower) and not math.isfinite(joint.upper)
    if joint.kind is not JointKind.REVOLUTE or not is_endless:
        return False
    axis = joint.anchor.rotate(joint.axis)
    return is_wheel(solid, shape.frame, axis=axis, origin=joint.anchor.translation)
