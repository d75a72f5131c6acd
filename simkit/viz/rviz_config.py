"""The configuration of RViz, a `.rviz` file: of what it can say, that which this kit can show.

Source: files that RViz writes, e.g. those of the package urdf_tutorial.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from simkit.errors import SimkitError
from simkit.viz.robot_description import DESCRIPTION, RobotDisplay
from simkit.viz.rviz_settings import RvizSettings
from simkit.viz.topics.config import topic_displays

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
