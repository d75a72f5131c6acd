"""A picture of the turtles and their trails, as SVG, as PNG, and inline in a notebook.

The turtles are our own drawing, one metre long, in one of eight calm colours.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from simkit.nodes.turtlesim import Frame, Stroke, Turtle
from simkit.nodes.turtlesim.window import SIDE_PX, Point, hex_rgb, pixel
from simkit.viz.draw.drawing import Area, Drawing, Ellipse, Group, Label, Plain, Polyline, Shape
from simkit.viz.draw.files import DrawnPicture
from simkit.viz.draw.thinning import simplified

INVISIBLE_PX = 0.05  # a trail may be moved by so much to save points
LABEL_PX = 13.0


class Picture(DrawnPicture):
    """What the window of turtlesim shows at one moment, 500 x 500 pixels; it does not change afterwards.

    Trails lie in the order in which they began, turtles above them in the order of their names.

    Args:
        frame: The window to take the picture of.
        names: Write each turtle's name below it.
    """

    SCALE = 1.0

    def __init__(self, frame: Frame, *, names: bool = False) -> None:
        self._drawing = _drawing(frame, names=names)

    def drawing(self) -> Drawing:
        """The window."""
        return self._drawing

    def _repr_png_(self) -> bytes:
        return self.to_png()


def _drawing(frame: Frame, *, names: bool) -> Drawing:
    visible = [turtle for turtle in frame.turtles if _is_somewhere(turtle)]
    shapes: list[Shape] = [_trail(stroke) for stroke in frame.paper.strokes]
    shapes += [_body(turtle) for turtle in visible]
    background = hex_rgb(frame.paper.background)
    if names:
        shapes += [_label(turtle, background) for turtle in visible]
    count = len(visible)
    return Drawing(
        title=f"turtlesim with {count} turtle{'' if count == 1 else 's'}",
        description=" ".join(_whereabouts(turtle) for turtle in visible) or "The window is empty.",
        size=(SIDE_PX, SIDE_PX),
        background=background,
        shapes=tuple(shapes),
    )


def _trail(stroke: Stroke) -> Polyline:
    points = simplified([pixel(point) for point in stroke.points], INVISIBLE_PX)
    return Polyline(points=tuple(points), color=hex_rgb(stroke.pen.color), width=stroke.pen.width)


def _body(turtle: Turtle) -> Group:
    pose = turtle.pose
    return Group(
        title=_whereabouts(turtle),
        shapes=turtle_shapes(turtle.number),
        origin=pixel((pose.x, pose.y)),
        angle=-math.degrees(pose.theta),
    )


def _label(turtle: Turtle, background: str) -> Label:
    pose = turtle.pose
    x, y = pixel((pose.x, pose.y))
    name = _printable(turtle.name)
    half = 0.31 * LABEL_PX * len(name) + 4
    below = y + 38
    return Label(
        place=(min(max(x, half), SIDE_PX - half), below if below < SIDE_PX - 4 else y - 28),
        text=name,
        color="#ffffff",
        size=LABEL_PX,
        align="middle",
        halo=background,
    )


def _whereabouts(turtle: Turtle) -> str:
    pose = turtle.pose
    name = _printable(turtle.name)
    heading = round(math.degrees(pose.theta))
    return f"{name} at x = {pose.x:.2f} m, y = {pose.y:.2f} m, heading {heading} degrees."


def _printable(name: str) -> str:
    return "".join(letter for letter in name if letter.isprintable())


def _is_somewhere(turtle: Turtle) -> bool:
    pose = turtle.pose
    return all(math.isfinite(value) for value in (pose.x, pose.y, pose.theta))


@dataclass(frozen=True, slots=True, kw_only=True)
class _TurtleColors:
    """The colours of one turtle."""

    skin: str
    """Head, legs and tail."""
    shell: str
    """The plates of its shell."""
    rim: str
    """Rim and seams of its shell, and its eyes."""


_COLORS = (
    _TurtleColors(skin="#c9e3a6", shell="#5fa86f", rim="#28543b"),
    _TurtleColors(skin="#f4e0a9", shell="#dba23f", rim="#6f4a14"),
    _TurtleColors(skin="#f6cfc0", shell="#d9776a", rim="#742f2c"),
    _TurtleColors(skin="#c3e8e3", shell="#48a8a3", rim="#184d50"),
    _TurtleColors(skin="#e6d2ee", shell="#a873bb", rim="#4d2a5b"),
    _TurtleColors(skin="#ebdcc6", shell="#ac8664", rim="#4f3828"),
    _TurtleColors(skin="#dbe2ea", shell="#8796ab", rim="#354050"),
    _TurtleColors(skin="#f6d3e0", shell="#d1709b", rim="#642744"),
)
"""Colours of the first turtle of a frame, the second, ...; the ninth looks like the first."""


def turtle_shapes(number: int) -> tuple[Plain, ...]:
    """Shapes of a turtle that looks along x, its middle at the origin [px].

    Args:
        number: How many turtles came before it in its frame.
    """
    colors = _COLORS[number % len(_COLORS)]
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


def _limbs(skin: str) -> tuple[Plain, ...]:
    legs = tuple(
        Ellipse(center=(x, side * y), radii=radii, fill=skin, angle=side * angle)
        for x, y, radii, angle in ((11.0, 13.0, (8.0, 4.2), 50.0), (-11.5, 11.5, (6.6, 3.8), 128.0))
        for side in (-1.0, 1.0)
    )
    tail = Area(points=((-14.0, -3.0), (-21.5, 0.0), (-14.0, 3.0)), fill=skin)
    return (*legs, tail, Ellipse(center=(19.5, 0.0), radii=(6.8, 5.4), fill=skin))


def _hexagon(radius: float) -> tuple[Point, ...]:
    flatness = 0.82  # the shell is as much wider than long
    angles = [math.radians(60.0 * corner) for corner in range(6)]
    return tuple(
        (round(radius * math.cos(angle), 3), round(radius * flatness * math.sin(angle), 3))
        for angle in angles
    )
