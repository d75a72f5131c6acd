"""The window of turtlesim: its size, its scale, its pace and its first colour.

Source: turtlesim `TurtleFrame` (500 px window, turtle images of 45 px, Qt timer of 16 ms).
"""

from __future__ import annotations

import math
import struct

_FLOAT32 = struct.Struct("<f")


def float32(value: float) -> float:
    """The nearest 32-bit float, which is what turtlesim publishes; infinite where `value` is too large, as in C++."""
    try:
        rounded: float = _FLOAT32.unpack(_FLOAT32.pack(value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)
    return rounded


Rgb = tuple[int, int, int]
"""Red, green and blue, each 0 to 255."""
Point = tuple[float, float]
"""Two coordinates; the name beside it says in which unit and which way up."""

SIDE_PX = 500
"""Width and height of the window [px]."""
METRE_PX = 45
"""Pixels per metre."""
SIDE = float32((SIDE_PX - 1) / METRE_PX)
"""Width and height of the turtles' world [m], 11.088889."""
CENTRE = float32(SIDE / 2)
"""Where turtle1 starts, in x and in y [m], 5.544445."""

TICK_NS = 16_000_000
"""Time from one update of all turtles to the next [ns]."""
TICK = 0.016
"""What every update takes as its length [s], however late it comes."""
COMMAND_LIFETIME_NS = 1_000_000_000
"""A velocity command moves the turtle for so long [ns]."""

BACKGROUND: Rgb = (69, 86, 255)
"""Colour of the window until `~background_r`, `_g` and `_b` say otherwise."""

_FAR_PX = 1e5  # a teleport may draw further out; nothing is seen there


def pixel(point: Point) -> Point:
    """Where a point (x, y up) [m] is in a picture of the window (x, y down) [px]."""
    # Half a pixel more: 0 m and the far wall are the middles of the first and the last pixel.
    x, y_down = point[0] * METRE_PX + 0.5, (SIDE - point[1]) * METRE_PX + 0.5
    return (min(max(x, -_FAR_PX), _FAR_PX), min(max(y_down, -_FAR_PX), _FAR_PX))


def hex_rgb(color: Rgb) -> str:
    """A colour as `#rrggbb`."""
    return "#" + bytes(color).hex()
