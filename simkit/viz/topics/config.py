"""The displays of topics in the configuration of RViz.

Source: files that RViz 1.14 writes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final

from simkit.graph.names import is_legal_name
from simkit.viz.solid import Color
from simkit.viz.topics.displays import (
    KEEP,
    MOST_KEPT,
    ODOMETRY_COLOR,
    PATH_COLOR,
    LaserScanDisplay,
    OdometryDisplay,
    PathDisplay,
    TopicDisplay,
)

MOST_DISPLAYS: Final = 20
"""Of a file with more displays of topics, the first ones are shown."""


def topic_displays(displays: Iterable[Mapping[Any, Any]]) -> tuple[TopicDisplay, ...]:
    """The displays of topics that this kit has, each with what its file says of it.

    What is not there, or makes no sense, is as RViz has it at first.

    Args:
        displays: The displays of a file that are on.
    """
    found = []
    for display in displays:
        read = _READERS.get(str(display.get("Class")))
        topic = display.get("Topic")
        name = f"/{topic.strip().lstrip('/')}" if isinstance(topic, str) else "/"
        if read is not None and name != "/" and is_legal_name(name):
            found.append(read(display, name))
    return tuple(found[:MOST_DISPLAYS])


def _laser_scan(display: Mapping[Any, Any], topic: str) -> TopicDisplay:
    is_flat = display.get("Color Transformer") == "FlatColor"
    color = _color(display.get("Color"), (1.0, 1.0, 1.0)) if is_flat else None
    return LaserScanDisplay(topic=topic, color=color)


def _odometry(display: Mapping[Any, Any], topic: str) -> TopicDisplay:
    shape = display.get("Shape")
    shape = shape if isinstance(shape, dict) else {}
    keep = _number(display.get("Keep"), KEEP)
    lengths = (_number(shape.get(part), usual) for part, usual in _ARROW_PARTS)
    return OdometryDisplay(
        topic=topic,
        color=_color(shape.get("Color"), ODOMETRY_COLOR),
        # RViz keeps all for 0.
        keep=min(int(keep), MOST_KEPT) if keep >= 1 else MOST_KEPT,
        position_tolerance=_number(display.get("Position Tolerance"), 0.1),
        angle_tolerance=_number(display.get("Angle Tolerance"), 0.1),
        length=math.fsum(lengths),
    )


def _path(display: Mapping[Any, Any], topic: str) -> TopicDisplay:
    return PathDisplay(topic=topic, color=_color(display.get("Color"), PATH_COLOR))


_READERS: Final[Mapping[str, Callable[[Mapping[Any, Any], str], TopicDisplay]]] = {
    "rviz/LaserScan": _laser_scan,
    "rviz/Odometry": _odometry,
    "rviz/Path": _path,
}
_ARROW_PARTS: Final = (("Shaft Length", 1.0), ("Head Length", 0.3))


def _number(value: object, usual: float) -> float:
    """A number of a file if it is one from 0 on."""
    if isinstance(value, int | float) and not isinstance(value, bool) and 0.0 <= value < math.inf:
        return float(value)
    return usual


def _color(value: object, usual: Color) -> Color:
    """`255; 25; 0` as shares."""
    try:
        red, green, blue = (float(part) / 255.0 for part in str(value).split(";"))
    except ValueError:
        return usual
    return (red, green, blue) if all(0.0 <= c <= 1.0 for c in (red, green, blue)) else usual
