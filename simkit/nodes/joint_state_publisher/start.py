"""Which program a command line begins: `use_gui` turns the publisher into the one with sliders."""

from __future__ import annotations

from simkit.graph import Node
from simkit.nodes.joint_state_publisher.gui import JointStatePublisherGui
from simkit.nodes.joint_state_publisher.node import JointStatePublisher
from simkit.nodes.joint_state_publisher.settings import look_up

DEPRECATED = (
    "The 'use_gui' parameter was specified, which is deprecated. It counts here, as in Melodic; "
    "Noetic ignores it and shows no sliders: there, start the node joint_state_publisher_gui of "
    "the package joint_state_publisher_gui instead."
)
"""What the parameter `use_gui` is answered with."""


def start_joint_state_publisher(node: Node, argv: list[str]) -> JointStatePublisher:
    """The program `joint_state_publisher` of Melodic.

    Args:
        node: Its place in the graph.
        argv: Arguments of its command line.
    """
    if not look_up(node, "use_gui", False):
        return JointStatePublisher(node, argv)
    node.warn(DEPRECATED)
    return JointStatePublisherGui(node, argv)
