"""The joints and links that plugins name: a rule on names that are not there, and the wheels that a drive turns."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.geometry import Transform, Vector
from simkit.plugins.registry import Names, TagField, plugins, tags_of
from simkit.plugins.tags import DiffDriveParameters, SkidSteerDriveParameters
from simkit.urdf.rules.bodies import Standing, parents_by_fixed_joint, standing_shapes, zero_pose
from simkit.urdf.rules.entries import JointEntry, PluginElement
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.tree_facts import is_whole
from simkit.urdf.rules.wording import listed, meant, quoted, read_number
from simkit.urdf.wheel import round_part
from simkit.xml import Element

_SHOWN = 8


def moving_joints(sheet: Sheet) -> list[str]:
    """The joints that one number moves, in the order of the file."""
    return [joint.name for joint in sheet.joints if joint.moves and joint.name]


def joint_advice(sheet: Sheet, name: str, moving: Sequence[str]) -> str:
    """Which joint may be meant, or which ones there are."""
    return meant(sheet.near(name, moving)).strip() or known_names("joints that move", moving)


def known_names(kind: str, names: Sequence[str]) -> str:
    """What there is of a kind, in a sentence."""
    more = f", and {len(names) - _SHOWN} more" if len(names) > _SHOWN else ""
    return (
        f"There are the {kind}: {listed(names[:_SHOWN])}{more}."
        if names
        else f"There are no {kind}."
    )


@rule("GZ-E09", "a plugin that names a joint or link that is not there", Severity.ERROR)
def plugin_names_nothing(sheet: Sheet) -> Iterator[Find]:
    """A plugin names a joint or link that is not there.

    Symptom: `couldn't get wheel hinge joint named ...`, and the robot does not drive; or a scan that RViz cannot show,
    since there is no transform for its frame.

    Cause: A misspelt name, or none at all: then the plugin takes a default name, such as `left_joint`. A joint of type
    fixed is gone in Gazebo.

    Remedy: The name of a joint or link of this robot.

    Right:

        <leftJoint>joint_left_wheel</leftJoint>
        <robotBaseFrame>link_chassis</robotBaseFrame>
    """
    known = {*sheet.link_by_name, *sheet.joint_by_name}
    lumped = parents_by_fixed_joint(sheet)
    moving = {one.name: None for one in sheet.joints if one.name and one.type != "fixed"}
    for plugin in sheet.plugins:
        reference = plugin.gazebo.reference
        if reference and reference not in known:
            continue  # the whole block is lost, which another rule tells
        known_plugin = plugins().get(plugin.filename or "")
        for tag in () if known_plugin is None else known_plugin.tags.values():
            name, kind = tag.name, tag.names
            element = plugin.parameter(name)
            value = tag.default if element is None else element.text.strip()
            is_said = element is not None and kind is Names.JOINT
            if not (value or is_said) or (element is None and value == "world"):
                continue
            if kind is Names.JOINT and value not in moving:
                yield _no_joint(sheet, plugin, name, value, [*moving])
            elif kind is Names.LINK and value not in sheet.link_by_name:
                yield _no_link(sheet, plugin, name, value)
            elif kind is Names.LINK and value in lumped and element is not None:
                yield _lumped_link(element, value, lumped)
            elif kind is Names.FRAME and value.lstrip("/") not in sheet.link_by_name:
                yield _no_frame(sheet, plugin, name, value)


def _no_joint(
    sheet: Sheet, plugin: PluginElement, name: str, value: str, moving: list[str]
) -> Find:
    element = plugin.parameter(name)
    joint = sheet.joint_by_name.get(value)
    what = f"<{name}> names {quoted(value)}, and there is no such joint"
    if joint is not None:
        what = f"<{name}> names {quoted(value)}, which is a fixed joint"
    elif element is None:
        what = f"<{name}> is missing, so the plugin looks for a joint {quoted(value)}, and there is none"
    remedy = _name_remedy(sheet, "joints that move", value, moving)
    if element is None:
        remedy = f"Add <{name}>...</{name}>. {known_names('joints that move', moving)}"
    return Find(
        plugin.element if element is None else Part(element),
        what=what,
        here="simkit refuses to start the plugin.",
        gazebo="The plugin does not load: couldn't get wheel hinge joint.",
        remedy=remedy,
        related=() if joint is None else [(joint.element, "a fixed joint is gone in Gazebo")],
    )


def _no_link(sheet: Sheet, plugin: PluginElement, name: str, value: str) -> Find:
    element = plugin.parameter(name)
    return Find(
        plugin.element if element is None else Part(element),
        what=f"<{name}> names {quoted(value)}, and there is no such link",
        here="simkit refuses to start the plugin.",
        gazebo="The plugin stops: the body does not exist.",
        remedy=_name_remedy(
            sheet, "links", value, [link.name for link in sheet.links if link.name]
        ),
    )


def _lumped_link(element: Element, value: str, lumped: dict[str, str]) -> Find:
    leader = lumped[value]
    for _ in lumped:
        if leader not in lumped:
            break
        leader = lumped[leader]
    return Find(
        Part(element),
        severity=Severity.NOTE,
        what=f"<{element.name}> names {quoted(value)}, a link on a fixed joint",
        here="simkit keeps the link.",
        gazebo=f"Gazebo makes it one body with {quoted(leader)}, and the plugin does not find it.",
        remedy=f"Name {quoted(leader)}, or keep the link with <preserveFixedJoint> in the <gazebo> of its joint.",
    )


def _no_frame(sheet: Sheet, plugin: PluginElement, name: str, value: str) -> Find:
    element = plugin.parameter(name)
    what = f"<{name}> names {quoted(value)}, and no link has that name"
    if element is None:
        what = (
            f"<{name}> is missing, so the plugin takes {quoted(value)}, and no link has that name"
        )
    return Find(
        plugin.element if element is None else Part(element),
        severity=Severity.WARNING,
        what=what,
        here="Its messages are in a frame that TF does not know, so the view cannot place them.",
        gazebo="Its messages are in a frame that TF does not know, so RViz cannot show them.",
        remedy=_name_remedy(
            sheet, "links", value, [link.name for link in sheet.links if link.name]
        ),
    )


def _name_remedy(sheet: Sheet, kind: str, name: str, known: list[str]) -> str:
    return meant(sheet.near(name, known)).strip() or known_names(kind, known)


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
