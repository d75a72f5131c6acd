"""What an SDF file says, in plain values: metres, radians, kilograms, seconds.

Poses are relative to what their element stands in: a collision's to its link, a link's to its
model, a model's to the world.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias

from simkit.diagnostics import Diagnostic
from simkit.geometry import Vector
from simkit.physics.plan import Plane
from simkit.urdf.model import Box, Cylinder, Inertial, Mesh, Pose, Rgba, Sphere
from simkit.xml import Element

HERE = Pose()
"""In the frame of what it stands in."""

SdfGeometry: TypeAlias = Box | Cylinder | Sphere | Plane | Mesh


@dataclass(frozen=True, slots=True, kw_only=True)
class SdfCollision:
    """What others touch of a link."""

    name: str
    """Its name."""
    geometry: SdfGeometry
    """Its shape."""
    pose: Pose = HERE
    """Where it is in the link."""
    friction: float = 1.0
    """`mu` of ODE."""
    across: float = 1.0
    """`mu2` of ODE: in the other direction."""
    retro: float = 0.0
    """Intensity that a laser sees."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SdfVisual:
    """What is seen of a link."""

    name: str
    """Its name."""
    geometry: SdfGeometry
    """Its shape; the size of a plane is that of its picture."""
    pose: Pose = HERE
    """Where it is in the link."""
    rgba: Rgba | None = None
    """Diffuse, or else ambient, colour; None if it has none."""
    material: str = ""
    """Name of a material of Gazebo, e.g. `Gazebo/Grey`; empty if it has none."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SdfLink:
    """A rigid body."""

    name: str
    """Its name."""
    pose: Pose = HERE
    """Where it is in the model."""
    inertial: Inertial | None = None
    """Mass and inertia; None for 1 kg and 1 kg m^2 about every axis."""
    collisions: tuple[SdfCollision, ...] = ()
    """What others touch of it."""
    visuals: tuple[SdfVisual, ...] = ()
    """What is seen of it."""
    gravity: bool = True
    """Whether it falls."""
    self_collide: bool | None = None
    """Whether it touches other links of its model; None: as the model says."""
    decay: float = 0.0
    """Share of its velocity that it loses in each millisecond."""
    sensors: tuple[Element, ...] = ()
    """Its sensors, as they are written."""
    element: Element
    """Where it is written."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SdfJoint:
    """How one link hangs on another."""

    name: str
    """Its name."""
    type: str
    """`fixed`, `revolute` or `prismatic`."""
    parent: str
    """Link that it hangs on, or `world`."""
    child: str
    """Link that hangs on it."""
    pose: Pose = HERE
    """Where it is in the child."""
    axis: Vector = (0.0, 0.0, 1.0)
    """Its axis, as written."""
    axis_in_model: bool = False
    """Whether the axis is given in the frame of the model, not of the joint."""
    lower: float = -math.inf
    """Smallest position [rad or m]."""
    upper: float = math.inf
    """Largest position [rad or m]."""
    effort: float = math.inf
    """Largest effort [N m or N]."""
    velocity: float = math.inf
    """Largest speed [rad/s or m/s]."""
    damping: float = 0.0
    """[N m s/rad or N s/m]."""
    friction: float = 0.0
    """[N m or N]."""
    stiffness: float = 0.0
    """Of a spring [N m/rad or N/m]."""
    rest: float = 0.0
    """Where the spring is at rest [rad or m]."""
    element: Element
    """Where it is written."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SdfModel:
    """A robot, or a thing."""

    name: str
    """Its name in the world."""
    pose: Pose = HERE
    """Where it is in the world."""
    is_static: bool = False
    """Whether nothing moves it."""
    self_collide: bool = False
    """Whether its links touch each other, if they do not say otherwise."""
    links: tuple[SdfLink, ...] = ()
    """Its links, in the order of the file."""
    joints: tuple[SdfJoint, ...] = ()
    """Its joints, in the order of the file."""
    plugins: tuple[Element, ...] = ()
    """Its plugins, as they are written."""
    uri: str = ""
    """What it was included from, e.g. `model://ground_plane`; empty if it was written in place."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SdfLight:
    """A lamp."""

    name: str
    """Its name."""
    type: str = "point"
    """`point`, `directional` or `spot`."""
    pose: Pose = HERE
    """Where it is in the world."""
    diffuse: Rgba = (1.0, 1.0, 1.0, 1.0)
    """Its colour."""
    direction: Vector = (0.0, 0.0, -1.0)
    """Where it shines, if it is not a point."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SdfWorld:
    """A world file."""

    name: str
    """Its name."""
    gravity: Vector
    """Acceleration of all that falls [m/s^2]."""
    step_ns: int
    """Time of one step [ns]."""
    models: tuple[SdfModel, ...] = ()
    """Its models, in the order of the file."""
    lights: tuple[SdfLight, ...] = ()
    """Its lamps, in the order of the file."""
    plugins: tuple[Element, ...] = ()
    """Plugins of the world itself, as they are written."""
    diagnostics: tuple[Diagnostic, ...] = ()
    """What is not read, or not as it is written, with its place."""
