"""The rule about numbers that are none."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from simkit.diagnostics import Find, Severity, rule
from simkit.diagnostics.table import Loss
from simkit.urdf.rules.grammar import in_context
from simkit.urdf.rules.number_repair import mended
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.values import read_number, shown
from simkit.urdf.rules.wording import loss, part_of
from simkit.urdf.urdfdom.numbers import to_double
from simkit.xml import Attribute, Element

_VECTORS = {
    "origin": ("xyz", "rpy"),
    "axis": ("xyz",),
    "box": ("size",),
    "mesh": ("scale",),
}
_NUMBERS = {
    "cylinder": ("radius", "length"),
    "sphere": ("radius",),
    "mass": ("value",),
    "inertia": ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"),
    "limit": ("lower", "upper", "effort", "velocity"),
    "dynamics": ("damping", "friction"),
    "mimic": ("multiplier", "offset"),
    "calibration": ("rising", "falling"),
    "safety_controller": ("soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity"),
}
_COUNTS: Mapping[tuple[str, str], int] = {
    **{(word, name): 3 for word, names in _VECTORS.items() for name in names},
    **{(word, name): 1 for word, names in _NUMBERS.items() for name in names},
}
_EXAMPLES = {"rpy": "0 0 1.5708", "size": "0.1 0.1 0.2", "scale": "1 1 1"}
_WITHOUT_AXIS = ("fixed", "floating")
_MOST_LINES = 10
"A value over more lines is not looked at so closely."


@rule("URDF-E19", "no number, or not as many as needed (commas, units, formulas)", Severity.ERROR)
def bad_number(sheet: Sheet) -> Iterator[Find]:
    """Something that is no number, or not so many numbers as there should be.

    ROS says `Unable to parse component [0,] to a double`, and names no line. Numbers stand with spaces between them, without
    commas, brackets, units or formulas; the point is a point, not a comma. In a joint ROS then refuses the robot; in a link it
    loses the rest of the link and goes on, which is worse, for the robot loads and has holes.

    Wrong:

        <origin xyz="0, 0, 0.05" rpy="0 pi/2 0"/>

    Right:

        <origin xyz="0 0 0.05" rpy="0 1.5708 0"/>
    """
    if sheet.robot is None:
        return
    for element, context in in_context(sheet.robot):
        for attribute in element.attributes:
            count = _COUNTS.get((context, attribute.name))
            if count is not None:
                trouble = _trouble(sheet, attribute, count)
                if trouble:
                    yield _bad(element, attribute, count, trouble)


def _trouble(sheet: Sheet, attribute: Attribute, count: int) -> str:
    """What is wrong with a value, for a sentence; empty if nothing is."""
    value = attribute.value
    if count == 1:
        if to_double(value) is not None:
            return ""
        return "has a space behind it" if read_number(value) is not None else "is no number"
    words = [word for word in value.split(" ") if word]
    if any(read_number(word) is None for word in words):
        return _odd_word(words)
    if len(words) != count:
        have = f"{len(words)} number{'' if len(words) == 1 else 's'}" if words else "nothing"
        return f"holds {have} where {count} are needed"
    if any(to_double(word) is None for word in _as_written(sheet, attribute).split(" ") if word):
        return "has a tab or a new line behind a number, where ROS knows only spaces"
    return ""


def _as_written(sheet: Sheet, attribute: Attribute) -> str:
    """The value with its tabs and newlines, which XML turns into spaces and ROS does not."""
    number, start = attribute.value_span.line, attribute.value_span.column - 1
    line = sheet.document.line(number)
    quote, rest = line[start - 1 : start], line[start:]
    pieces: list[str] = []
    while quote in ("'", '"') and quote not in rest and len(pieces) < _MOST_LINES:
        pieces.append(rest)
        number += 1
        rest = sheet.document.line(number)
    written = "\n".join([*pieces, rest.partition(quote or " ")[0]])
    is_it = " ".join(written.split()) == " ".join(attribute.value.split())
    return written if is_it else attribute.value


def _odd_word(words: list[str]) -> str:
    word = next(word for word in words if read_number(word) is None)
    if word == "," or (word.endswith(",") and read_number(word[:-1]) is not None):
        return "has commas between its numbers"
    return f"holds {shown(word)!r}, which is no number"


def _bad(element: Element, attribute: Attribute, count: int, trouble: str) -> Find:
    right = mended(attribute.value, count)
    many = "one number" if count == 1 else f"{count} numbers with spaces between them"
    example = _EXAMPLES.get(attribute.name, "0 0 0.5") if count > 1 else "0.5"
    if element.name == "axis":
        example = "0 0 1"
    follows = _follows(element)
    return Find(
        attribute,
        element=element,
        what=f"{attribute.name}={shown(attribute.value)!r} of {part_of(element)} {trouble}",
        remedy=f'Write {attribute.name}="{right}".'
        if right is not None
        else f'Write {many}, e.g. {attribute.name}="{example}".',
        loss=follows,
    )


def _follows(element: Element) -> Loss:
    joint = element.parent
    if element.name == "axis" and joint is not None and joint.get("type") in _WITHOUT_AXIS:
        return Loss(
            severity=Severity.NOTE,
            here="It is not looked at: this joint has no axis.",
            gazebo="It is not looked at: this joint has no axis.",
        )
    return loss(element)
