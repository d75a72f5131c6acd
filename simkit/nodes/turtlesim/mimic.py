"""mimic: does with one turtle what another one does.

Source: turtlesim tutorial `mimic`.
"""

from __future__ import annotations

from typing import Any

from simkit.graph import Node
from simkit.msgs import message_class


class TurtleMimic:
    """The node `mimic` of the package turtlesim: speeds on `input/pose` become `output/cmd_vel`.

    Args:
        node: Its place in the graph.
        _argv: Arguments of its command line; it takes none.
    """

    def __init__(self, node: Node, _argv: list[str]) -> None:
        self._twist_class: Any = message_class("geometry_msgs/Twist")
        # `input` and `output` are namespaces, and a remapping moves a whole one: input:=turtle1.
        output, pose = node.resolve("output") + "/cmd_vel", node.resolve("input") + "/pose"
        self._publisher = node.advertise(output, self._twist_class, queue_size=1)
        node.subscribe(pose, message_class("turtlesim/Pose"), self._on_pose, queue_size=1)

    def _on_pose(self, pose: Any) -> None:
        twist = self._twist_class()
        twist.linear.x = pose.linear_velocity
        twist.angular.z = pose.angular_velocity
        self._publisher.publish(twist)
