"""The pen that a turtle carries."""

from __future__ import annotations

from dataclasses import dataclass, replace

from simkit.nodes.turtlesim.window import Rgb


@dataclass(frozen=True, slots=True, kw_only=True)
class Pen:
    """Colour, width and state of a pen; a new turtle's pen is this one's defaults."""

    color: Rgb = (179, 184, 255)
    """Colour of what it draws."""
    width: int = 3
    """Width of what it draws [px]."""
    is_down: bool = True
    """Whether it draws."""

    def lifted(self) -> Pen:
        """The same pen off the paper; colour and width stay."""
        return replace(self, is_down=False)


def new_pen(color: Rgb, width: int) -> Pen:
    """The pen that `set_pen` puts down.

    Args:
        color: Colour of what it draws.
        width: Width [px]; 0 means 1.

    Source:
        turtlesim `Turtle::setPenCallback`: a width of 0 leaves the 1 px of a new Qt pen.
    """
    return Pen(color=color, width=width or 1)
