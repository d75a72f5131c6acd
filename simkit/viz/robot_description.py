"""The robot that a parameter describes, as RViz' RobotModel display reads it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Final

from simkit.diagnostics import Severity
from simkit.packages import PackagePath
from simkit.urdf import UrdfError, load_robot
from simkit.viz.robot_solids import RobotShapes, robot_shapes

DESCRIPTION: Final = "/robot_description"
"""Parameter that holds the URDF of a robot."""
_MOST: Final = 6
"So many faults of a robot that is refused are told."


@dataclass(frozen=True, slots=True)
class RobotDisplay:
    """A display RobotModel: which robot it shows."""

    description: str = DESCRIPTION
    """Parameter with its URDF."""
    tf_prefix: str = ""
    """Its "TF Prefix": what stands before the names of its links in tf; empty if nothing does."""


def robot_displays(
    description: str | Iterable[str] | Mapping[str, str],
) -> tuple[RobotDisplay, ...]:
    """The displays that a person asks for.

    Args:
        description: A parameter, several, or with the TF Prefix of each; `left` and `/left/` are the same.
    """
    names = [description] if isinstance(description, str) else description
    table = names if isinstance(names, Mapping) else dict.fromkeys(names, "")
    return tuple(RobotDisplay(name, prefix.strip("/")) for name, prefix in table.items())


def described_robot(
    value: object,
    packages: PackagePath,
    *,
    name: str = DESCRIPTION,
    alpha: float = 1.0,
    tf_prefix: str = "",
) -> RobotShapes | None:
    """The shapes of the robot that a parameter describes, or why there are none.

    Args:
        value: The value of the parameter; None if it is not set.
        packages: Where `package://` leads.
        name: The parameter.
        alpha: Opacity of the whole robot, from 0 to 1.
        tf_prefix: What stands before the names of its links in tf; empty if nothing does.

    Returns:
        None if nothing is under the usual name: most simulations have no robot, and RViz has no
        RobotModel either until somebody adds one.

    Source:
        RViz' RobotModel display: its words for what is wrong; the reason behind them is ours.
    """
    if value is None:
        if name == DESCRIPTION:
            return None
        return _nothing(f"Parameter [{name}] does not exist, and was not found by searchParam()")
    if not isinstance(value, str):
        return _nothing(f"Parameter [{name}] is no text: it should hold the URDF of a robot")
    if not value.strip():
        return _nothing("URDF is empty")
    try:
        robot = load_robot(value, file=name, packages=packages)
    except UrdfError as error:
        reason = next((line.strip() for line in str(error).splitlines() if line.strip()), "")
        return _nothing(f"URDF failed Model parse: {reason}", *_more_faults(error, reason))
    return robot_shapes(robot, alpha=alpha, tf_prefix=tf_prefix)


def _more_faults(error: UrdfError, told: str) -> Iterator[str]:
    """The other errors of a file, each in a line; of many the first ones."""
    found = [one for one in error.diagnostics if one.severity is Severity.ERROR]
    lines = [
        f"{one.file}:{one.span.line}:{one.span.column}: {one.what}; {one.remedy}" for one in found
    ]
    others = [line for line in dict.fromkeys(lines) if line != told]
    yield from others[:_MOST]
    if len(others) > _MOST:
        yield f"... and {len(others) - _MOST} more: simkit check_urdf shows them all."


def _nothing(*errors: str) -> RobotShapes:
    return RobotShapes(errors=errors)
