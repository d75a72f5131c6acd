"""Which robot a node is told of: the nearest parameter robot_description, read once."""

from __future__ import annotations

from collections.abc import Callable

from simkit.errors import SimkitError
from simkit.graph import Node
from simkit.graph.names import namespace_of, resolve
from simkit.urdf import Robot, read_robot
from simkit.urdf.loading import robot_of

PARAMETER = "robot_description"
"""Parameter with the text of the URDF file."""


class NoRobotError(SimkitError):
    """Nobody has loaded a robot."""


def find_robot(node: Node, tell: Callable[[str], None]) -> Robot:
    """The robot that a node finds on the parameter server.

    Args:
        node: Whose namespace is searched, from the inside out.
        tell: Is given each thing that urdfdom says of the file, as it prints it.

    Raises:
        NoRobotError: There is no such parameter.
        UrdfError: urdfdom refuses the robot.
    """
    name = _parameter_name(node)
    if name is None:
        raise NoRobotError(f"Could not find parameter {PARAMETER} on parameter server")
    text = node.graph.params.get(name)
    if not isinstance(text, str):
        raise NoRobotError(f"Could not read parameter {PARAMETER} on parameter server")
    reading = read_robot(text, file=PARAMETER)
    for message in reading.messages:
        tell(message)
    return robot_of(reading)


def _parameter_name(node: Node) -> str | None:
    params, remapped = node.graph.params, node.resolve(PARAMETER)
    if remapped != resolve(PARAMETER, node.name):
        return remapped if params.has(remapped) else None
    return params.search(namespace_of(node.name), PARAMETER)
