"""The configuration of RViz, a `.rviz` file: of what it can say, that which this kit can show.

Source: files that RViz 1.14 writes, e.g. those of the package urdf_tutorial.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, Final

from simkit.errors import SimkitError
from simkit.graph.names import is_legal_name
from simkit.viz.stage.parts import Color
from simkit.viz.stage.rviz_settings import (
    DESCRIPTION,
    KEEP,
    MOST_KEPT,
    ODOMETRY_COLOR,
    PATH_COLOR,
    LaserScanDisplay,
    OdometryDisplay,
    PathDisplay,
    RobotDisplay,
    RvizSettings,
    TopicDisplay,
)

_LONGEST = 1_000_000
"Longest file [bytes]; those of RViz have some ten thousand."
_DEEPEST = 10
"So many groups may be in each other."


def read_config(path: str | Path) -> RvizSettings:
    """The settings of a file.

    Args:
        path: The `.rviz` file.

    Raises:
        SimkitError: It cannot be read, or is no configuration of RViz.
    """
    import yaml

    try:
        with Path(path).open("rb") as file:
            data = yaml.safe_load(file.read(_LONGEST))
    except OSError as error:
        raise SimkitError(f"cannot read {path}: {error.strerror}") from None
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        mark = getattr(error, "problem_mark", None)
        place = f":{mark.line + 1}:{mark.column + 1}" if mark is not None else ""
        reason = getattr(error, "problem", None) or type(error).__name__
        raise SimkitError(
            f"{path}{place} is no configuration of RViz, which is YAML: {reason}"
        ) from None
    manager = _part(data, "Visualization Manager")
    if not manager:
        raise SimkitError(f"{path} is no configuration of RViz: it has no 'Visualization Manager'")
    return _settings(manager)


def _settings(manager: Mapping[Any, Any]) -> RvizSettings:
    listed = list(_displays(manager))
    displays = {str(display.get("Class")): display for display in listed}
    robots = [display for display in listed if display.get("Class") == "rviz/RobotModel"]
    robot = robots[0] if robots else {}
    role = "visual" if robot.get("Visual Enabled", True) is not False else None
    if role is None and robot.get("Collision Enabled") is True:
        role = "collision"
    return RvizSettings(
        fixed_frame=str(_part(manager, "Global Options").get("Fixed Frame") or "").lstrip("/"),
        robot_model=role if robot else None,
        alpha=_opacity(robot.get("Alpha")),
        show_tf="rviz/TF" in displays,
        show_grid="rviz/Grid" in displays,
        robots=tuple(map(_robot, robots)) or (RobotDisplay(),),
        topics=topic_displays(listed),
    )


def _robot(display: Mapping[Any, Any]) -> RobotDisplay:
    parameter = str(display.get("Robot Description") or DESCRIPTION)
    prefix = str(display.get("TF Prefix") or "")
    return RobotDisplay(f"/{parameter.lstrip('/')}", prefix.strip("/"))


def _displays(group: Mapping[Any, Any], depth: int = 0) -> Iterator[Mapping[Any, Any]]:
    """Those that are on, also in groups."""
    listed = group.get("Displays")
    for display in listed if isinstance(listed, list) else ():
        if not isinstance(display, dict) or display.get("Enabled", True) is False:
            continue
        if display.get("Class") != "rviz/Group":
            yield display
        elif depth < _DEEPEST:
            yield from _displays(display, depth + 1)


def _part(data: object, name: str) -> Mapping[Any, Any]:
    part = data.get(name) if isinstance(data, dict) else None
    return part if isinstance(part, dict) else {}


def _opacity(value: object) -> float:
    if isinstance(value, int | float) and 0.0 <= value <= 1.0:
        return float(value)
    return 1.0


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
