"""Numbers, vectors, colours and versions as urdfdom reads them, and the log of what it says of them.

A number is what a C++ stream reads in the C locale, and nothing may follow it, not even a space.
"""

from __future__ import annotations

import math
import re

from simkit.geometry import Vector
from simkit.urdf.model import Pose, Rgba
from simkit.xml import Element

_NUMBER = re.compile(r"[\t-\r ]*[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_INTEGER = r"(?s)[\t-\r ]*([+-]?[0-9]+)(.*)"
_LONGEST = 20
"So many letters of an integer are enough to tell it from 1 and 0."


class Log:
    """Collects lines. Where in its own source urdfdom was ("at line N in ...") is left out."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        """The lines, with the level in front."""

    def error(self, text: str) -> None:
        """Something that urdfdom calls an error; without words it says nothing."""
        if text:
            self.lines.append(f"Error:   {text}")

    def warning(self, text: str) -> None:
        """Something that urdfdom warns of."""
        self.lines.append(f"Warning: {text}")


class MalformedError(Exception):
    """Something that urdfdom cannot read; holds its words, or none if it says nothing."""


def to_double(text: str) -> float | None:
    """A number; None if it is not one."""
    if _NUMBER.fullmatch(text) is None:
        return None
    value = float(text)
    return None if math.isinf(value) else value


def number_of(element: Element, name: str, complaint: str) -> float:
    """The number in an attribute that is there.

    Raises:
        MalformedError: It is no number; with `complaint`, where `{}` stands for the text.
    """
    text = element.written(name) or ""
    value = to_double(text)
    if value is None:
        raise MalformedError(complaint.replace("{}", text))
    return value


def to_vector(text: str) -> Vector:
    """Three numbers with spaces between them.

    Raises:
        MalformedError: They are not three, or not numbers.
    """
    values = []
    for piece in filter(None, text.split(" ")):
        value = to_double(piece)
        if value is None:
            raise MalformedError(
                f"Unable to parse component [{piece}] to a double (while parsing a vector value)"
            )
        values.append(value)
    if len(values) != 3:
        raise MalformedError(
            f"Parser found {len(values)} elements but 3 expected while parsing vector [{text}]"
        )
    return (values[0], values[1], values[2])


def to_colour(text: str) -> Rgba:
    """Red, green, blue, opacity; opaque black if they are not four.

    Raises:
        MalformedError: One of them is no number from 0 to 1.
    """
    values = []
    for piece in filter(None, text.split(" ")):
        value = to_double(piece)
        if value is None or not 0.0 <= value <= 1.0:
            raise MalformedError(
                f"Unable to parse component [{piece}] to a double (while parsing a color value)"
            )
        values.append(value)
    if len(values) != 4:
        return (0.0, 0.0, 0.0, 1.0)
    return (values[0], values[1], values[2], values[3])


def origin_of(element: Element) -> Pose:
    """The pose in the first `<origin>`; identity without one.

    Raises:
        MalformedError: Its xyz or rpy are not three numbers.
    """
    origin = element.child("origin")
    if origin is None:
        return Pose()
    xyz, rpy = origin.written("xyz"), origin.written("rpy")
    here = Pose().xyz
    return Pose(here if xyz is None else to_vector(xyz), here if rpy is None else to_vector(rpy))


def check_version(text: str | None) -> None:
    """Refuse a version other than 1.0.

    Raises:
        MalformedError: It is another one, or none.
    """
    if text is None:
        return
    fields = text.split(".")
    if not fields[-1]:
        fields.pop()
    if len(fields) != 2:
        raise MalformedError("The version attribute should be in the form 'x.y'")
    if [_unsigned(field) for field in fields] != [1, 0]:
        raise MalformedError("Invalid 'version' specified; only version 1.0 is currently supported")


def _unsigned(text: str) -> int:
    if not text:
        raise MalformedError("One of the fields of the version attribute is blank")
    match = re.fullmatch(_INTEGER, text)
    if match is None:
        raise MalformedError("Version attribute is not an integer")
    if match[2]:
        raise MalformedError("Extra characters after the version number")
    value = int(match[1][:_LONGEST])
    if value < 0:
        raise MalformedError("Version number must be positive")
    return value
