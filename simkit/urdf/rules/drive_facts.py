"""The wheels that a drive plugin turns: where they are, which way they turn, how large they are."""

from __future__ import annotations

import math
from dataclasses import dataclass

from simkit.geometry import Transform, Vector
from simkit.plugins.registry import TagField, tags_of
from simkit.plugins.tags import DiffDriveParameters, SkidSteerDriveParameters
from simkit.urdf.rules.bodies import Standing, standing_shapes, zero_pose
from simkit.urdf.rules.entries import JointEntry, PluginElement
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.tree_facts import is_whole
from simkit.urdf.rules.wording import read_number
from simkit.urdf.wheel import round_part
from simkit.xml import Element

_DRIVES: dict[str, type[DiffDriveParameters | SkidSteerDriveParameters]] = {
    "libgazebo_ros_diff_drive.so": DiffDriveParameters,
    "libgazebo_ros_skid_steer_drive.so": SkidSteerDriveParameters,
}


@dataclass(frozen=True, kw_only=True)
class Wheel:
    """One driven wheel, all joints at 0, seen from the base frame of the robot."""

    joint: JointEntry
    """The joint that is turned."""
    element: Element
    """Where the plugin names it; the plugin itself if it does not."""
    middle: Vector
    """Middle of its round shape; origin of the joint if it has none [m]."""
    axis: Vector
    """What it turns about, of length 1; all 0 if that cannot be read."""
    radius: float | None
    """[m]; None if it has no round shape."""
    lowest: float | None
    """z of its lowest point, seen from the root link [m]; None if it touches nothing."""


@dataclass(frozen=True, kw_only=True)
class Drive:
    """A drive plugin whose joints all exist."""

    plugin: PluginElement
    left: tuple[Wheel, ...]
    right: tuple[Wheel, ...]
    base: str
    """The link that all is seen from."""

    @property
    def wheels(self) -> tuple[Wheel, ...]:
        """All of them, the left ones first."""
        return (*self.left, *self.right)

    def number(self, name: str) -> float | None:
        """A parameter, or its default; None if it is not read or is no number."""
        tag = next((one for one in self._tags.values() if one.name == name), None)
        element = self.plugin.parameter(name)
        if element is not None and tag is not None:
            return read_number(element.text)
        return None if tag is None else float(tag.default)

    def place(self, name: str) -> Element:
        """Where a parameter stands; the plugin if it is not given."""
        return self.plugin.parameter(name) or self.plugin.element

    @property
    def torque_name(self) -> str:
        """What this plugin calls its torque."""
        return self._tags[_DRIVES[self.plugin.filename or ""].TORQUE].name

    @property
    def _tags(self) -> dict[str, TagField]:
        return tags_of(_DRIVES[self.plugin.filename or ""])


def drives(sheet: Sheet) -> list[Drive]:
    """The drive plugins of a robot whose wheels can be found."""
    found = []
    plugins = [plugin for plugin in sheet.plugins if plugin.filename in _DRIVES]
    if not plugins or not is_whole(sheet):
        return []
    standing = zero_pose(sheet)
    for plugin in plugins[:20]:
        base = _base(sheet, plugin, standing)
        kind = _DRIVES[plugin.filename or ""]
        tags = tags_of(kind)
        sides = [
            tuple(_wheel(sheet, plugin, tags[field].name, standing, base) for field in side)
            for side in kind.SIDES
        ]
        left, right = (tuple(wheel for wheel in side if wheel is not None) for side in sides)
        if base is not None and all(None not in side for side in sides):
            found.append(Drive(plugin=plugin, left=left, right=right, base=base))
    return found


def middle_of(wheels: tuple[Wheel, ...]) -> Vector:
    """The middle between some wheels [m]."""
    x, y, z = (sum(wheel.middle[axis] for wheel in wheels) / len(wheels) for axis in range(3))
    return (x, y, z)


def _base(sheet: Sheet, plugin: PluginElement, standing: dict[str, Standing]) -> str | None:
    """The base frame that the plugin names if it is a link, else the root of the tree."""
    element = plugin.parameter("robotBaseFrame")
    named = "" if element is None else element.text.strip().lstrip("/")
    if named in standing:
        return named
    return next((link.name for link in sheet.links if link.name in standing and sheet.is_root(link)), None)  # fmt: skip


def _wheel(
    sheet: Sheet,
    plugin: PluginElement,
    parameter: str,
    standing: dict[str, Standing],
    base: str | None,
) -> Wheel | None:
    element = plugin.parameter(parameter)
    joint = None if element is None else sheet.joint_by_name.get(element.text.strip())
    where = standing.get((joint.child if joint is not None else None) or "")
    if element is None or joint is None or where is None or base is None or not joint.moves:
        return None
    seen_from = standing[base]
    if seen_from.root != where.root:
        return None
    link = sheet.link_by_name[joint.child or ""]
    touched = standing_shapes(link.collisions, where)
    rolling = round_part((*touched, *standing_shapes(link.visuals, where)))
    middle = where.frame.translation if rolling is None else rolling[1].translation
    return Wheel(
        joint=joint,
        element=element,
        middle=seen_from.frame.apply_back(middle),
        axis=_axis(joint, seen_from.frame.inverse() @ where.frame),
        radius=None if rolling is None else rolling[0].radius,
        lowest=min((shape.lowest() for shape in touched), default=None),
    )


def _axis(joint: JointEntry, frame: Transform) -> Vector:
    x, y, z = frame.rotate(joint.axis or (0.0, 0.0, 0.0))
    length = math.hypot(x, y, z)
    return (x / length, y / length, z / length) if 0.0 < length < math.inf else (0.0, 0.0, 0.0)
