"""Sends the transforms of moving frames to the topic /tf."""

# ruff: noqa: N802 - the names are tf2_ros'

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from simkit.msgs import Message, message_class

if TYPE_CHECKING:
    from simkit.ros1 import rospy
else:
    import rospy

QUEUE_SIZE = 100


class TransformBroadcaster:
    """Broadcasts where frames are.

    What is sent is what was given: an invalid transform is refused by each listener,
    with a warning that names this node.
    """

    def __init__(self) -> None:
        self.pub_tf = rospy.Publisher(
            "/tf", message_class("tf2_msgs/TFMessage"), queue_size=QUEUE_SIZE
        )

    def sendTransform(self, transform: Any) -> None:
        """Send one geometry_msgs/TransformStamped, or a list of them.

        Raises:
            TypeError: It is something else.
            ROSSerializationException: A field holds a value of the wrong type.
        """
        self.pub_tf.publish(as_tf_message(transform))


def as_tf_message(transform: Any) -> Any:
    """The tf2_msgs/TFMessage that carries one geometry_msgs/TransformStamped, or several.

    Raises:
        TypeError: It is something else.
    """
    transforms = [transform] if isinstance(transform, Message) else transform
    stamped = message_class("geometry_msgs/TransformStamped")
    if not isinstance(transforms, list | tuple) or not all(
        isinstance(one, stamped) for one in transforms
    ):
        raise TypeError(
            "sendTransform of tf2_ros takes a geometry_msgs.msg.TransformStamped, or a list of "
            f"them, not {type(transform).__name__}; the five arguments "
            "(translation, rotation, time, child, parent) belong to tf.TransformBroadcaster"
        )
    return message_class("tf2_msgs/TFMessage")(list(transforms))
