"""The joints that a trajectory controller moves, and how far each can go."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Graph
from simkit.urdf import Joint, JointType, load_robot

_KIND = "/JointTrajectoryController"


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlledJoint:
    """A joint with a slider."""

    name: str
    """Its name."""
    lower: float
    """Least position [rad or m]; -pi if it turns without end."""
    upper: float
    """Greatest position [rad or m]; pi if it turns without end."""
    unit: str
    """`rad` or `m`."""

    def clipped(self, position: float) -> float:
        """The nearest position that it can go to."""
        return min(max(position, self.lower), self.upper)


def controlled_joints(
    graph: Graph, controller: str, *, description: str = "/robot_description"
) -> tuple[ControlledJoint, ...]:
    """The joints of a controller, in its order.

    Args:
        graph: Has the parameters.
        controller: Resolved name of the controller, e.g. `/arm_controller`.
        description: Parameter with the URDF of the robot, which has the limits.

    Raises:
        SimkitError: The controller has no parameter `joints`, a joint is none of the robot, or there is no robot.
        UrdfError: The robot cannot be read.
    """
    names = graph.params.get(f"{controller}/joints", None)
    if not isinstance(names, list) or not names or not all(isinstance(n, str) for n in names):
        raise SimkitError(
            f"Could not find 'joints' parameter (namespace: {controller}), a list of names. "
            f"{_known(_controllers(graph))} Load the configuration first, e.g. rosparam load in a launch file."
        )
    text = graph.params.get(description, None)
    if not isinstance(text, str):
        raise SimkitError(
            f"parameter {description} holds no URDF, and the limits of joints are in it"
        )
    joints = load_robot(text, file=description).joints
    for name in names:
        if name not in joints:
            raise UnknownNameError(f"joint of {controller}/joints in {description}", name, joints)
    return tuple(_controlled(joints[name]) for name in names)


def _controlled(joint: Joint) -> ControlledJoint:
    lower, upper = -math.pi, math.pi
    if joint.type is not JointType.CONTINUOUS and joint.limit is not None:
        lower, upper = sorted((joint.limit.lower, joint.limit.upper))
    unit = "m" if joint.type is JointType.PRISMATIC else "rad"
    return ControlledJoint(name=joint.name, lower=lower, upper=upper, unit=unit)


def _controllers(graph: Graph) -> list[str]:
    """Names below the root that have a type of trajectory controller."""
    tree: Any = graph.params.get("/", {})
    found = []
    for name, value in sorted(tree.items()) if isinstance(tree, dict) else ():
        if isinstance(value, dict) and str(value.get("type", "")).endswith(_KIND):
            found.append(f"/{name}")
    return found


def _known(controllers: Iterable[str]) -> str:
    names = ", ".join(controllers)
    return (
        f"Trajectory controllers with parameters: {names}." if names else "No controller has any."
    )
