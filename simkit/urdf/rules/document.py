"""Rules about the file as a whole: not XML, not a URDF, of another version, for xacro, with text between its tags."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.rules.parts import missing_attributes
from simkit.urdf.rules.sheet import Sheet, is_for_xacro
from simkit.urdf.rules.vocabulary import in_context
from simkit.urdf.rules.wording import REFUSED, called, part_of, shown
from simkit.urdf.urdfdom.numbers import MalformedError, check_version
from simkit.urdf.urdfdom.xml_verdict import NO_ROBOT, XmlRefusedError, robot_element
from simkit.xml import Fault, FaultKind, Span

_REFUSED = "ROS refuses the file, and names no line or the wrong one."
_ONLY_EXPAT = (
    "check_urdf and robot_state_publisher accept it; joint_state_publisher and spawn_model, which are written in Python, "
    "refuse the file."
)
_URDF = 'a URDF is one <robot name="..."> with links and joints in it.'
_NOT_LOADED = "The rest of the file is checked, too; the robot is not loaded."
_LOADED = "simkit takes it as ROS does."
_OTHER_PLACE = {
    FaultKind.MISMATCHED_TAG: "this element is open",
    FaultKind.UNCLOSED: "this end tag comes too early",
    FaultKind.STRAY_END: "it is closed here already",
    FaultKind.DUPLICATE_ATTRIBUTE: "the first one",
    FaultKind.DECLARATION: "this stands before it",
    FaultKind.DOUBLED_TAG: "the first one",
    FaultKind.SECOND_ROOT: "the first root",
}


@rule("URDF-E01", "not well-formed XML", Severity.ERROR)
def malformed(sheet: Sheet) -> Iterator[Find]:
    """The file is no well-formed XML.

    Nothing loads, and the line that is named is mostly not the one that is wrong: a parser notices a missing `</visual>` only
    where the link ends. Each element that is opened must be closed, the inner one first; each attribute stands once in a tag,
    in quotation marks; `<?xml ...?>`, if it is there, is the very first thing in the file. Editors that know XML show the
    partner of a tag. ROS reads files with one byte for a letter (UTF-8): one that an editor or PowerShell has saved as UTF-16
    is empty to it.

    Wrong:

        <visual>
          <geometry><box size="1 1 1"/></geometry>
        </link>

    Right:

        <visual>
          <geometry><box size="1 1 1"/></geometry>
        </visual>
    """
    faults = sheet.document.faults
    root = sheet.document.root
    if sheet.document.has_wide_letters:
        yield _wide_letters()
    if root is not None and root.name.lower() == "html":
        return  # its faults are nobody's here
    is_loaded = bool(faults) and _is_accepted(sheet)
    for fault in faults:
        yield _told(sheet, fault, is_loaded=is_loaded)


def _is_accepted(sheet: Sheet) -> bool:
    """Whether ROS reads the file in spite of its faults, and finds the robot."""
    try:
        robot_element(sheet.document)
    except XmlRefusedError as refusal:
        own = sheet.document.root
        is_other = own is not None and own.name != "robot"  # which another rule reports
        return is_other and str(refusal) == NO_ROBOT
    return True


def _wide_letters() -> Find:
    return Find(
        Span(1, 1),
        what="the file is saved as UTF-16, with two bytes for each letter",
        remedy="Save it as UTF-8: most editors ask for the encoding; in PowerShell, ... | Out-File -Encoding utf8 robot.urdf.",
        here="The file is checked; the robot is not loaded, as in ROS.",
        gazebo="ROS finds nothing that it can read, and says that the document is empty.",
    )


def _told(sheet: Sheet, fault: Fault, *, is_loaded: bool) -> Find:
    related = []
    if fault.other is not None and fault.other != fault.span:
        text = _OTHER_PLACE.get(fault.kind, "this belongs to it")
        related.append((fault.other, text))
    if fault.kind is FaultKind.EMPTY:
        return _empty(fault)
    return Find(
        fault.span,
        severity=Severity.NOTE if _is_blank_line(sheet, fault) else Severity.ERROR,
        what=fault.what,
        remedy=_sentence(fault.remedy),
        here=_LOADED if is_loaded else _NOT_LOADED,
        gazebo=_ONLY_EXPAT if is_loaded else _REFUSED,
        related=related,
    )


def _empty(fault: Fault) -> Find:
    return Find(
        fault.span,
        what=fault.what,
        remedy=f"{_sentence(fault.remedy)[:-1]}: {_URDF}",
        here="There is no robot in it to load.",
        gazebo="ROS refuses the file: it says that the document is empty.",
    )


def _is_blank_line(sheet: Sheet, fault: Fault) -> bool:
    """Whether nothing but white space stands before `<?xml`."""
    before, mark, _ = sheet.document.text.partition("<?xml")
    return fault.kind is FaultKind.DECLARATION and bool(mark) and not before.strip("\ufeff \n\t\r")


def _sentence(text: str) -> str:
    text = text[:1].upper() + text[1:]
    return text if text.endswith((".", "?", "!")) else f"{text}."


_SDF = "This is SDF, Gazebo's other language. Spawn it with spawn_model -sdf, or write it anew as URDF."
_OTHER_FILES = {
    **dict.fromkeys(("sdf", "gazebo", "world", "model"), _SDF),
    "launch": "This is a launch file: start it with roslaunch, and check the URDF that it loads.",
    "package": "This is the package.xml of a package; its URDF files mostly lie in a folder urdf/.",
    "mujoco": "This is a model for MuJoCo, another simulator.",
    "html": "This is a web page: download the file itself (on GitHub: Raw).",
    "COLLADA": 'This is a mesh; a URDF names it in <mesh filename="..."/>.',
}


@rule("URDF-E27", "the outermost element is not <robot>", Severity.ERROR)
def no_robot(sheet: Sheet) -> Iterator[Find]:
    """The outermost element is not `<robot>`.

    ROS says `Could not find the 'robot' element in the xml file`. Either the file is something else (a world, a launch file),
    or the word is written in another way; it stands in small letters.

    Wrong:

        <Robot name="my_robot">

    Right:

        <robot name="my_robot">
    """
    root = sheet.document.root
    if root is None or root.name == "robot" or sheet.is_closed_otherwise(root):
        return
    inner = root.child("robot")
    remedy = _OTHER_FILES.get(
        root.name, 'A URDF is one <robot name="..."> with links and joints in it.'
    )
    if sheet.robot is not None:
        remedy = "Write <robot>" + (", in small letters." if root.name.lower() == "robot" else ".")
    elif inner is not None:
        remedy = f"Take <{shown(root.name)}> out: the <robot> in line {inner.span.line} must be outermost."
    yield Find(
        root,
        what=f"the outermost element is <{shown(root.name)}>, not <robot>",
        remedy=remedy,
        loss=REFUSED,
    )


@rule(
    "URDF-E28",
    "a version of URDF that does not exist",
    Severity.ERROR,
    remedy='Take the attribute out, or write version="1.0": it is the version of the language, not of your robot.',
)
def bad_version(sheet: Sheet) -> Iterator[Find]:
    """A version other than 1.0.

    ROS says `Invalid 'version' specified; only version 1.0 is currently supported`. The attribute is not the version of your
    robot but that of the language URDF, and there is only one. Leave it out.

    Wrong:

        <robot name="my_robot" version="2.1">

    Right:

        <robot name="my_robot">
    """
    version = None if sheet.robot is None else sheet.robot.get("version")
    if sheet.robot is None or version is None or _is_known(version):
        return
    yield Find(
        Part(sheet.robot, "version"),
        what=f"version {shown(version)!r} of URDF does not exist",
        loss=REFUSED,
    )


def _is_known(version: str) -> bool:
    try:
        check_version(version)
    except MalformedError:
        return False
    return True


@rule(
    "URDF-E29",
    "a file for xacro, which has not been run on it",
    Severity.ERROR,
    here="No other rule looks at this file.",
    gazebo="ROS ignores xacro's elements, and takes ${...} and $(...) as they are, as names and as numbers that it cannot read.",
)
def unexpanded_xacro(sheet: Sheet) -> Iterator[Find]:
    """A file for xacro, given where a URDF is needed.

    Parts are missing, or numbers are said to be none. xacro is a language of macros: `xacro:macro`, `${width / 2}`. The program
    xacro makes a URDF of such a file; ROS itself reads only the result. No other rule looks at such a file.

    Wrong, in a launch file:

        <param name="robot_description" textfile="$(find my_robot)/urdf/my_robot.urdf.xacro"/>

    Right:

        <param name="robot_description" command="xacro $(find my_robot)/urdf/my_robot.urdf.xacro"/>
    """
    found = sheet.xacro
    if not found:
        return
    element = found[0]
    attribute = next((one for one in element.attributes if is_for_xacro(one.value)), None)
    what = (
        f"<{shown(element.name)}>"
        if attribute is None
        else f'{attribute.name}="{shown(attribute.value)}"'
    )
    more = f", and {len(found) - 1} more such places" if len(found) > 1 else ""
    name = sheet.document.file.rpartition("/")[2]
    stem = name.removesuffix(".xacro").removesuffix(".urdf")
    urdf = f"{stem}.urdf" if name != f"{stem}.urdf" else f"{stem}_made.urdf"
    yield Find(
        attribute or element,
        element=element,
        what=f"{what} is for xacro, which has not been run on this file{more}",
        remedy=f'Make a URDF of it: simkit xacro {shown(name)} > {shown(urdf)}; in a launch file command="xacro ...".',
    )


@rule(
    "URDF-I36",
    "text where URDF has none",
    Severity.NOTE,
    both="It is not read.",
)
def stray_text(sheet: Sheet) -> Iterator[Find]:
    """Text between the tags, where URDF has none.

    Nobody reads it. Mostly a `>` was typed twice, or a comment was written without `<!--` and `-->`. In `<gazebo>` and
    `<transmission>` text does count.

    Wrong:

        <geometry>
          <box size="1 1 1"/>
        </geometry>>

    Right:

        <geometry>
          <box size="1 1 1"/>
        </geometry>
    """
    for element, word in in_context(sheet.robot):
        text = element.text.strip()
        if not text or element.text_span is None or missing_attributes(element, word):
            continue
        is_tag = text == ">"
        where = called(element) if element.parent is None else part_of(element)
        yield Find(
            Part(element),
            what=f"the text {shown(text)!r} in {where} says nothing to URDF",
            remedy="Take the second > out."
            if is_tag
            else "Take it out, or make it a comment: <!-- ... -->.",
        )
