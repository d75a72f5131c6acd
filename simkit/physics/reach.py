"""Reach: where the shapes of a model can ever come, whatever its joints do.

An arm on a pedestal cannot touch the ground, so nobody need look whether it does. Regions are
generous: a shape may fill less of its region, never more.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from simkit.geometry import Transform, Vector
from simkit.physics.plan import JointKind, JointPlan, ModelPlan, Plane, ShapePlan, Solid
from simkit.urdf.model import Box, Cylinder, Sphere

NOWHERE: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Region:
    """All points that are no further than `radius` from a circle."""

    centre: Vector
    """Of the circle, in the world [m]."""
    axis: Vector = (0.0, 0.0, 1.0)
    """Unit vector across the circle."""
    ring: float = 0.0
    """Radius of the circle [m]."""
    radius: float = 0.0
    """[m]; infinite for what can be anywhere."""

    def grown(self, by: float) -> Region:
        """The same, so much wider [m]."""
        return replace(self, radius=self.radius + by)

    def gap_to(self, other: Region) -> float:
        """Two shapes in these regions are at least so far apart [m]; negative if they may touch."""
        reach = self.ring + self.radius + other.ring + other.radius
        return math.dist(self.centre, other.centre) - reach

    def height_over(self, point: Vector, normal: Vector) -> float:
        """A shape in this region is at least so far from a plane, on the side of its normal [m]."""
        away = sum(n * (c - p) for n, c, p in zip(normal, self.centre, point, strict=True))
        tilt = sum(n * a for n, a in zip(normal, self.axis, strict=True))
        return away - self.ring * math.sqrt(max(0.0, 1.0 - tilt * tilt)) - self.radius


ANYWHERE = Region(centre=NOWHERE, radius=math.inf)


@dataclass(frozen=True, slots=True, kw_only=True)
class Reach:
    """Where one shape can come."""

    region: Region
    """Its region; of a plane without meaning."""
    is_still: bool
    """Whether it never moves."""
    plane: tuple[Vector, Vector] | None = None
    """Of a plane that never moves a point and its normal, in the world."""
    box: tuple[Transform, Vector] | None = None
    """Of a box that never moves its frame in the world, and half its sizes [m]."""

    def may_touch(self, other: Reach, margin: float) -> bool:
        """Whether the two can come nearer to each other than a margin [m]."""
        if self.plane is not None and other.plane is not None:
            return True
        for one, region in ((self, other.region), (other, self.region)):
            if one.plane is not None:
                return not region.height_over(*one.plane) > margin
        gap = max(
            self.region.gap_to(other.region),
            _gap_to_box(self.region, other.box),
            _gap_to_box(other.region, self.box),
        )
        return not gap > margin


def _gap_to_box(region: Region, box: tuple[Transform, Vector] | None) -> float:
    """What is in a region is at least so far from a box [m]."""
    if box is None:
        return -math.inf
    frame, half = box
    outside = [
        max(abs(p) - h, 0.0) for p, h in zip(frame.apply_back(region.centre), half, strict=True)
    ]
    return math.hypot(*outside) - region.ring - region.radius


@dataclass(frozen=True, slots=True)
class _Still:
    """A body that stays where it is."""

    frame: Transform

    def of(self, point: Vector) -> Region:
        return Region(centre=self.frame.apply(point))


@dataclass(frozen=True, slots=True)
class _Swept:
    """A body that turns about an axis that stays where it is."""

    frame: Transform
    origin: Vector
    axis: Vector

    def of(self, point: Vector) -> Region:
        x, y, z = self.frame.apply(point)
        away = (x - self.origin[0], y - self.origin[1], z - self.origin[2])
        along = sum(a * b for a, b in zip(away, self.axis, strict=True))
        foot = [o + along * a for o, a in zip(self.origin, self.axis, strict=True)]
        centre = (foot[0], foot[1], foot[2])
        return Region(centre=centre, axis=self.axis, ring=math.dist((x, y, z), centre))


@dataclass(frozen=True, slots=True)
class _Hanging:
    """A body of which one point stays in a region, and that turns about it anyhow."""

    region: Region
    anchor: Vector

    def of(self, point: Vector) -> Region:
        return self.region.grown(math.dist(point, self.anchor))


_Freedom = _Still | _Swept | _Hanging


def reaches(plan: ModelPlan, pose: Transform) -> Iterator[tuple[str, int, Reach]]:
    """Where the shapes of a model can come.

    Args:
        plan: The model.
        pose: Where its frame is in the world.

    Yields:
        Body, number of the shape on it, and its reach.
    """
    freedoms: dict[str, _Freedom] = {}
    for joint in plan.joints.values():
        freedom = freedoms[joint.child] = _freedom(joint, plan, pose, freedoms)
        for number, shape in enumerate(plan.bodies[joint.child].shapes):
            yield joint.child, number, _reach(shape, freedom)


def _freedom(
    joint: JointPlan, plan: ModelPlan, pose: Transform, freedoms: dict[str, _Freedom]
) -> _Freedom:
    parent = _Still(pose) if joint.parent is None else freedoms[joint.parent]
    kind = joint.kind
    if kind is JointKind.FREE:
        kind = JointKind.FIXED if plan.is_static else kind
    if kind is JointKind.FIXED:
        return _carried(parent, joint.frame)
    at = joint.frame @ joint.anchor
    if kind is JointKind.REVOLUTE and isinstance(parent, _Still):
        world = parent.frame @ at
        return _Swept(parent.frame @ joint.frame, world.translation, world.rotate(joint.axis))
    if kind is JointKind.REVOLUTE:
        return _Hanging(parent.of(at.translation), joint.anchor.translation)
    if kind is JointKind.PRISMATIC:
        travel = max(abs(joint.lower), abs(joint.upper))
        return _Hanging(parent.of(at.translation).grown(travel), joint.anchor.translation)
    return _Hanging(ANYWHERE, NOWHERE)


def _carried(parent: _Freedom, frame: Transform) -> _Freedom:
    """The freedom of what is fixed to a body, at a frame of it."""
    match parent:
        case _Still():
            return _Still(parent.frame @ frame)
        case _Swept():
            return replace(parent, frame=parent.frame @ frame)
        case _Hanging():
            return replace(parent, anchor=frame.apply_back(parent.anchor))


def _reach(shape: ShapePlan, freedom: _Freedom) -> Reach:
    is_still = isinstance(freedom, _Still)
    if isinstance(shape.solid, Plane):
        if not isinstance(freedom, _Still):
            return Reach(region=ANYWHERE, is_still=False)
        world = freedom.frame @ shape.frame
        plane = (world.translation, world.rotate(shape.solid.normal))
        return Reach(region=ANYWHERE, is_still=True, plane=plane)
    region = freedom.of(shape.frame.translation).grown(_radius(shape.solid))
    box = None
    if isinstance(shape.solid, Box) and isinstance(freedom, _Still):
        x, y, z = shape.solid.size
        box = (freedom.frame @ shape.frame, (x / 2.0, y / 2.0, z / 2.0))
    return Reach(region=region, is_still=is_still, box=box)


def _radius(solid: Solid) -> float:
    """Radius of the ball about the middle of a solid that holds it [m]."""
    match solid:
        case Box():
            return math.hypot(*solid.size) / 2.0
        case Cylinder():
            return math.hypot(solid.radius, solid.length / 2.0)
        case Sphere():
            return solid.radius
        case _:
            return math.inf
