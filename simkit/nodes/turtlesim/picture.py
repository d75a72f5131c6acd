"""A picture of the turtles and their trails, as SVG, as PNG, and inline in a notebook."""

from __future__ import annotations

import math
from pathlib import Path

from simkit.nodes.turtlesim.frame import Frame
from simkit.nodes.turtlesim.paper import Stroke
from simkit.nodes.turtlesim.shapes import Group, Polyline, Scene, Shape, Text
from simkit.nodes.turtlesim.simplify import simplified
from simkit.nodes.turtlesim.svg import svg_text
from simkit.nodes.turtlesim.turtle import Turtle
from simkit.nodes.turtlesim.turtle_shape import turtle_shapes
from simkit.nodes.turtlesim.window import SIDE_PX, hex_color, pixel
from simkit.saving import save_as

INVISIBLE_PX = 0.05  # a trail may be moved by so much to save points
LABEL_PX = 13.0


class Picture:
    """What the window of turtlesim shows at one moment; it does not change afterwards.

    Trails lie in the order in which they began, turtles above them in the order of their names.

    Args:
        frame: The window to take the picture of.
        names: Write each turtle's name below it.
    """

    def __init__(self, frame: Frame, *, names: bool = False) -> None:
        self._scene = _scene(frame, names=names)

    def to_svg(self) -> str:
        """The picture as an SVG document; equal pictures give equal text."""
        return svg_text(self._scene)

    def to_png(self, scale: float = 1) -> bytes:
        """The picture as a PNG file of 500 x 500 pixels, times `scale`."""
        from simkit.nodes.turtlesim.png import png_bytes

        return png_bytes(self._scene, scale)

    def save(self, path: str | Path) -> None:
        """Write the picture to a file, as SVG or PNG by its suffix.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        save_as(path, {".png": lambda: self.to_png(scale=2), ".svg": self.to_svg})

    def _repr_svg_(self) -> str:
        return self.to_svg()

    def _repr_png_(self) -> bytes:
        return self.to_png()


def _scene(frame: Frame, *, names: bool) -> Scene:
    visible = [turtle for turtle in frame.turtles if _is_somewhere(turtle)]
    shapes: list[Shape] = [_trail(stroke) for stroke in frame.paper.strokes]
    shapes += [_body(turtle) for turtle in visible]
    background = hex_color(frame.paper.background)
    if names:
        shapes += [_label(turtle, background) for turtle in visible]
    count = len(visible)
    return Scene(
        title=f"turtlesim with {count} turtle{'' if count == 1 else 's'}",
        description=" ".join(_whereabouts(turtle) for turtle in visible) or "The window is empty.",
        side=SIDE_PX,
        background=background,
        shapes=tuple(shapes),
    )


def _trail(stroke: Stroke) -> Polyline:
    points = simplified([pixel(point) for point in stroke.points], INVISIBLE_PX)
    return Polyline(points=tuple(points), color=hex_color(stroke.pen.color), width=stroke.pen.width)


def _body(turtle: Turtle) -> Group:
    pose = turtle.pose
    return Group(
        title=_whereabouts(turtle),
        origin=pixel((pose.x, pose.y)),
        angle=-math.degrees(pose.theta),
        shapes=turtle_shapes(turtle.number),
    )


def _label(turtle: Turtle, background: str) -> Text:
    pose = turtle.pose
    x, y = pixel((pose.x, pose.y))
    name = _printable(turtle.name)
    half = 0.31 * LABEL_PX * len(name) + 4
    below = y + 38
    return Text(
        center=(min(max(x, half), SIDE_PX - half), below if below < SIDE_PX - 4 else y - 28),
        text=name,
        size=LABEL_PX,
        color="#ffffff",
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
