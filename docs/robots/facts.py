"""What is to be known of a robot: its parts, its weight, its size, and what check_urdf says of it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from simkit.diagnostics import Diagnostic
from simkit.geometry import Transform, Vector
from simkit.packages import PackagePath
from simkit.urdf import Box, Cylinder, Robot, Sphere, check_urdf_text, read_robot
from simkit.urdf.placed_shape import PlacedShape
from simkit.urdf.rules import check_robot


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotFacts:
    """One robot of the folder `robots`, with all joints at 0."""

    path: Path
    """Its file."""
    purpose: str
    """What its first comment says."""
    robot: Robot
    """The robot."""
    mass: float
    """Mass of all links [kg]; 0 if none has one."""
    centre: Vector
    """Centre of mass in the root link [m]; without meaning if there is no mass."""
    low: Vector
    """Lowest x, y and z of its shapes in the root link [m]."""
    high: Vector
    """Highest x, y and z of its shapes in the root link [m]."""
    printed: str
    """Standard output of check_urdf."""
    finds: tuple[Diagnostic, ...]
    """What the rules find."""

    @property
    def stem(self) -> str:
        """Name of its file without the ending."""
        return self.path.stem

    @property
    def package(self) -> str:
        """Name of its package."""
        return self.path.parts[-3]

    @property
    def place_in_course(self) -> tuple[str, int]:
        """Chapter and number of its exercise; robots stand in this order, those without an exercise last."""
        found = re.search(r"Exercise (\w+)\.(\d+)", self.purpose)
        return (found[1], int(found[2])) if found else ("~", 0)


def facts_of(path: Path, packages: PackagePath) -> RobotFacts:
    """The facts of a robot.

    Args:
        path: Its file.
        packages: Where its package is.

    Raises:
        SystemExit: ROS refuses a part of it, so no page is written.
    """
    reading = read_robot(path.read_bytes(), file=path.name, packages=packages, folder=path.parent)
    printed, complaints, _ = check_urdf_text(reading)
    if reading.robot is None or complaints:
        raise SystemExit(f"{path}: check_urdf says\n{complaints}")
    frames = _frames(reading.robot)
    mass, centre = _weight(reading.robot, frames)
    low, high = _bounds(list(_shapes(reading.robot, frames)))
    return RobotFacts(
        path=path,
        purpose=_first_comment(path.read_text(encoding="utf-8")),
        robot=reading.robot,
        mass=mass,
        centre=centre,
        low=low,
        high=high,
        printed=printed,
        finds=check_robot(reading.document, packages=packages, folder=path.parent),
    )


def _first_comment(text: str) -> str:
    found = re.search(r"<!--(.*?)-->", text, re.DOTALL)
    return " ".join(found[1].split()) if found else ""


def _frames(robot: Robot) -> dict[str, Transform]:
    """T_root_link of each link, with all joints at 0."""
    found = {robot.root: Transform()}
    waiting = [robot.root]
    for link in waiting:
        for joint in robot.joints_below(link):
            found[joint.child] = found[link] @ joint.origin.transform
            waiting.append(joint.child)
    return found


def _weight(robot: Robot, frames: dict[str, Transform]) -> tuple[float, Vector]:
    """Mass [kg], and centre of mass in the root link [m]."""
    parts = [
        (link.inertial.mass, frames[name].apply(link.inertial.origin.xyz))
        for name, link in robot.links.items()
        if link.inertial is not None
    ]
    mass = sum(weight for weight, _ in parts)
    x, y, z = (sum(weight * place[axis] for weight, place in parts) for axis in range(3))
    return mass, (x / mass, y / mass, z / mass) if mass else (0.0, 0.0, 0.0)


def _bounds(shapes: list[PlacedShape]) -> tuple[Vector, Vector]:
    """The corners of the box around some shapes [m]."""
    ways = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    x, y, z = (max(shape.support(way)[axis] for shape in shapes) for axis, way in enumerate(ways))
    ways = ((-1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0))
    a, b, c = (min(shape.support(way)[axis] for shape in shapes) for axis, way in enumerate(ways))
    return (a, b, c), (x, y, z)


def _shapes(robot: Robot, frames: dict[str, Transform]) -> Iterator[PlacedShape]:
    """All shapes that have a formula, seen and touched, in the root link."""
    for name, link in robot.links.items():
        for part in (*link.visuals, *link.collisions):
            if isinstance(part.geometry, Box | Cylinder | Sphere):
                inner = PlacedShape(part.geometry, part.origin.transform)
                yield inner.seen_from(frames[name])
