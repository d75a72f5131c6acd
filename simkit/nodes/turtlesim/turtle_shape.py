"""How a turtle looks from above: our own drawing, one metre long, in one of eight calm colours."""

from __future__ import annotations

import math
from dataclasses import dataclass

from simkit.nodes.turtlesim.shapes import Ellipse, Polygon, Polyline
from simkit.nodes.turtlesim.window import Point


@dataclass(frozen=True, slots=True, kw_only=True)
class TurtleColors:
    """The colours of one turtle."""

    skin: str
    """Head, legs and tail."""
    shell: str
    """The plates of its shell."""
    rim: str
    """Rim and seams of its shell, and its eyes."""


COLORS = (
    TurtleColors(skin="#c9e3a6", shell="#5fa86f", rim="#28543b"),
    TurtleColors(skin="#f4e0a9", shell="#dba23f", rim="#6f4a14"),
    TurtleColors(skin="#f6cfc0", shell="#d9776a", rim="#742f2c"),
    TurtleColors(skin="#c3e8e3", shell="#48a8a3", rim="#184d50"),
    TurtleColors(skin="#e6d2ee", shell="#a873bb", rim="#4d2a5b"),
    TurtleColors(skin="#ebdcc6", shell="#ac8664", rim="#4f3828"),
    TurtleColors(skin="#dbe2ea", shell="#8796ab", rim="#354050"),
    TurtleColors(skin="#f6d3e0", shell="#d1709b", rim="#642744"),
)
"""Colours of the first turtle of a frame, the second, ...; the ninth looks like the first."""


def turtle_shapes(number: int) -> tuple[Polyline | Polygon | Ellipse, ...]:
    """Shapes of a turtle that looks along x, its middle at the origin [px].

    Args:
        number: How many turtles came before it in its frame.
    """
    colors = COLORS[number % len(COLORS)]
    plate = _hexagon(6.0)
    seams = zip(plate, _hexagon(13.0), strict=True)
    return (
        *_limbs(colors.skin),
        Ellipse(center=(22.2, -2.7), radii=(1.2, 1.2), fill=colors.rim),
        Ellipse(center=(22.2, 2.7), radii=(1.2, 1.2), fill=colors.rim),
        Ellipse(center=(0.0, 0.0), radii=(16.5, 13.5), fill=colors.rim),
        Ellipse(center=(0.0, 0.0), radii=(14.3, 11.3), fill=colors.shell),
        *(Polyline(points=seam, color=colors.rim, width=1.3) for seam in seams),
        Polyline(points=(*plate, plate[0]), color=colors.rim, width=1.3),
    )


def _limbs(skin: str) -> tuple[Polygon | Ellipse, ...]:
    legs = tuple(
        Ellipse(center=(x, side * y), radii=radii, fill=skin, angle=side * angle)
        for x, y, radii, angle in ((11.0, 13.0, (8.0, 4.2), 50.0), (-11.5, 11.5, (6.6, 3.8), 128.0))
        for side in (-1.0, 1.0)
    )
    tail = Polygon(points=((-14.0, -3.0), (-21.5, 0.0), (-14.0, 3.0)), fill=skin)
    return (*legs, tail, Ellipse(center=(19.5, 0.0), radii=(6.8, 5.4), fill=skin))


def _hexagon(radius: float) -> tuple[Point, ...]:
    flatness = 0.82  # the shell is as much wider than long
    angles = [math.radians(60.0 * corner) for corner in range(6)]
    return tuple(
        (round(radius * math.cos(angle), 3), round(radius * flatness * math.sin(angle), 3))
        for angle in angles
    )
