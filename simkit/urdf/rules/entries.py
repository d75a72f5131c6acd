"""What a sheet lists: links, joints and their parts, as far as they could be read.

A number, name or vector is None where it is missing or unreadable; where URDF has a default and the attribute or element
is missing, it is the default. Lengths in metres, angles in radians, masses in kilograms. Each entry has the element that
it was read from, for places: `entry.element.span_of("lower")`.
"""

from __future__ import annotations

from dataclasses import dataclass

from simkit.geometry import Vector
from simkit.urdf.model import Geometry, Rgba
from simkit.xml import Element


@dataclass(frozen=True, kw_only=True)
class OriginEntry:
    """An `<origin>`; all zero if there is none."""

    element: Element | None
    """The `<origin>`; None if there is none."""
    xyz: Vector | None = (0.0, 0.0, 0.0)
    """[m]."""
    rpy: Vector | None = (0.0, 0.0, 0.0)
    """Roll, pitch, yaw about fixed axes [rad]."""


@dataclass(frozen=True, kw_only=True)
class BodyEntry:
    """A `<visual>` or `<collision>`."""

    element: Element
    is_visual: bool
    """Whether it is a `<visual>`."""
    origin: OriginEntry
    geometry_element: Element | None
    """The `<geometry>`; None if there is none."""
    shape_element: Element | None
    """The first element in it, whatever it is; None if there is none."""
    shape: Geometry | None
    """The shape; None if it is missing, unknown or its numbers cannot be read. Sizes may be negative or zero."""
    material_element: Element | None = None
    """The `<material>` of a visual; None if there is none."""


@dataclass(frozen=True, kw_only=True)
class InertialEntry:
    """An `<inertial>`."""

    element: Element
    origin: OriginEntry
    mass_element: Element | None
    """The `<mass>`; None if there is none."""
    mass: float | None
    """[kg]; may be negative or zero."""
    inertia_element: Element | None
    """The `<inertia>`; None if there is none."""
    tensor: tuple[float, float, float, float, float, float] | None
    """ixx, ixy, ixz, iyy, iyz, izz [kg m^2], about the centre of mass; None unless all can be read."""


@dataclass(frozen=True, kw_only=True)
class LinkEntry:
    """A `<link>`."""

    element: Element
    name: str | None
    """None if it has none, or an empty one."""
    inertial: InertialEntry | None
    """The first one; None if there is none."""
    visuals: tuple[BodyEntry, ...]
    collisions: tuple[BodyEntry, ...]


@dataclass(frozen=True, kw_only=True)
class LimitEntry:
    """A `<limit>`."""

    element: Element
    lower: float | None
    """[rad or m]; 0 if it is not there, as all of these."""
    upper: float | None
    effort: float | None
    """[N m or N]; None if it is not there."""
    velocity: float | None
    """[rad/s or m/s]; None if it is not there."""


@dataclass(frozen=True, kw_only=True)
class JointEntry:
    """A `<joint>` of the robot."""

    element: Element
    name: str | None
    """None if it has none, or an empty one."""
    type: str | None
    """As written; one of `JOINT_TYPES` or anything else. None if it has none."""
    parent_element: Element | None
    parent: str | None
    """Name of the parent link, whether or not there is such a link."""
    child_element: Element | None
    child: str | None
    """Name of the child link, whether or not there is such a link."""
    origin: OriginEntry
    axis_element: Element | None
    axis: Vector | None
    """(1, 0, 0) if there is no `<axis>`, and (0, 0, 0) if it has no `xyz`, as urdfdom has it; may be of any length."""
    limit: LimitEntry | None
    dynamics_element: Element | None
    mimic_element: Element | None

    @property
    def moves(self) -> bool:
        """Whether one number says where it stands."""
        return self.type in ("revolute", "continuous", "prismatic")


@dataclass(frozen=True, kw_only=True)
class MaterialEntry:
    """A `<material>` of the robot or of a visual."""

    element: Element
    name: str | None
    """None if it has none; may be empty."""
    is_global: bool
    """Whether it stands in the robot, not in a visual."""
    color_element: Element | None
    rgba: Rgba | None
    """None if it has no colour or it cannot be read; may be out of range."""
    texture: str | None


@dataclass(frozen=True, kw_only=True)
class GazeboEntry:
    """A `<gazebo>` of the robot."""

    element: Element
    reference: str | None
    """Link or joint that it belongs to, as written; None if it belongs to the robot."""


@dataclass(frozen=True, kw_only=True)
class PluginElement:
    """A `<plugin>` anywhere in a `<gazebo>`."""

    element: Element
    gazebo: GazeboEntry
    """The `<gazebo>` that it is in."""
    name: str | None
    filename: str | None
    """As written, e.g. `libgazebo_ros_control.so`."""

    def parameter(self, name: str) -> Element | None:
        """The element of that name in it."""
        return self.element.child(name)


@dataclass(frozen=True, kw_only=True)
class TransmissionEntry:
    """A `<transmission>`."""

    element: Element
    name: str | None
    type: str | None
    """The text of its `<type>`, e.g. `transmission_interface/SimpleTransmission`."""
    joints: tuple[Element, ...]
    """Its `<joint>`s; each with attribute `name` and elements `hardwareInterface`."""
    actuators: tuple[Element, ...]
