"""What a picture is made of; `svg` and `figure` both draw these and nothing else.

Coordinates are pixels, x to the right, y down; inside a `Group` they are the group's own. Colours are
`#rrggbb`, or empty for none.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias

Point: TypeAlias = tuple[float, float]
"""x to the right, y down [px]."""

SANS = "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif"
"""Letters of every picture: the widest first, since room is measured for it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Polyline:
    """An open line with round ends and corners."""

    points: tuple[Point, ...]
    """Corners [px]."""
    color: str
    """Colour of the line."""
    width: float = 1.0
    """Width of the line [px]."""
    dashed: bool = False
    """Whether it is broken."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Curve:
    """A cubic Bézier curve."""

    points: tuple[Point, Point, Point, Point]
    """Start, the two points that pull, end [px]."""
    color: str
    """Colour of the line."""
    width: float = 1.0
    """Width of the line [px]."""
    dashed: bool = False
    """Whether it is broken."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Area:
    """A filled area with straight sides."""

    points: tuple[Point, ...]
    """Corners [px]."""
    fill: str
    """Colour of the area."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Ellipse:
    """A filled ellipse."""

    center: Point
    """Its middle [px]."""
    radii: Point
    """Half its length along its own x and y [px]."""
    fill: str
    """Colour of the area."""
    angle: float = 0.0
    """Turn of its x, clockwise on the screen [degrees]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RoundedBox:
    """A rectangle with round corners."""

    corner: Point
    """Upper left corner [px]."""
    size: Point
    """Width and height [px]."""
    fill: str = ""
    """Colour of the area."""
    edge: str = ""
    """Colour of the border."""
    radius: float = 0.0
    """Radius of the corners [px]."""
    dashed: bool = False
    """Whether its border is broken."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Label:
    """A line of text."""

    place: Point
    """Where its baseline begins, has its middle, or ends [px]."""
    text: str
    """What it says."""
    color: str
    """Colour of the letters."""
    size: float = 12.0
    """Size of the letters [px]."""
    align: Literal["start", "middle", "end"] = "start"
    """Which part of the baseline is at the place."""
    bold: bool = False
    """Whether the letters are bold."""
    halo: str = ""
    """Colour around the letters, for text on top of lines."""


Plain: TypeAlias = Polyline | Curve | Area | Ellipse | RoundedBox | Label
"""A shape that is drawn by itself."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Group:
    """Shapes that are one thing, moved and turned as one."""

    title: str
    """What it is, for screen readers and tooltips."""
    shapes: tuple[Plain, ...]
    """The shapes, lowest first."""
    origin: Point | None = None
    """Where the group's own origin lies [px]; that of the drawing if None."""
    angle: float = 0.0
    """Turn of the group's x about its origin, clockwise on the screen [degrees]."""


Shape: TypeAlias = Plain | Group


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawing:
    """A whole picture."""

    title: str
    """What it is, in a few words."""
    description: str
    """What is to be seen, in a sentence or two."""
    size: Point
    """Width and height [px]."""
    background: str
    """Colour of the ground."""
    shapes: tuple[Shape, ...]
    """The shapes, lowest first."""
