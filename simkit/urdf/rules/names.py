"""Rules about names: given twice, missing, such that they make trouble; and namespaces of XML."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.rules.entries import JointEntry, LinkEntry, MaterialEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.tree_facts import names_for_spare_links
from simkit.urdf.rules.vocabulary import meant_attribute
from simkit.urdf.rules.wording import REFUSED, called, loss, part_of, quoted, shown
from simkit.xml import Element


@rule("URDF-E21", "two links, joints or materials of one name", Severity.ERROR)
def name_twice(sheet: Sheet) -> Iterator[Find]:
    """Two links, joints or materials of one name.

    ROS says `link 'wheel' is not unique` and refuses the robot. Mostly a link or joint was copied, and its name not changed.

    Wrong:

        <link name="wheel"/>
        <link name="wheel"/>

    Right:

        <link name="left_wheel"/>
        <link name="right_wheel"/>
    """
    asked = {id(link): name for name, link in names_for_spare_links(sheet).items()}
    used = {*sheet.link_by_name, *sheet.joint_by_name}
    counts: dict[str, int] = {}
    for entry, before in _repeated(sheet):
        other = asked.get(id(entry)) or _free_name(str(entry.name), used, counts)
        wish = " (a joint asks for that link)" if id(entry) in asked else ""
        word = called(entry.element).partition(" ")[0]
        yield Find(
            Part(entry.element, "name"),
            what=f"there is a {word} {quoted(entry.name)} already, in line {before.element.span.line}",
            remedy=f'Give this one another name, e.g. name="{shown(other)}"{wish}.',
            loss=REFUSED,
            related=[(Part(before.element, "name"), f"the first {word} of that name")],
        )


def _repeated(
    sheet: Sheet,
) -> Iterator[
    tuple[LinkEntry | JointEntry | MaterialEntry, LinkEntry | JointEntry | MaterialEntry]
]:
    materials = [one for one in sheet.materials if one.is_global]
    kinds: tuple[Iterable[LinkEntry | JointEntry | MaterialEntry], ...]
    kinds = (sheet.links, sheet.joints, materials)
    for entries in kinds:
        first: dict[str, LinkEntry | JointEntry | MaterialEntry] = {}
        for entry in entries:
            if entry.name and first.setdefault(entry.name, entry) is not entry:
                yield entry, first[entry.name]


def _free_name(name: str, used: set[str], counts: dict[str, int]) -> str:
    """The name with the next number that is not taken; `counts` holds the last number of each name."""
    number = counts.get(name, 1) + 1
    while f"{name}_{number}" in used:
        number += 1
    counts[name] = number
    return f"{name}_{number}"


@rule("URDF-E24", "a name is missing", Severity.ERROR)
def name_missing(sheet: Sheet) -> Iterator[Find]:
    """A robot, link, joint or material without a name.

    A link without a name cannot be the parent or child of a joint; a joint without one cannot be moved; ROS refuses a robot
    without one. A visual that gives a colour without a name for it loses its shape.

    Wrong:

        <link>

    Right:

        <link name="torso">
    """
    if sheet.robot is None:
        return
    name = meant_attribute(sheet.robot, "name", "robot")
    if name is None or not name.value:
        yield _nameless(sheet.robot, 'name="my_robot"', refuses=name is None)
    asked = {id(link): name for name, link in names_for_spare_links(sheet).items()}
    refuses = len(sheet.links) > 1  # no joint can name such a link, so it is a second root
    for link in sheet.links:
        if link.name is None:
            wish = f'name="{asked[id(link)]}", which a joint asks for' if id(link) in asked else ""
            yield _nameless(link.element, wish or 'name="my_link"', refuses=refuses)
    for joint in sheet.joints:
        if joint.name is None:
            wish = f'name="{joint.child or "my"}_joint"'
            yield _nameless(joint.element, wish, refuses=joint.element.get("name") is None)
    for material in sheet.materials:
        if material.name is None:
            yield _nameless(material.element, 'name="my_colour"', refuses=False)


def _nameless(element: Element, wish: str, *, refuses: bool) -> Find:
    empty = element.attribute("name")
    follows = REFUSED if refuses else loss(element)
    here, gazebo = follows.here, follows.gazebo
    severity = follows.severity
    if called(element).startswith("a link "):
        if not refuses:
            here = gazebo = "The file is accepted, with a link whose name is empty."
    elif empty is not None:
        severity = Severity.WARNING
        here = gazebo = "The file is accepted, with an empty name."
    whole = "the robot" if element.parent is None else f"a <{shown(element.name)}>"
    where = f" in {part_of(element)}" if element.name == "material" else ""
    return Find(
        Part(element, "name"),
        severity=severity,
        what=f"{whole}{where} has {'an empty name' if empty is not None else 'no name'}",
        remedy=f"Give it one: {wish}.",
        here=here,
        gazebo=gazebo,
    )


@rule(
    "URDF-W32",
    "a name with white space or a slash, or that of a link and a joint",
    Severity.WARNING,
    here="It is taken as it is.",
)
def odd_name(sheet: Sheet) -> Iterator[Find]:
    """A name with white space, or with a slash at its begin; a joint that is called like a link.

    Names of links are names of TF frames. tf2 refuses frames that begin with a slash. A space, most of all one at the end that
    nobody sees, makes a name different from the one that everybody else writes. Gazebo tells joints and links apart by their
    names only in part: newer ones complain if a joint is called like a link.

    Wrong:

        <link name="left wheel "/>

    Right:

        <link name="left_wheel"/>
    """
    entries: list[LinkEntry | JointEntry] = [*sheet.links, *sheet.joints]
    for entry in entries:
        name = entry.name
        if name is None:
            continue
        better = "_".join(name.split()).lstrip("/") or "my_name"
        if name != "_".join(name.split()):
            yield _odd(entry, Severity.WARNING, "has white space in its name", better)
        elif name.startswith("/"):
            yield _odd(entry, Severity.WARNING, "begins with a slash", better)
    for joint in sheet.joints:
        if joint.name is not None and joint.name in sheet.link_by_name:
            what = "has the name of a link"
            yield _odd(joint, Severity.NOTE, what, f"{joint.name}_joint")


def _odd(entry: LinkEntry | JointEntry, severity: Severity, what: str, better: str) -> Find:
    gazebo = "ROS takes the name as it is; each space must be written everywhere else, too."
    if str(entry.name).startswith("/"):
        gazebo = "tf2 refuses frames that begin with a slash."
    elif severity is Severity.NOTE:
        gazebo = "ROS accepts it; newer Gazebos complain that the name is not unique."
    return Find(
        Part(entry.element, "name"),
        severity=severity,
        what=f"{called(entry.element)} {what}",
        remedy=f'Write name="{shown(better)}", and the same wherever it is named.',
        gazebo=gazebo,
    )


_DECLARES = "xmlns:"


@rule(
    "URDF-I48",
    "a namespace that nothing in the file uses",
    Severity.NOTE,
    both="It has no effect.",
)
def unused_namespace(sheet: Sheet) -> Iterator[Find]:
    """A namespace that nothing in the file uses.

    Symptom: None. It only makes the file look as if it were more than a URDF.

    Cause: A template, or the output of xacro, which leaves its declaration behind. In a file with macros it is needed; such a
    file goes through xacro before it is a URDF.

    Remedy: Leave it out.

    Wrong, without a macro in the file:

        <robot name="m2wr" xmlns:xacro="http://www.ros.org/wiki/xacro">

    Right:

        <robot name="m2wr">
    """
    declared = [] if sheet.robot is None else sheet.robot.attributes
    names = {
        one.name.removeprefix(_DECLARES): one for one in declared if one.name.startswith(_DECLARES)
    }
    if sheet.robot is None or not names:
        return
    for element in sheet.robot.walk():
        written = (element.name, *(one.name for one in element.attributes))
        for prefix in {name.partition(":")[0] for name in written if ":" in name}:
            names.pop(prefix, None)
    for prefix, attribute in names.items():
        yield Find(
            attribute.name_span,
            element=sheet.robot,
            what=f"the namespace {quoted(prefix)} is declared, and nothing in the file uses it",
            remedy=f"Leave out {shown(attribute.name)}.",
        )
