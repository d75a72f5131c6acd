"""The rule about elements and attributes that URDF does not know, and what to write instead of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from simkit.diagnostics import Find, Severity, rule
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
from simkit.urdf.rules.wording import (
    loss,
    numbers_text,
    owner,
    part_of,
    quoted,
    read_numbers,
    shown,
)
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
        remedy = _advice_on(element, context) or f"Take it out. {may}"
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


_GAZEBO_WORDS = {
    **{"gravity": "turnGravityOff", "kinematic": "kinematic", "self_collide": "selfCollide"},
    **{"mu": "mu1", "mu1": "mu1", "mu2": "mu2", "kp": "kp", "kd": "kd"},
    **{"selfCollide": "selfCollide", "turnGravityOff": "turnGravityOff", "maxVel": "maxVel"},
    **{"velocity_decay": "dampingFactor", "laser_retro": "laserRetro", "minDepth": "minDepth"},
}
"Properties of a link that stand in its `<gazebo>`, by what people write."

_in_gazebo = '<gazebo reference="{{link}}">{}</gazebo> into the robot'.format
_COLOUR = 'A colour stands in a <material> of a <visual>: <material name="..."><color rgba="{rgba}"/></material>.'
_GAZEBO_COLOUR = (
    "URDF knows only <color>; Gazebo takes a <material> of its own, e.g. Gazebo/Orange, from the <gazebo> of "
    "the link."
)
_ADVICE: Mapping[str, str] = {
    "link/pose": "<pose> is SDF, and a link of URDF has no pose: its joint says where it is, and <origin> in a "
    "visual, collision or inertial where that is. Where the robot starts, spawn_model says: -z {height}.",
    "/pose": "<pose> is SDF; URDF writes {origin}.",
    "/surface": "<surface> is SDF; friction of a URDF stands in a <gazebo>: write "
    f"{_in_gazebo('{friction}')}; it holds for all collisions of the link.",
    "link/contact": "Only Bullet reads it. For friction in Gazebo write "
    f"{_in_gazebo('<mu1>{lateral}</mu1><mu2>{lateral}</mu2>')}.",
    "link/sensor": "A sensor stands in a <gazebo>: write "
    f"{_in_gazebo('<sensor ...>...</sensor>')}.",
    "joint/joint_properties": "URDF calls it <dynamics {attributes}/>.",
    **{f"joint/{name}": 'Write <dynamics {name}="{value}"/>.' for name in ("damping", "friction")},
    **{
        f"joint/{name}": 'It is an attribute of <limit>: <limit {name}="{value}" .../>.'
        for name in ("lower", "upper", "effort", "velocity")
    },
    "link/origin": "A link has no origin of its own: its joint says where it is. Move it into the <visual>, "
    "<collision> or <inertial>, or into the joint above the link.",
    **{f"{place}/color": _COLOUR for place in ("link", "visual", "robot")},
    "collision/material": "A collision is not seen, and has no colour: take it out, or move it into the <visual>.",
    "link/material": "Move it into the <visual>.",
    "geometry/material": "Move it out of the <geometry>, into the <visual>.",
    "robot/plugin": "A plugin stands in a <gazebo>: <gazebo><plugin ...>...</plugin></gazebo>.",
    "link/plugin": "A plugin stands in a <gazebo> of the robot: <gazebo><plugin ...>...</plugin></gazebo>.",
    "joint/hardwareInterface": "It belongs into a <transmission>.",
    "robot/static": "It belongs to Gazebo: <gazebo><static>true</static></gazebo>.",
    "robot/include": 'URDF has no include; xacro has: <xacro:include filename="..."/>.',
    "robot/model": "<model> is SDF; the robot itself is the model: take it out.",
    **{
        f"material/{name}": _GAZEBO_COLOUR
        for name in ("ambient", "diffuse", "specular", "emissive", "script")
    },
    "collision/verbose": "It has no effect any more: take it out.",
    **{
        f"link/{name}": "Nothing of ROS 1 reads it: take it out."
        for name in ("self_filter", "collision_checking", "self_collision_checking")
    },
}
"""What to write instead of an element, by the word that it stands in (empty: any) and its name.

Most are of SDF, Gazebo's own language, or from another place of URDF.
"""


def _advice_on(element: Element, context: str) -> str:
    """What to write instead of an element that may not stand where it stands; empty if there is no special advice."""
    words = _ADVICE.get(f"{context}/{element.name}") or _ADVICE.get(f"/{element.name}")
    if words is not None:
        return words.format_map(_facts(element))
    if context in ("link", "visual", "collision") and element.name in _GAZEBO_WORDS:
        word, value = _GAZEBO_WORDS[element.name], shown(element.text.strip()) or "..."
        if element.name == "gravity":
            value = "true" if value in ("0", "false") else "false"
        facts = {**_facts(element), "inner": f"<{word}>{value}</{word}>"}
        block = _in_gazebo("{inner}").format_map(facts)
        return f"It belongs to Gazebo: write {block}."
    homes = [word for word, entry in WORDS.items() if element.name in entry.children]
    return f"Move it into <{'> or <'.join(homes)}>." if homes and context not in homes else ""


def _facts(element: Element) -> dict[str, str]:
    """What advice says of an element."""
    text = " ".join(element.text.split())
    pose = read_numbers(text, 6)
    origin = '<origin xyz="..." rpy="..."/>'
    if pose is not None:
        origin = f'<origin xyz="{numbers_text(pose[:3])}" rpy="{numbers_text(pose[3:])}"/>'
    inner = {one.name: shown(one.text.strip()) for one in element.walk()}
    given = {"mu1": inner.get("mu"), "mu2": inner.get("mu2")}
    friction = "".join(f"<{name}>{value}</{name}>" for name, value in given.items() if value)
    lateral = element.child("lateral_friction")
    written = " ".join(f'{one.name}="{shown(one.value)}"' for one in element.attributes)
    return {
        "name": element.name,
        "value": shown(text or element.get("value") or "..."),
        "attributes": written or 'damping="..." friction="..."',
        "link": shown(owner(element).get("name") or "..."),
        "rgba": shown(element.get("rgba") or text or "0.75 0.75 0.75 1"),
        "origin": origin,
        "height": numbers_text(pose[2:3]) if pose and pose[2] else "0.1",
        "friction": friction or "<mu1>...</mu1><mu2>...</mu2>",
        "lateral": "..." if lateral is None else shown(lateral.get("value") or "..."),
    }
