"""Rules on `<gazebo>` blocks: what they belong to, and the tags in them."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.rules.bodies import mass_of, parents_by_fixed_joint
from simkit.urdf.rules.entries import GazeboEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.tree_facts import is_whole
from simkit.urdf.rules.vocabulary import (
    JOINT_TAGS,
    LINK_TAGS,
    MISNAMED,
    NUMBERS,
    ROBOT_TAGS,
    SWITCHES,
    is_switch,
    nearest,
    tag_value,
)
from simkit.urdf.rules.wording import listed, quoted, read_number, shown
from simkit.xml import Element

_SILENT = "Gazebo drops the whole block, without a word."


@rule(
    "GZ-E01",
    "a <gazebo> for a link or joint that is not there",
    Severity.ERROR,
    here="simkit leaves out the block.",
)
def dangling_reference(sheet: Sheet) -> Iterator[Find]:
    """A `<gazebo reference="...">` names a link or joint that is not there.

    Symptom: The sensor never publishes, the colour stays grey, the friction is the default one, and nobody complains.

    Cause: A misspelt name, or a link that was never added: the sensor has no link to sit on.

    Remedy: The name of a link (for materials, friction, sensors) or of a joint (for its stops and springs). A sensor gets a
    link of its own, on a fixed joint.

    Right:

        <link name="sensor_laser"/>
        <joint name="joint_laser" type="fixed">
          <parent link="link_chassis"/>
          <child link="sensor_laser"/>
          <origin xyz="0.15 0 0.08"/>
        </joint>
        <gazebo reference="sensor_laser"> <sensor type="ray" name="laser"> ... </sensor> </gazebo>
    """
    known = {**sheet.link_by_name, **sheet.joint_by_name}
    for block in sheet.gazebo:
        name = block.reference
        if not name or name in known:
            continue
        lost = [one for one in block.element.walk() if one.name in ("sensor", "plugin")]
        parts = " and ".join(f"the {one.name} {quoted(one.get('name'))}" for one in lost[:3])
        yield Find(
            Part(block.element, "reference"), severity=Severity.ERROR if lost else Severity.WARNING,
            what=f"there is no link or joint {quoted(name)}" + (f"; lost with it: {parts}" if lost else ""),

            gazebo=_SILENT,
            remedy=_reference_remedy(sheet, block, name, [*known]),
        )  # fmt: skip


@rule(
    "GZ-W12",
    "a tag that Gazebo does not read there",
    Severity.WARNING,
    here="simkit does not read it.",
    gazebo="Gazebo does not read it.",
)
def gazebo_tag(sheet: Sheet) -> Iterator[Find]:
    """A tag in a `<gazebo>` that Gazebo does not read there, or not with that value.

    Symptom: The setting has no effect.

    Cause: A misspelt tag, a tag of SDF where URDF has its own (`<mu>` is `<mu1>`), a tag for links in the block of a joint,
    or a value that is not a number, or neither true nor false.

    Remedy: The tag that is meant. For links there are `material`, `mu1`, `mu2`, `kp`, `kd`, `selfCollide`, `turnGravityOff`
    and others; for joints `provideFeedback`, `springStiffness`, `preserveFixedJoint` and others.

    Right:

        <gazebo reference="caster">
          <mu1>0.0</mu1>
          <mu2>0.0</mu2>
        </gazebo>
    """
    for block in sheet.gazebo:
        for element in block.element.children:
            found = _tag_fault(sheet, block, element)
            if found is not None:
                severity, what, remedy = found
                yield Find(
                    element,
                    severity=severity,
                    what=what,
                    remedy=remedy,
                )


@rule(
    "GZ-W07",
    "links that Gazebo makes one body of",
    Severity.NOTE,
    here="simkit keeps every link: it has a frame in TF and a pose.",
    gazebo="Gazebo makes one body of them; shapes, mass and sensors move to the parent.",
)
def lumped_links(sheet: Sheet) -> Iterator[Find]:
    """Gazebo makes one body of links that a fixed joint connects.

    Symptom: A link is missing in Gazebo's tree, on `/gazebo/link_states`, or as `bodyName` of a plugin.

    Cause: Gazebo moves the mass, the shapes and the sensors of the child into the parent, since two bodies that cannot move
    against each other are one. TF and RViz still have the link, since robot_state_publisher reads the URDF.

    Remedy: None is needed. To keep a link, say so in the block of the joint.

    Right:

        <gazebo reference="base_joint">
          <preserveFixedJoint>true</preserveFixedJoint>
        </gazebo>
    """
    above = parents_by_fixed_joint(sheet)
    merged = [link.name for link in sheet.links if link.name in above]
    if not is_whole(sheet) or not merged or not any(mass_of(link) for link in sheet.links):
        return
    names = [name for name in merged if name is not None]
    joint = sheet.joints_above[names[0]][0]
    yield Find(
        joint.element,
        what=f"Gazebo merges links on fixed joints into their parent: {listed(names)}",
        remedy=f"Right as it is. To keep a link: <gazebo reference={_attribute(joint.name)}>"
        "<preserveFixedJoint>true</preserveFixedJoint></gazebo>.",
    )


def _reference_remedy(sheet: Sheet, block: GazeboEntry, name: str, known: list[str]) -> str:
    near = sheet.near(name, known)
    if near:
        return f"Did you mean {' or '.join(map(quoted, near))}?"
    if block.element.child("sensor") is None:
        return f"Name one of the links: {listed([*sheet.link_by_name][::-1])}."
    base = next((link.name for link in sheet.links if mass_of(link)), None)
    return (
        f'Add <link name={_attribute(name)}/> and <joint name={_attribute("joint_" + name)} type="fixed">'
        f'<parent link={_attribute(base or "base_link")}/><child link={_attribute(name)}/><origin xyz="0 0 0.1"/></joint>, '
        "with the place where the sensor is."
    )


def _tag_fault(
    sheet: Sheet, block: GazeboEntry, element: Element
) -> tuple[Severity, str, str] | None:
    """How bad it is what is wrong with one tag, what it is, and what would be right; None if it may stand there."""
    tag, text = element.name, tag_value(element)
    allowed = _tags_for(sheet, block)
    if tag in SWITCHES and tag in allowed and not is_switch(text):
        what = f"<{tag}> is neither true nor false: {quoted(text)}"
        return Severity.WARNING, what, f"Write <{tag}>true</{tag}>."
    if tag in NUMBERS and tag in allowed and read_number(text) is None:
        what = f"<{tag}> holds no number: {quoted(text)}"
        return Severity.WARNING, what, f"Write a number, as in <{tag}>1.0</{tag}>."
    if tag in allowed or ":" in tag:
        return None
    every = {*LINK_TAGS, *JOINT_TAGS, *ROBOT_TAGS}
    meant = MISNAMED.get(tag) or (None if tag in every else nearest(tag, allowed))
    if meant is not None and meant in allowed:
        what = f"<{shown(tag)}> is no tag of a <gazebo> block"
        return Severity.WARNING, what, f"Write <{meant}> if that is meant."
    if tag in LINK_TAGS and block.reference in sheet.joint_by_name:
        what = f"<{tag}> is for links, and {quoted(block.reference)} is a joint"
        return Severity.NOTE, what, _move_to("link")
    if tag in JOINT_TAGS and block.reference in sheet.link_by_name:
        what = f"<{tag}> is for joints, and {quoted(block.reference)} is a link"
        return Severity.NOTE, what, _move_to("joint")
    if tag in every and not block.reference:
        kind = "link" if tag in LINK_TAGS else "joint"
        return Severity.WARNING, f"<{tag}> needs a {kind} that it belongs to", _move_to(kind)
    return None


def _move_to(kind: str) -> str:
    return f'Put it into a <gazebo reference="..."> that names a {kind}.'


def _tags_for(sheet: Sheet, block: GazeboEntry) -> tuple[str, ...]:
    is_link, is_joint = (
        block.reference in sheet.link_by_name,
        block.reference in sheet.joint_by_name,
    )
    if not block.reference:
        return tuple(ROBOT_TAGS)
    return (*(LINK_TAGS if is_link or not is_joint else ()), *(JOINT_TAGS if is_joint or not is_link else ()))  # fmt: skip


def _attribute(name: str | None) -> str:
    return f'"{shown(name or "")}"'
