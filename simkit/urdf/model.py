"""A robot as URDF describes it: links, joints, shapes, materials, in metres, radians and kilograms.

Source: the URDF specification, and what urdfdom makes of a file.
"""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

from simkit.geometry import Transform, Vector
from simkit.xml import Document, Element

Rgba: TypeAlias = tuple[float, float, float, float]


class Pose(NamedTuple):
    """Where something is in the frame of what it belongs to, as an `<origin>` is written."""

    xyz: Vector = (0.0, 0.0, 0.0)
    """Its origin [m]."""
    rpy: Vector = (0.0, 0.0, 0.0)
    """Roll, pitch, yaw about the fixed axes x, y, z [rad]; R = Rz Ry Rx."""

    @property
    def transform(self) -> Transform:
        """The same as a transform."""
        return Transform.from_rpy(self.xyz, self.rpy)


IDENTITY_POSE = Pose()
"""Where what it belongs to is."""


@dataclass(frozen=True)
class Box:
    """A box around its origin."""

    size: Vector
    """Lengths along x, y, z [m]."""


@dataclass(frozen=True)
class Cylinder:
    """A cylinder around its origin, standing along z."""

    radius: float
    """Radius [m]."""
    length: float
    """Length along z [m]."""


@dataclass(frozen=True)
class Sphere:
    """A sphere around its origin."""

    radius: float
    """Radius [m]."""


@dataclass(frozen=True)
class Mesh:
    """A shape from a file."""

    filename: str
    """As it is written: `package://hello_ros/meshes/hand.stl`, `file:///...`, or relative to the URDF."""
    scale: Vector = (1.0, 1.0, 1.0)
    """Factors along x, y, z."""
    path: Path | None = None
    """The file; None if it was not found."""
    problem: str = ""
    """Why it was not found, with the places that were tried; empty if it was."""


Geometry: TypeAlias = Box | Cylinder | Sphere | Mesh


@dataclass(frozen=True)
class Material:
    """A named colour, or picture."""

    name: str
    """Its name; may be empty."""
    rgba: Rgba | None = None
    """Red, green, blue, opacity, each from 0 to 1; None if it is not defined."""
    texture: str | None = None
    """File name of a picture."""


@dataclass(frozen=True, kw_only=True)
class Visual:
    """What is seen of a link."""

    geometry: Geometry
    """Its shape."""
    origin: Pose = IDENTITY_POSE
    """Where the shape is in the frame of the link."""
    name: str = ""
    """Its name; mostly empty."""
    material: Material | None = None
    """Its material, looked up: of several definitions of a name the first one; None if it has none."""


@dataclass(frozen=True, kw_only=True)
class Collision:
    """What other things touch of a link."""

    geometry: Geometry
    """Its shape."""
    origin: Pose = IDENTITY_POSE
    """Where the shape is in the frame of the link."""
    name: str = ""
    """Its name; mostly empty."""


@dataclass(frozen=True, kw_only=True)
class Inertial:
    """How heavy a link is, and how hard to turn."""

    mass: float
    """Mass [kg]."""
    origin: Pose = IDENTITY_POSE
    """Its centre of mass, and the axes that the tensor is given in."""
    ixx: float = 0.0
    """About its centre of mass [kg m^2], as all of these."""
    ixy: float = 0.0
    ixz: float = 0.0
    iyy: float = 0.0
    iyz: float = 0.0
    izz: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Link:
    """A rigid body."""

    name: str
    """Its name, also that of its frame."""
    inertial: Inertial | None = None
    """Mass and inertia; None if it has none."""
    visuals: tuple[Visual, ...] = ()
    """What is seen of it."""
    collisions: tuple[Collision, ...] = ()
    """What others touch of it."""
    element: Element
    """Where it is written."""


class JointType(enum.Enum):
    """How a child link moves against its parent."""

    FIXED = "fixed"
    REVOLUTE = "revolute"
    CONTINUOUS = "continuous"
    PRISMATIC = "prismatic"
    FLOATING = "floating"
    PLANAR = "planar"


@dataclass(frozen=True, kw_only=True)
class Limit:
    """How far, how strong, how fast."""

    lower: float = 0.0
    """Smallest position [rad or m]."""
    upper: float = 0.0
    """Largest position [rad or m]."""
    effort: float
    """Largest torque or force [N m or N]."""
    velocity: float
    """Largest speed [rad/s or m/s]."""


@dataclass(frozen=True, kw_only=True)
class Safety:
    """Soft limits."""

    soft_lower: float = 0.0
    """[rad or m]."""
    soft_upper: float = 0.0
    """[rad or m]."""
    k_position: float = 0.0
    k_velocity: float


@dataclass(frozen=True, kw_only=True)
class Mimic:
    """A joint that follows another: position = multiplier * that of the other + offset."""

    joint: str
    """The joint that it follows."""
    multiplier: float = 1.0
    offset: float = 0.0
    """[rad or m]."""


@dataclass(frozen=True, kw_only=True)
class Joint:
    """How a child link hangs on its parent."""

    name: str
    """Its name."""
    type: JointType
    """How it moves."""
    parent: str
    """Link that it hangs on."""
    child: str
    """Link that hangs on it."""
    origin: Pose = IDENTITY_POSE
    """Frame of the child at position 0, in the frame of the parent."""
    axis: Vector = (1.0, 0.0, 0.0)
    """Axis in the frame of the child, as written; not always of unit length."""
    limit: Limit | None = None
    damping: float = 0.0
    """[N m s/rad or N s/m]."""
    friction: float = 0.0
    """[N m or N]."""
    mimic: Mimic | None = None
    safety: Safety | None = None
    element: Element
    """Where it is written."""

    @property
    def moves(self) -> bool:
        """Whether one number says where it stands: revolute, continuous, prismatic."""
        return self.type in (JointType.REVOLUTE, JointType.CONTINUOUS, JointType.PRISMATIC)


@dataclass(frozen=True, kw_only=True)
class Robot:
    """A whole robot: a tree of links."""

    name: str
    """Its name."""
    links: Mapping[str, Link]
    """By name, in the order of the file."""
    joints: Mapping[str, Joint]
    """By name, in the order of the file."""
    materials: Mapping[str, Material]
    """By name: those of the robot, then those that a visual defines for the first time."""
    root: str
    """The link that hangs on nothing."""
    document: Document
    """What it was read from; `<gazebo>` and `<transmission>` are found there."""

    def yourdfpy(self) -> Any:
        """The same robot as a `yourdfpy.URDF`: its `scene` is one of trimesh, to be looked at or exported."""
        from simkit.urdf.yourdfpy_robot import yourdfpy_robot

        return yourdfpy_robot(self)

    def joints_below(self, link: str) -> tuple[Joint, ...]:
        """The joints that have a link as parent, by joint name, as urdfdom keeps them."""
        return tuple(
            self.joints[name] for name in sorted(self.joints) if self.joints[name].parent == link
        )

    def joint_above(self, link: str) -> Joint | None:
        """The joint that has a link as child, of several the last one by name, as urdfdom; None for the root."""
        names = [joint.name for joint in self.joints.values() if joint.child == link]
        return self.joints[max(names)] if names else None
