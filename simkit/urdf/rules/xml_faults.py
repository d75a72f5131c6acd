"""The rule about XML that is not well-formed."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.sheet import Sheet
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
        is_other = own is not None and own.name != "robot"  # which another rule tells of
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
