"""Plans: what the engine shall build, in plain numbers that have been checked.

URDF and SDF both become a plan; only plans reach the engine. All is in metres, kilograms, radians.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TypeAlias

from simkit.geometry import Transform, Vector
from simkit.physics.errors import ModelError
from simkit.physics.mesh import CollisionMesh
from simkit.urdf.inertia import Body
from simkit.urdf.model import Box, Cylinder, Pose, Sphere

LARGEST = 1e9
"""Larger numbers [m, kg, kg m^2] are no robot, and leave the range in which computers are exact."""
FAR = 1e4
"""Larger lengths [m] belong to no robot."""
HERE = Transform()
"""The frame itself."""


@dataclass(frozen=True, slots=True)
class Plane:
    """All that lies below a plane through the origin of its frame."""

    normal: Vector = (0.0, 0.0, 1.0)
    """Unit vector that points out of it."""


Solid: TypeAlias = Box | Cylinder | Sphere | Plane
"""What the engine computes contacts of; a cylinder stands along z."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ShapePlan:
    """One shape that others touch."""

    name: str
    """Its name, as Gazebo would call it."""
    link: str
    """The link of the file that it belongs to."""
    solid: Solid
    """Its shape; of a mesh the solid that stands in for it."""
    frame: Transform = HERE
    """Where the solid is in the frame of its body."""
    friction: float = 1.0
    """Coefficient of friction; of two that touch the smaller one counts."""
    retro: float = 0.0
    """Intensity that a laser sees."""
    mesh: CollisionMesh | None = None
    """The triangles that a laser sees instead of the solid."""
    mesh_frame: Transform = HERE
    """Where the mesh is in the frame of its body."""


@dataclass(frozen=True, slots=True, kw_only=True)
class BodyPlan:
    """One rigid body: a link, with all that fixed joints hold on it."""

    name: str
    """Name of the link that it takes its frame from."""
    body: Body
    """Mass, centre and inertia in its frame."""
    shapes: tuple[ShapePlan, ...] = ()
    """What others touch."""
    gravity: bool = True
    """Whether it falls."""
    self_collide: bool = False
    """Whether it touches other bodies of its model."""
    decay: float = 0.0
    """Share of its velocity that it loses in each millisecond."""


class JointKind(enum.Enum):
    """How a body may move."""

    FIXED = "fixed"
    """Not at all."""
    REVOLUTE = "revolute"
    """It turns about an axis; without limits it is continuous."""
    PRISMATIC = "prismatic"
    """It slides along an axis."""
    FREE = "free"
    """Anyhow."""


@dataclass(frozen=True, slots=True, kw_only=True)
class JointPlan:
    """How one body hangs on another."""

    name: str
    """Its name; of what is free the name of its body."""
    kind: JointKind
    """How it moves."""
    parent: str | None
    """Body that it hangs on; None for the world."""
    child: str
    """Body that hangs on it."""
    frame: Transform = HERE
    """Transform of the child at position 0 in that of the parent; in that of the model if the parent is the world."""
    anchor: Transform = HERE
    """Where the joint is in the frame of the child; a URDF has it in its origin."""
    axis: Vector = (1.0, 0.0, 0.0)
    """Unit vector in the frame of the joint."""
    lower: float = -math.inf
    """Smallest position [rad or m]."""
    upper: float = math.inf
    """Largest position [rad or m]."""
    effort: float = math.inf
    """Largest effort of a motor [N m or N]."""
    velocity: float = math.inf
    """No effort drives it beyond this speed [rad/s or m/s]."""
    damping: float = 0.0
    """[N m s/rad or N s/m]."""
    friction: float = 0.0
    """Dry friction [N m or N]."""
    stiffness: float = 0.0
    """Of a spring [N m/rad or N/m]."""
    rest: float = 0.0
    """Where the spring is at rest [rad or m]."""

    @property
    def moves(self) -> bool:
        """Whether one number says where it stands."""
        return self.kind in (JointKind.REVOLUTE, JointKind.PRISMATIC)


@dataclass(frozen=True, slots=True, kw_only=True)
class Mount:
    """Where a link is that has become part of a body."""

    body: str
    """The body."""
    frame: Transform
    """T_body_link."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ModelPlan:
    """One model."""

    name: str
    """Its name in the file."""
    bodies: Mapping[str, BodyPlan]
    """By name, parents before their children."""
    joints: Mapping[str, JointPlan]
    """By name, parents before their children; each body hangs on exactly one."""
    mounts: Mapping[str, Mount] = field(default_factory=dict)
    """Every link that is simulated, by name."""
    is_static: bool = False
    """Whether nothing moves it."""
    notes: tuple[str, ...] = ()
    """What is not as the file says, and why."""


def check_numbers(numbers: Iterable[float], what: str) -> None:
    """See that numbers are numbers, and of this world.

    Raises:
        ModelError: One is infinite, not a number, or beyond all size.
    """
    for number in numbers:
        if not math.isfinite(number) or abs(number) > LARGEST:
            raise ModelError(f"{what} holds {number:g}, which no simulator can compute with")


def check_lengths(lengths: Iterable[float], what: str) -> None:
    """See that lengths [m] are such of a robot.

    Raises:
        ModelError: One is not a number, or longer than 10 km.
    """
    for length in lengths:
        if not abs(length) <= FAR:
            raise ModelError(
                f"{what} has a length of {length:g} m, which no simulator can compute with"
            )


def check_pose(pose: Pose, what: str) -> None:
    """See that a pose is one.

    Raises:
        ModelError: A number of it is NaN or too large.
    """
    check_lengths(pose.xyz, what)
    check_numbers(pose.rpy, what)
