"""Marks: points and lines of a scene that are others at each moment, such as contacts, a scan, a path."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Final, TypeAlias

from simkit.geometry import Vector

Polyline: TypeAlias = tuple[Vector, ...]
"""Corners of a line in the fixed frame [m]."""

POINT_SIZE: Final = 0.007
"""Side of a point, as a share of the distance of the camera at first."""
LINE_WIDTH: Final = 0.003
"""Width of a line, as a share of that distance."""
_DIGITS = 4


@dataclass(frozen=True, slots=True, kw_only=True)
class Marks:
    """One display of points and lines, with a checkbox of its own."""

    name: str
    """Its name, of letters and hyphens: no other display of the scene has it."""
    label: str
    """What stands at its checkbox."""
    color: str
    """Its colour, `#rrggbb`."""
    points: tuple[Vector, ...] = ()
    """Points in the fixed frame [m]."""
    colors: tuple[str, ...] = ()
    """A colour for each point, `#rrggbb`, if each has its own."""
    lines: tuple[Polyline, ...] = ()
    """Lines in the fixed frame [m]."""
    is_on: bool = True
    """Whether it is seen at first."""
    shines_through: bool = False
    """Whether it is seen through the shapes that are before it."""
    is_many_colored: bool = False
    """Whether each point has a colour of its own; then it has no lines."""


def marks_data(marks: Marks) -> dict[str, Any]:
    """All of it, for the script of a view."""
    return {
        "name": marks.name,
        "color": marks.color,
        "isMany": marks.is_many_colored,
        "through": marks.shines_through,
        **moment_data(marks),
    }


def moment_data(marks: Marks) -> dict[str, Any]:
    """That of it which changes: coordinates one after the other."""
    data: dict[str, Any] = {
        "points": _flat(marks.points),
        "lines": [_flat(line) for line in marks.lines],
    }
    if marks.colors:
        palette = sorted(set(marks.colors))
        data["palette"] = palette
        data["colors"] = [palette.index(color) for color in marks.colors]
    return data


def _flat(points: Iterable[Vector]) -> list[float]:
    return [round(value, _DIGITS) for point in points for value in point]
