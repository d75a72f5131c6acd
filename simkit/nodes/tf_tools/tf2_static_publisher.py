"""static_transform_publisher of the package tf2_ros: sends one transform once, on the latched /tf_static.

Source: tf2_ros `static_transform_broadcaster_program.cpp`, Noetic.
"""

from __future__ import annotations

from typing import Any

from simkit.graph import Node
from simkit.msgs import MessageError, fill_message, message_class
from simkit.nodes.program import Program
from simkit.nodes.tf_tools.fixed_transform import (
    BadTransformError,
    WrongNumberError,
    parse_transform,
    tell_reading,
)
from simkit.nodes.tf_tools.numbers import is_number
from simkit.tf import StaticTransformBroadcaster

USAGE = """\
Sends one transform that holds for ever.
Usage: static_transform_publisher x y z qx qy qz qw frame_id child_frame_id
OR
Usage: static_transform_publisher x y z yaw pitch roll frame_id child_frame_id
OR
Usage: static_transform_publisher /param_name

It is the pose of child_frame_id in frame_id.
"""
"""What the program prints when its arguments are wrong."""


class Tf2StaticTransformPublisher(Program):
    """The program `static_transform_publisher` of the package tf2_ros.

    Args:
        node: Its place in the graph.
        argv: Six or seven numbers, parent and child; or the name of a parameter that holds a
            geometry_msgs/TransformStamped.
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        try:
            message = self._from_parameter(argv[0]) if len(argv) == 1 else self._from_words(argv)
        except WrongNumberError:
            self._print(USAGE)
            node.error(
                "static_transform_publisher exited due to not having the right number of arguments"
                + _forgotten_period(argv)
            )
            self._exit(255)
            return
        except BadTransformError as error:
            node.fatal(str(error))
            self._exit(1)
            return
        message.header.stamp = node.now()
        StaticTransformBroadcaster(node).send_transform(message)
        node.info(
            f"Spinning until killed publishing {message.header.frame_id} "
            f"to {message.child_frame_id}"
        )

    def _from_words(self, words: list[str]) -> Any:
        # One word more than with angles may be the period that the program of tf takes.
        if len(words) == 9 and is_number(words[-1]) and not is_number(words[6]):
            raise WrongNumberError
        transform = parse_transform(words)
        tell_reading(self._node, transform)
        return transform.message()

    def _from_parameter(self, name: str) -> Any:
        self._node.info(f"Looking for TF in parameter: {name}")
        value = self._node.get_param(name, None)
        if value is None:
            raise BadTransformError(f"Could not read TF from parameter server: {name}")
        try:
            return fill_message(message_class("geometry_msgs/TransformStamped"), value)
        except MessageError as error:
            raise BadTransformError(f"Could not validate XmlRpcC TF: {error}") from error


def _forgotten_period(words: list[str]) -> str:
    if len(words) in (9, 10) and is_number(words[-1]):
        return "; the last number looks like a period, which tf takes and tf2_ros does not"
    return ""
