"""How a scene looks, in the view to turn and in the still picture alike."""

from __future__ import annotations

from typing import Final

from simkit.geometry import Vector
from simkit.viz.stage.parts import Color

AXIS_COLORS: Final = ("#e03b3b", "#2ba84a", "#3f82f2")
"""Of x, y and z."""
AXIS_RADIUS: Final = 0.04
"""Of an axis, in lengths of an axis."""
ARROW_COLOR: Final = "#c08a1e"
"""Of the arrow from a frame to its parent."""
ARROW_RADIUS: Final = 0.018
"""Of its shaft, in lengths of an axis."""
HEAD_RADIUS: Final = 0.06
"""Of its head, which is in the middle, in lengths of an axis."""
HEAD_LENGTH: Final = 0.2
"""Length of its head, in lengths of an axis."""
GHOST: Final = 0.3
"""Opacity of axes inside of a robot."""
LOST_COLOR: Final = "#ffffff"
"""Of a link that tf does not know, as in RViz."""
LOST_ALPHA: Final = 0.6
"""Its opacity."""
CLEAR: Final = 0.35
"""Opacity of what a person has made transparent, on top of its own."""
AMBIENT: Final = 0.6
"""Share of a colour that is seen where no light falls."""
LIGHT: Final[Vector] = (-0.35, 0.5, 1.0)
"""Where the light comes from: right, up, towards the camera."""

SKY: Final = "#e9edf2"
"""The ground of a still picture."""
GRID_COLOR: Final = "#bcc7d3"
"""Of the grid in a still picture."""
ZERO_COLOR: Final = "#8e9cab"
"""Of its lines x = 0 and y = 0."""


def rgb(color: str) -> Color:
    """A colour `#rrggbb` as numbers from 0 to 1."""
    red, green, blue = (int(color[at : at + 2], 16) / 255 for at in (1, 3, 5))
    return red, green, blue


def hex_color(color: Color) -> str:
    """A colour as `#rrggbb`."""
    return "#" + "".join(f"{round(255 * value):02x}" for value in color)
