"""joint_state_publisher: publishes where the joints of a robot stand, with or without sliders.

Read it in this order: `settings` (parameters), `joints` (which joints a robot has), `node` (what is
published of them), `gui` (the sliders).

Source: joint_state_publisher 1.15 of ROS Noetic, and 1.12 of Melodic for `use_gui`.
"""

from simkit.nodes.joint_state_publisher.gui import JointStatePublisherGui, SliderJoint
from simkit.nodes.joint_state_publisher.node import JointStatePublisher

__all__ = ["JointStatePublisher", "JointStatePublisherGui", "SliderJoint"]
