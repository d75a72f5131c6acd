"""The robot that a parameter describes, as RViz' RobotModel display reads it."""

from __future__ import annotations

from typing import Final

from simkit.packages import PackagePath
from simkit.urdf import UrdfError, load_robot
from simkit.viz.robot_solids import RobotShapes, robot_shapes

DESCRIPTION: Final = "/robot_description"
"""Parameter that holds the URDF of a robot."""


def described_robot(
    value: object, packages: PackagePath, *, name: str = DESCRIPTION, alpha: float = 1.0
) -> RobotShapes | None:
    """The shapes of the robot that a parameter describes, or why there are none.

    Args:
        value: The value of the parameter; None if it is not set.
        packages: Where `package://` leads.
        name: The parameter.
        alpha: Opacity of the whole robot, from 0 to 1.

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
        return robot_shapes(load_robot(value, file=name, packages=packages), alpha=alpha)
    except UrdfError as error:
        reason = next((line.strip() for line in str(error).splitlines() if line.strip()), "")
        return _nothing(f"URDF failed Model parse: {reason}")


def _nothing(error: str) -> RobotShapes:
    return RobotShapes(error=error)
