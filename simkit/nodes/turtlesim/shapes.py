"""What a picture is made of; `svg` and `png` both draw these and nothing else.

Coordinates are pixels of the window, x to the right, y down; inside a `Group` they are the group's
own. Colours are `#rrggbb`.
"""

from __future__ import annotations

from dataclasses import dataclass

from simkit.nodes.turtlesim.window import Point


@dataclass(frozen=True, slots=True, kw_only=True)
class Polyline:
    """An open line with round ends and corners."""

    points: tuple[Point, ...]
    """Corners [px]."""
    color: str
    """Colour of the line."""
    width: float
    """Width of the line [px]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Polygon:
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
class Text:
    """A line of text around a point, with a halo that keeps it legible on any ground."""

    center: Point
    """Middle of the text's baseline [px]."""
    text: str
    """What it says."""
    size: float
    """Size of the letters [px]."""
    color: str
    """Colour of the letters."""
    halo: str
    """Colour around the letters."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Group:
    """Shapes that belong together, moved and turned as one."""

    title: str
    """What they are, for screen readers and tooltips."""
    origin: Point
    """Where the group's own origin lies [px]."""
    angle: float
    """Turn of the group's x, clockwise on the screen [degrees]."""
    shapes: tuple[Polyline | Polygon | Ellipse, ...]
    """The shapes, lowest first."""


Shape = Polyline | Polygon | Ellipse | Text | Group


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """A whole picture."""

    title: str
    """What it is, in a few words."""
    description: str
    """What is to be seen, in a sentence or two."""
    side: int
    """Width and height [px]."""
    background: str
    """Colour of the ground."""
    shapes: tuple[Shape, ...]
    """The shapes, lowest first."""
