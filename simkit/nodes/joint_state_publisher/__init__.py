"""joint_state_publisher: says where the joints of a robot stand, with or without sliders.

Read it in this order: `settings` (parameters), `joints` (which joints a robot has), `table` (what
is said of them), `node`, `gui` (the sliders), `start` (which of the two a command line begins).

Source: joint_state_publisher 1.15 of ROS Noetic, and 1.12 of Melodic for `use_gui`.
"""

from simkit.nodes.joint_state_publisher.gui import JointStatePublisherGui, SliderJoint
from simkit.nodes.joint_state_publisher.node import JointStatePublisher

__all__ = ["JointStatePublisher", "JointStatePublisherGui", "SliderJoint"]
