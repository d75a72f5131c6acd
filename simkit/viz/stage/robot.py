"""The shapes of a robot, in the colours that RViz gives them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from simkit.geometry import Vector
from simkit.urdf import Box, Collision, Geometry, Link, Material, Mesh, Robot, Visual
from simkit.urdf.mesh_file import MeshError, load_mesh
from simkit.viz.draw.letters import shortened
from simkit.viz.stage.solid import Color, Role, Solid, SolidShape, TriangleMesh, half_extents

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
    """Several robots as one thing to draw; a sentence for several of them is told once."""
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
            f"A shape of [{shortened(link, 44)}] is too large or too far away to be drawn."
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
        return read_mesh(geometry.path, geometry.scale)
    except MeshError as error:
        notes.append(
            f"A box of {_MISSING_SIZE:g} m stands for the mesh {shortened(geometry.filename, 80)} "
            f"of [{shortened(link, 44)}]: {error}."
        )
    return Box((_MISSING_SIZE,) * 3)


MAX_TRIANGLES = 200_000
"""More triangles than this would choke a notebook."""


def read_mesh(path: Path, scale: Vector) -> TriangleMesh:
    """The triangles of a file.

    Args:
        path: The file.
        scale: Factors along x, y and z.

    Raises:
        MeshError: It is not there, of another kind, broken, or too large.
    """
    mesh = load_mesh(path)
    if len(mesh.faces) > MAX_TRIANGLES:
        raise MeshError(f"it has {len(mesh.faces)} triangles, more than {MAX_TRIANGLES}")
    return _packed(mesh, scale)


def _packed(mesh: Any, scale: Vector) -> TriangleMesh:
    import numpy as np

    vertices = np.asarray(mesh.vertices, dtype=float) * np.array(scale)
    triangles = np.asarray(mesh.faces)
    if not np.isfinite(vertices).all() or triangles.min() < 0 or triangles.max() >= len(vertices):
        raise MeshError("it is broken (numbers that are none)")
    if np.prod(scale) < 0.0:
        triangles = triangles[:, ::-1]  # a mirror turns the inside out
    low, high = (tuple(map(float, bound)) for bound in (vertices.min(0), vertices.max(0)))
    return TriangleMesh(
        vertices=vertices.astype("<f4").tobytes(),
        triangles=triangles.astype("<u4").tobytes(),
        low=(low[0], low[1], low[2]),
        high=(high[0], high[1], high[2]),
    )
