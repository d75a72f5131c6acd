"""The shapes of a robot, in the colours that RViz gives them; and how much room it takes, however its joints move."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

import numpy as np

from simkit.errors import SimkitError
from simkit.geometry import Vector
from simkit.urdf import (
    Box,
    Collision,
    Geometry,
    Joint,
    JointType,
    Link,
    Material,
    Mesh,
    Robot,
    Visual,
)
from simkit.urdf.kinematics import forward_kinematics
from simkit.urdf.mesh_file import MeshError, read_mesh
from simkit.viz.draw.letters import abbreviated
from simkit.viz.stage.frames import FramePose
from simkit.viz.stage.parts import (
    Color,
    Role,
    Solid,
    SolidShape,
    TriangleMesh,
    corners,
    half_extents,
)

UNPAINTED: Color = (0.9, 0.1, 0.1)
"""A visual without a material is red in RViz."""
TOUCHED: Color = (0.55, 0.36, 0.85)
"""Collision shapes have a colour of their own, so that nobody takes them for what is seen."""
TOUCHED_ALPHA = 0.55
MISSING: Color = (0.85, 0.2, 0.75)
"""The colour of what stands for a mesh that is not there."""
_MISSING_SIZE = 0.1
"Side of the box that stands for a mesh [m]."
_FAR = 1e6
"Nothing is drawn that is larger, or further from its link [m]."
_MOST = 2000
"So many shapes are drawn."


@dataclass(frozen=True, slots=True)
class RobotInTf:
    """A robot, and what its frames are called."""

    robot: Robot
    """The robot."""
    tf_prefix: str = ""
    """What stands before the names of its links; empty if nothing does."""

    def frame(self, link: str) -> str:
        """The frame of a link, e.g. `left/arm` of `arm`."""
        return f"{self.tf_prefix}/{link}" if self.tf_prefix else link


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotShapes:
    """What there is to draw of a robot."""

    models: tuple[RobotInTf, ...] = ()
    """The robots: usually one."""
    links: tuple[str, ...] = ()
    """The frames of their links, in the order of the files."""
    solids: tuple[Solid, ...] = ()
    """The shapes of these."""
    notes: tuple[str, ...] = ()
    """A sentence for each shape that is not drawn as it is written."""
    errors: tuple[str, ...] = ()
    """Why there is no robot; empty if there is one."""


def robot_shapes(robot: Robot, *, alpha: float = 1.0, tf_prefix: str = "") -> RobotShapes:
    """The visual and the collision shapes of all links.

    Args:
        robot: The robot.
        alpha: Opacity of the whole robot, on top of that of its materials, from 0 to 1.
        tf_prefix: What stands before the names of its links in tf, without the slash between them.

    Source:
        RViz' RobotModel display: the colours; a mesh that is missing is left out there, here a box stands for it.
    """
    notes: list[str] = []
    solids = [s for link in robot.links.values() for s in _solids_of(link, notes)]
    if len(solids) > _MOST:
        notes.append(f"Only the first {_MOST} of {len(solids)} shapes are drawn.")
    model = RobotInTf(robot, tf_prefix)
    drawn = [replace(s, link=model.frame(s.link), alpha=s.alpha * alpha) for s in solids[:_MOST]]
    return RobotShapes(
        models=(model,),
        links=tuple(map(model.frame, robot.links)),
        solids=tuple(drawn),
        notes=tuple(dict.fromkeys(notes)),
    )


def together(robots: Sequence[RobotShapes]) -> RobotShapes:
    """Several robots as one thing to draw; a sentence that is about several of them is there once."""
    return RobotShapes(
        models=tuple(model for one in robots for model in one.models),
        links=tuple(link for one in robots for link in one.links),
        solids=tuple(solid for one in robots for solid in one.solids),
        notes=tuple(dict.fromkeys(note for one in robots for note in one.notes)),
        errors=tuple(dict.fromkeys(error for one in robots for error in one.errors)),
    )


def _solids_of(link: Link, notes: list[str]) -> Iterator[Solid]:
    for visual in link.visuals:
        color, alpha = painted(visual.material) or (UNPAINTED, 1.0)
        yield from part_solid(link.name, visual, color, alpha, notes)
    for collision in link.collisions:
        yield from part_solid(link.name, collision, TOUCHED, TOUCHED_ALPHA, notes)


def part_solid(
    link: str, part: Visual | Collision, color: Color, alpha: float, notes: list[str]
) -> Iterator[Solid]:
    """One shape of a link; none if it is too large or too far away.

    Args:
        link: The link.
        part: The shape.
        color: Its colour.
        alpha: Its opacity, from 0 to 1.
        notes: Gets a sentence if it is not drawn as it is written.
    """
    shape = _shape(link, part.geometry, notes)
    if isinstance(part.geometry, Mesh) and isinstance(shape, Box):
        color, alpha = MISSING, min(alpha, 0.6)
    translation, rotation = part.origin.transform
    _, half = half_extents(shape)
    if not max(map(abs, (*translation, *half))) < _FAR or not all(map(math.isfinite, rotation)):
        notes.append(
            f"A shape of [{abbreviated(link, 44)}] is too large or too far away to be drawn."
        )
        return
    yield Solid(
        link=link,
        role=Role.VISUAL if isinstance(part, Visual) else Role.COLLISION,
        shape=shape,
        translation=translation,
        rotation=rotation,
        color=color,
        alpha=alpha,
    )


def painted(material: Material | None) -> tuple[Color, float] | None:
    """Colour and opacity of a material of URDF; None if it says nothing."""
    if material is None or material.rgba is None:
        return None
    red, green, blue, alpha = (min(max(value, 0.0), 1.0) for value in material.rgba)
    return (red, green, blue), alpha


def _shape(link: str, geometry: Geometry, notes: list[str]) -> SolidShape:
    if not isinstance(geometry, Mesh):
        return geometry
    try:
        if geometry.path is None:
            raise MeshError(geometry.problem or "it was not found")
        return drawn_mesh(geometry.path, geometry.scale)
    except MeshError as error:
        notes.append(
            f"A box of {_MISSING_SIZE:g} m stands for the mesh {abbreviated(geometry.filename, 80)} "
            f"of [{abbreviated(link, 44)}]: {error}."
        )
    return Box((_MISSING_SIZE,) * 3)


MAX_TRIANGLES = 200_000
"""More triangles than this would choke a notebook."""


def drawn_mesh(path: Path, scale: Vector) -> TriangleMesh:
    """The triangles of a file.

    Args:
        path: The file.
        scale: Factors along x, y and z.

    Raises:
        MeshError: It is not there, of another kind, broken, or too large.
    """
    mesh = read_mesh(path, scale)
    if len(mesh.triangles) > MAX_TRIANGLES:
        raise MeshError(f"it has {len(mesh.triangles)} triangles, more than {MAX_TRIANGLES}")
    low, high = (tuple(bound.tolist()) for bound in (mesh.vertices.min(0), mesh.vertices.max(0)))
    return TriangleMesh(
        vertices=mesh.vertices.astype("<f4").tobytes(),
        triangles=mesh.triangles.astype("<u4").tobytes(),
        low=(low[0], low[1], low[2]),
        high=(high[0], high[1], high[2]),
    )


_TRIALS: Final = 60
"So many positions of all joints are tried."
_MOST_SOLIDS: Final = 60
"Of a robot with more shapes, every second one is looked at, or every third, and so on."
_PRIMES: Final = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)
_SIDES: Final = tuple(side for side in itertools.product((-1, 0, 1), repeat=3) if any(side))


def robot_room(model: RobotInTf, solids: Sequence[Solid]) -> tuple[Vector, ...]:
    """Points on the outside of everywhere that a robot gets to, in the frame of its root [m].

    Args:
        model: The robot.
        solids: Its shapes, and perhaps those of others.
    """
    points = list(_points(model, solids[:: 1 + len(solids) // _MOST_SOLIDS]))
    if not points:
        return ()
    x, y, z = np.array(points).T
    # Sums in a fixed order, and the first of equals: the same points on every machine.
    farthest = [int(np.argmax(a * x + b * y + c * z)) for a, b, c in _SIDES]
    return tuple(dict.fromkeys(points[number] for number in farthest))


def _points(model: RobotInTf, solids: Sequence[Solid]) -> Iterator[Vector]:
    """The corners of the boxes around all shapes, for many positions of the joints."""
    robot = model.robot
    moving = [joint for joint in robot.joints.values() if joint.moves and joint.mimic is None]
    for trial in range(_TRIALS if moving else 1):
        positions = {joint.name: _position(joint, n, trial) for n, joint in enumerate(moving)}
        try:
            found = forward_kinematics(robot, positions)
        except SimkitError:
            return  # joints that mimic each other in a circle
        links = {model.frame(link): pose for link, pose in found.items()}
        for solid in solids:
            if solid.link in links:
                origin, rotation = links[solid.link]
                frame = FramePose(name="", parent=None, origin=origin, rotation=rotation)
                yield from corners(solid, frame)


def _position(joint: Joint, number: int, trial: int) -> float:
    """Where a joint stands [rad or m]; over all trials the joints are spread evenly, each in its own rhythm."""
    share = math.modf(trial * math.sqrt(_PRIMES[number % len(_PRIMES)]))[0]
    if joint.type is JointType.CONTINUOUS or joint.limit is None:
        return math.pi * (2.0 * share - 1.0)
    return joint.limit.lower + share * (joint.limit.upper - joint.limit.lower)
