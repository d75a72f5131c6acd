"""A rule on plugins that name joints and links which are not there."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.entries import PluginEntry
from simkit.urdf.rules.joint_names import known_names
from simkit.urdf.rules.lumps import parents_by_fixed_joint
from simkit.urdf.rules.plugin_words import PLUGINS, Kind
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import meant, quoted
from simkit.xml import Element


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
        word = PLUGINS.get(plugin.filename or "")
        for name, kind in () if word is None else word.parameters.items():
            element = plugin.parameter(name)
            default = None if word is None else word.defaults.get(name)
            value = default if element is None else element.text.strip()
            if value is None or (element is not None and not value and kind is not Kind.JOINT):
                continue
            if kind is Kind.JOINT and value not in moving:
                yield _no_joint(sheet, plugin, name, value, [*moving])
            elif kind is Kind.LINK and value not in sheet.link_by_name:
                yield _no_link(sheet, plugin, name, value)
            elif kind is Kind.LINK and value in lumped and element is not None:
                yield _lumped_link(element, value, lumped)
            elif kind is Kind.FRAME and value.lstrip("/") not in sheet.link_by_name:
                yield _no_frame(sheet, plugin, name, value)


def _no_joint(sheet: Sheet, plugin: PluginEntry, name: str, value: str, moving: list[str]) -> Find:
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
        plugin.element if element is None else element.text_span or element,
        element=element or plugin.element,
        what=what,
        here="simkit refuses to start the plugin.",
        gazebo="The plugin does not load: couldn't get wheel hinge joint.",
        remedy=remedy,
        related=() if joint is None else [(joint.element, "a fixed joint is gone in Gazebo")],
    )


def _no_link(sheet: Sheet, plugin: PluginEntry, name: str, value: str) -> Find:
    element = plugin.parameter(name)
    return Find(
        plugin.element if element is None else element.text_span or element,
        element=element or plugin.element,
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
        element.text_span or element,
        severity=Severity.NOTE,
        element=element,
        what=f"<{element.name}> names {quoted(value)}, a link on a fixed joint",
        here="simkit keeps the link.",
        gazebo=f"Gazebo makes it one body with {quoted(leader)}, and the plugin does not find it.",
        remedy=f"Name {quoted(leader)}, or keep the link with <preserveFixedJoint> in the <gazebo> of its joint.",
    )


def _no_frame(sheet: Sheet, plugin: PluginEntry, name: str, value: str) -> Find:
    element = plugin.parameter(name)
    what = f"<{name}> names {quoted(value)}, and no link has that name"
    if element is None:
        what = (
            f"<{name}> is missing, so the plugin takes {quoted(value)}, and no link has that name"
        )
    return Find(
        plugin.element if element is None else element.text_span or element,
        severity=Severity.WARNING,
        element=element or plugin.element,
        what=what,
        here="Its messages are in a frame that TF does not know, so the view cannot place them.",
        gazebo="Its messages are in a frame that TF does not know, so RViz cannot show them.",
        remedy=_name_remedy(
            sheet, "links", value, [link.name for link in sheet.links if link.name]
        ),
    )


def _name_remedy(sheet: Sheet, kind: str, name: str, known: list[str]) -> str:
    return meant(sheet.near(name, known)).strip() or known_names(kind, known)
