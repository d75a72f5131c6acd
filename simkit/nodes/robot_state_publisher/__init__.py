"""robot_state_publisher: turns the positions of joints into transforms between links.

Read it in this order: `segments` (its frames), `joint_messages` (which messages count), `node`.

Source: robot_state_publisher 1.15 of ROS Noetic, with kdl_parser.
"""

from simkit.nodes.robot_state_publisher.node import RobotStatePublisher, StatePublisher

__all__ = ["RobotStatePublisher", "StatePublisher"]
