"""What the messages of a topic look like in the fixed frame: points, a line, or arrows.

Source: laser_geometry for which ranges are points; RViz' rainbow for their colours.
"""

from __future__ import annotations

import colorsys
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from simkit.geometry import Quaternion, Transform, Vector, rotate
from simkit.viz.draw.letters import abbreviated
from simkit.viz.stage import style
from simkit.viz.stage.parts import Color, Marks, Polyline
from simkit.viz.stage.rviz_settings import LaserScanDisplay, OdometryDisplay, TopicDisplay, label
from simkit.viz.stage.style import hex_color
from simkit.viz.still.surfaces import rotation_array

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


_FAR: Final = 1e12
"Nothing is drawn beyond this distance [m]."
_LONGEST: Final = 34
"Letters of a topic at its checkbox."
_BARB: Final = 0.3
"Length of the head of an arrow, as a share of its length; it is half as wide."


@dataclass(frozen=True, slots=True, kw_only=True)
class Shown:
    """What a display shows at one moment."""

    points: tuple[Vector, ...] = ()
    """Points in the fixed frame [m]."""
    colors: tuple[str, ...] = ()
    """The colour of each point, `#rrggbb`."""
    lines: tuple[Polyline, ...] = ()
    """Lines in the fixed frame [m]; of a trail the oldest first."""
    count: int = 0
    """So many lines there have been, with those that are not kept."""


NOTHING: Final = Shown()
"""What a display shows before its first message."""


def display_marks(display: TopicDisplay, number: int, shown: Shown) -> Marks:
    """What a display shows, as a part of a scene.

    Args:
        display: The display.
        number: Its number among those of the scene.
        shown: What it shows.
    """
    return Marks(
        name=f"topic-{number}",
        label=abbreviated(label(display), _LONGEST),
        color=style.hex_color(display.color or style.rgb(style.AXIS_COLORS[0])),
        points=shown.points,
        colors=shown.colors,
        is_many_colored=isinstance(display, LaserScanDisplay),
        lines=shown.lines,
    )


def scan_shown(display: LaserScanDisplay, scan: Any, place: Transform) -> Shown:
    """The points of a scan.

    Args:
        display: What shows them.
        scan: A sensor_msgs/LaserScan.
        place: Where its frame is in the fixed frame.
    """
    points, colors = laser_points(scan, display.color)
    placed, near = _placed(points, place)
    return Shown(points=_vectors(placed[near]), colors=tuple(colors[near].tolist()))


def path_shown(path: Any, place: Transform) -> Shown:
    """The line through a path; poses with invalid numbers are left out.

    Args:
        path: A nav_msgs/Path; as in RViz, its own frame counts and not those of its poses.
        place: Where its frame is in the fixed frame.
    """
    positions: Iterable[Any] = (stamped.pose.position for stamped in path.poses)
    points = np.array([(p.x, p.y, p.z) for p in positions], dtype=float).reshape(-1, 3)
    placed, near = _placed(points, place)
    line = _vectors(placed[near])
    return Shown(lines=(line,) if line else ())


def arrow_line(display: OdometryDisplay, origin: Vector, rotation: Quaternion) -> Polyline:
    """An arrow along the x of a pose, as one line.

    Args:
        display: Says how long it is.
        origin: Where it begins, in the fixed frame [m].
        rotation: How its pose is turned there, xyzw, of unit length.
    """
    long, barb = display.length, _BARB * display.length
    corners = ((0, 0, 0), (long, 0, 0), (long - barb, barb / 2, 0), (long - barb, -barb / 2, 0))
    tail, tip, left, right = (_at(origin, rotate(rotation, corner)) for corner in corners)
    return (tail, tip, left, right, tip)


def _at(origin: Vector, way: Vector) -> Vector:
    return (origin[0] + way[0], origin[1] + way[1], origin[2] + way[2])


def _placed(points: Points, place: Transform) -> tuple[Points, Any]:
    """Points in the fixed frame, and which of them are near enough to be drawn."""
    with np.errstate(invalid="ignore", over="ignore"):  # NaN is not near either
        placed = points @ rotation_array(place.rotation).T + np.array(place.translation)
    return placed, (np.abs(placed) < _FAR).all(axis=1)


def _vectors(points: Points) -> tuple[Vector, ...]:
    return tuple((x, y, z) for x, y, z in points.tolist())
