"""Rules about the names of links and joints that plugins are given."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.plugins.registry import Names, plugins
from simkit.urdf.rules.bodies import parents_by_fixed_joint
from simkit.urdf.rules.entries import PluginElement
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import listed, meant, quoted, shown
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


_PLUGIN = "libgazebo_ros_joint_state_publisher.so"


@rule("CTL-W06", "a list of joints that does not fit the robot", Severity.ERROR)
def listed_joints(sheet: Sheet) -> Iterator[Find]:
    """The list of joints in `<jointName>` does not fit the robot.

    Symptom: `No transform from [lower_arm]` in RViz: a part of the robot hangs in the air. Or Gazebo ends with `Joint ...
    does not exist!`.

    Cause: A joint was added to the robot and not to the list, or its name is misspelt. The list is one line, with commas
    between the names; blanks do not matter, line breaks do.

    Remedy: All joints that move, in one `<jointName>`.

    Right:

        <jointName>hip, shoulder, elbow</jointName>
    """
    plugins = [plugin for plugin in sheet.plugins if plugin.filename == _PLUGIN]
    listed_names: set[str] = set()
    for plugin in plugins:
        for element in plugin.element.all("jointName"):
            yield from _wrong_names(sheet, element, listed_names)
    mimicking = {joint.name for joint in sheet.joints if joint.mimic_element is not None}
    unlisted = [
        joint.name
        for joint in sheet.joints
        if joint.moves and joint.name and joint.name not in listed_names | mimicking
    ]
    first = next((found for one in plugins if (found := one.parameter("jointName"))), None)
    if first is not None and unlisted:
        every = ", ".join(moving_joints(sheet))
        yield Find(
            Part(first),
            severity=Severity.WARNING,
            what=f"the list of joints lacks {listed(unlisted)}",
            here="Nobody says where these joints are: the links below have no frame.",
            gazebo="Nobody says where these joints are: RViz shows no transform for the links below.",
            remedy=f"Write <jointName>{shown(every)}</jointName>.",
        )


def _wrong_names(sheet: Sheet, element: Element, listed_names: set[str]) -> Iterator[Find]:
    """What is wrong with the names in one list; the right ones are added to `listed_names`."""
    names = element.text.strip().replace(" ", "").split(",")
    moving = moving_joints(sheet)
    known = set(moving)
    one_line = shown(", ".join("".join(name.split()) for name in names))
    for name in names:
        bare = "".join(name.split())
        if bare in known:
            listed_names.add(bare)
            if bare == name:
                continue
            what = f"a line break or tab stands in the list of joints, next to {quoted(bare)}"
            remedy = f"Write the list in one line: {one_line}."
        elif not bare:
            what, remedy = "the list of joints has an empty name", "Leave out the needless comma."
        else:
            why = "which is fixed" if bare in sheet.joint_by_name else "and there is no such joint"
            what = f"the list of joints names {quoted(bare)}, {why}"
            remedy = joint_advice(sheet, bare, moving)
        yield Find(
            Part(element),
            what=what,
            here="simkit refuses to start the plugin.",
            gazebo="Joint ... does not exist! The plugin then crashes Gazebo.",
            remedy=remedy,
        )
