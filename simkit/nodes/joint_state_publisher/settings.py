"""The parameters of joint_state_publisher: each is looked up as `~name` first, then in the namespace."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from simkit.errors import SimkitError
from simkit.graph import Node

NO_DESCRIPTION = "RuntimeError: The robot_description parameter is required and not set."
"""What the original ends with when nobody has loaded a robot."""


class Crash(SimkitError):
    """The program cannot go on: where the original ends with a traceback, this one ends with its last line.

    Args:
        last_line: Last line of the traceback that the original ends with; empty if it has none.
        text: What is wrong and what to do, in a sentence for people.
    """

    def __init__(self, last_line: str, text: str) -> None:
        super().__init__(text)
        self.last_line = last_line


@dataclass(frozen=True, slots=True, kw_only=True)
class SliderSettings:
    """What the parameters say."""

    description: str
    """`robot_description`: the robot as XML."""
    rate: float
    """`rate`: messages per second."""
    source_list: tuple[str, ...]
    """`source_list`: topics with JointState messages that move the joints."""
    zeros: Mapping[str, Any]
    """`zeros`: where joints stand at the beginning [rad or m]."""
    dependent_joints: Mapping[str, Any]
    """`dependent_joints`: joints that follow others: `{parent: ..., factor: ..., offset: ...}`."""
    use_mimic_tags: bool
    """`use_mimic_tags`: whether a joint with `<mimic>` follows."""
    use_smallest_joint_limits: bool
    """`use_smallest_joint_limits`: whether soft limits narrow the range."""
    publish_default_positions: bool
    """`publish_default_positions`: whether a joint that nobody moved has a position."""
    publish_default_velocities: bool
    """`publish_default_velocities`: whether it has a velocity, 0."""
    publish_default_efforts: bool
    """`publish_default_efforts`: whether it has an effort, 0."""
    delta: float
    """`delta`: each joint moves so far per message, to and fro [rad or m]; 0 keeps them still."""


def look_up(node: Node, name: str, default: Any = None) -> Any:
    """A parameter, private or else of the namespace."""
    for place in (f"~{name}", name):
        if node.has_param(place):
            return node.get_param(place)
    return default


def read_settings(node: Node) -> SliderSettings:
    """The settings of a node.

    Raises:
        Crash: There is no robot, or a value is invalid.
    """
    return SliderSettings(
        description=_description(node),
        rate=_positive(node, "rate", 10),
        source_list=tuple(map(str, _of_type(node, "source_list", list, []))),
        zeros=_of_type(node, "zeros", dict, {}),
        dependent_joints=_of_type(node, "dependent_joints", dict, {}),
        use_mimic_tags=bool(look_up(node, "use_mimic_tags", True)),
        use_smallest_joint_limits=bool(look_up(node, "use_smallest_joint_limits", True)),
        publish_default_positions=bool(look_up(node, "publish_default_positions", True)),
        publish_default_velocities=bool(look_up(node, "publish_default_velocities", False)),
        publish_default_efforts=bool(look_up(node, "publish_default_efforts", False)),
        delta=to_number(look_up(node, "delta", 0.0), "the parameter delta"),
    )


def to_number(value: object, what: str) -> float:
    """A value as a number.

    Raises:
        Crash: It is not a number.
    """
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise Crash("", f"{what} must be a number, not {value!r}")
    return float(value)


def _description(node: Node) -> str:
    value = look_up(node, "robot_description")
    if value is None:
        raise Crash(
            NO_DESCRIPTION,
            "no robot is loaded: in the launch file, <param name='robot_description' "
            "textfile='$(find my_package)/urdf/my_robot.urdf'/> must stand outside of any <node>",
        )
    if not isinstance(value, str):
        raise Crash("", "the parameter robot_description must be the text of a URDF file")
    return value


def _positive(node: Node, name: str, default: float) -> float:
    value = to_number(look_up(node, name, default), f"the parameter {name}")
    if value <= 0.0:
        raise Crash("", f"the parameter {name} must be greater than 0, not {value:g}")
    return value


def _of_type(node: Node, name: str, kind: type, default: Any) -> Any:
    value = look_up(node, name, default)
    if not isinstance(value, kind):
        form = "a list: [a, b]" if kind is list else "a table: {a: 1.0, b: 2.0}"
        raise Crash("", f"the parameter {name} must be {form}, not {value!r}")
    return value
