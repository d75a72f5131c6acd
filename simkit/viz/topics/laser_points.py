"""A laser scan as coloured points.

Source: laser_geometry for which ranges are points; RViz' rainbow for their colours.
"""

from __future__ import annotations

import colorsys
from typing import Any, Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from simkit.viz.scene_style import hex_color
from simkit.viz.solid import Color

Points: TypeAlias = NDArray[np.float64]
Names: TypeAlias = NDArray[np.str_]

SHADES: Final = 31
"""So many colours a rainbow has."""


def laser_points(scan: Any, color: Color | None = None) -> tuple[Points, Names]:
    """The points of a scan in the frame of the sensor.

    Ranges below `range_min`, from `range_max` on, infinite or not a number are no points.

    Args:
        scan: A sensor_msgs/LaserScan.
        color: Of all points; if None, each has the colour of its range.

    Returns:
        x, y, z [m] with the shape (n, 3), and the colour of each, `#rrggbb`, with the shape (n,).
    """
    ranges = np.asarray(scan.ranges, dtype=float)
    angles = scan.angle_min + scan.angle_increment * np.arange(len(ranges))
    with np.errstate(invalid="ignore"):
        seen = (ranges >= scan.range_min) & (ranges < scan.range_max) & np.isfinite(angles)
    ranges, angles = ranges[seen], angles[seen]
    points = np.stack([ranges * np.cos(angles), ranges * np.sin(angles), 0.0 * ranges], axis=1)
    if color is not None:
        return points, np.full(len(points), hex_color(color))
    way = float(scan.range_max) - float(scan.range_min)
    return points, rainbow((ranges - scan.range_min) / (way if 0.0 < way < np.inf else 1.0))


def rainbow(shares: Points) -> Names:
    """From red at 0 over yellow, green, blue to violet at 1, in a few steps.

    Args:
        shares: Shape (n,).

    Returns:
        `#rrggbb`, shape (n,).
    """
    steps = np.round((SHADES - 1) * np.clip(np.nan_to_num(shares), 0.0, 1.0)).astype(int)
    found: Names = _SHADES[steps]
    return found


_SHADES = np.array(
    [
        hex_color(colorsys.hsv_to_rgb(5 / 6 * step / (SHADES - 1), 1.0, 1.0))
        for step in range(SHADES)
    ]
)
