"""The rule about elements and attributes that URDF does not know."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.misplaced import advice
from simkit.urdf.rules.parts import missing_attributes
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import (
    SHAPES,
    WORDS,
    in_context,
    meant_word,
    misspelt_attributes,
    nearest,
)
from simkit.urdf.rules.wording import loss, part_of, quoted, shown
from simkit.xml import Attribute, Element

_SILENT = "ROS and Gazebo ignore it without a word."
_NEEDED = ("parent", "child", "geometry", "mass", "inertia", "link", "joint", *SHAPES)
"Without these ROS refuses the file, or loses a part of it."
_SEVERITIES = {"link": Severity.ERROR, "joint": Severity.ERROR, "contact": Severity.NOTE}
"What is lost with a link or joint in the wrong place is much; `<contact>` is Bullet's, and meant so."


@rule("URDF-W17", "an element or attribute that URDF does not know there", Severity.ERROR)
def unknown_word(sheet: Sheet) -> Iterator[Find]:
    """An element or attribute that URDF does not know.

    The setting has no effect, and nobody says so: ROS ignores what it does not know. Some are slips of the pen (`<inertail>`).
    Some are words of SDF, the other language of Gazebo (`<pose>`, `<surface>`): in a URDF such settings stand in a `<gazebo>`
    or have other names. Some stand in the wrong place: a colour in a collision, `<mass>` outside of `<inertial>`.

    Wrong:

        <joint name="wheel_joint" type="continuous">
          <joint_properties damping="0.1" friction="0.1"/>

    Right:

        <joint name="wheel_joint" type="continuous">
          <dynamics damping="0.1" friction="0.1"/>
    """
    for element, word in in_context(sheet.robot):
        for child in element.children:
            yield from _unknown_element(sheet, child, word)
        yield from _unknown_attributes(element, word)


def _unknown_element(sheet: Sheet, element: Element, context: str) -> Iterator[Find]:
    words = WORDS[context].children
    if element.name in words or ":" in element.name or _is_told_elsewhere(element, context):
        return
    if sheet.is_closed_otherwise(element):
        return
    near = meant_word(element, words)
    name = shown(element.name)
    if near is not None:
        severity = Severity.ERROR
        what = f"<{name}> in {_where(element)} is no word of URDF"
        remedy = f"Did you mean <{near}>?"
    else:
        severity = _SEVERITIES.get(element.name, Severity.WARNING)
        may = (
            f"In <{context}> may stand: {', '.join(words)}."
            if words
            else f"<{context}> holds no elements."
        )
        known = element.name in WORDS
        what = (
            f"<{name}> may not stand in {_where(element)}"
            if known
            else f"<{name}> in {_where(element)} is no word of URDF"
        )
        remedy = advice(element, context) or f"Take it out. {may}"
    lost = near in _NEEDED and context != "robot"
    follows = loss(element.parent or element) if lost else None
    yield Find(
        element,
        severity=severity,
        what=what,
        remedy=remedy,
        here=follows.here if follows else "simkit does the same.",
        gazebo=follows.gazebo if follows else _silence(sheet, element, near),
    )


def _silence(sheet: Sheet, element: Element, near: str | None) -> str:
    word = near or (element.name if element.name in ("link", "joint") else "")
    reason = _refused_without(sheet, element, word)
    if reason:
        return f"ROS ignores it as if there were no <{word}>, and then refuses the whole file: {reason}."
    return f"{_SILENT[:-1]}, as if there were no <{near}>." if near else _SILENT


def _refused_without(sheet: Sheet, element: Element, word: str) -> str:
    """Why ROS refuses a robot without a link, joint or limit; empty if it does not."""
    name = element.get("name")
    if word == "link" and len(sheet.links) == 1:
        return "there is no link"
    if word == "link" and (name in sheet.joints_above or name in sheet.joints_below):
        return "a joint names that link"
    if word == "joint":
        child = next((one.child for one in sheet.joints if one.element is element), None)
        is_only = child in sheet.link_by_name and len(sheet.joints_above.get(child or "", ())) == 1
        return f"then link {quoted(child)} hangs on nothing" if is_only else ""
    joint = element.parent
    if word == "limit" and joint is not None and joint.get("type") in ("revolute", "prismatic"):
        return f"a {joint.get('type')} joint needs it"
    return ""


def _where(element: Element) -> str:
    parent = element.parent
    if parent is None or parent.parent is None:
        return "the robot"
    word = nearest(parent.name, ("link", "joint", "inertial", "visual", "collision"))
    return part_of(parent) if word else f"<{shown(parent.name)}> of {part_of(parent)}"


def _is_told_elsewhere(element: Element, context: str) -> bool:
    """Whether the rule of missing parts, or that of missing attributes, has more to say of it."""
    parent = element.parent
    if context == "geometry":
        return meant_word(element, SHAPES) is None
    return parent is not None and element.name in missing_attributes(parent, context)


def _unknown_attributes(element: Element, context: str) -> Iterator[Find]:
    known = WORDS[context].attributes
    unknown = [one for one in element.attributes if one.name not in known]
    meanings = (
        {one.name: word for one, word in misspelt_attributes(element, context)} if unknown else {}
    )
    for attribute in unknown:
        name = attribute.name
        is_other = ":" in name or name == "xmlns"
        is_told = name == "diameter" and "radius" in missing_attributes(element, context)
        if not is_other and not is_told:
            yield _unknown_attribute(element, attribute, context, meanings.get(name))


def _unknown_attribute(
    element: Element, attribute: Attribute, context: str, meant: str | None
) -> Find:
    name = attribute.name
    severity = Severity.ERROR if _is_needed(element, context, meant) else Severity.WARNING
    follows = loss(element) if severity is Severity.ERROR else None
    return Find(
        attribute.name_span,
        severity=severity,
        element=element,
        what=f"<{shown(element.name)}> of {part_of(element)} has no attribute {shown(name)!r}",
        remedy=f'Did you mean {meant}="{shown(attribute.value)}"?'
        if meant
        else _advice(name, context),
        here=follows.here if follows else "simkit ignores it, too.",
        gazebo=follows.gazebo if follows else _SILENT,
    )


def _is_needed(element: Element, context: str, meant: str | None) -> bool:
    """Whether ROS loses the element if the attribute that is meant is not there."""
    if context == "dynamics":  # which needs one of its two
        return bool(meant) and not any(element.attribute(one) for one in WORDS[context].attributes)
    return meant in WORDS[context].required


def _advice(name: str, context: str) -> str:
    if (context, name) == ("axis", "rpy"):
        return 'An axis has only xyz; to turn it, turn the joint: <origin rpy="..."/>. Take it out.'
    if context == "inertia" and name in ("iyx", "izx", "izy"):
        return f"The tensor is symmetric: {name} is {name[0]}{name[2]}{name[1]}. Take it out."
    known = WORDS[context].attributes
    return (
        f"Take it out. <{context}> may have: {', '.join(known)}."
        if known
        else f"Take it out: <{context}> has no attributes."
    )
