"""Sends transforms that hold for ever to the latched topic /tf_static."""

# ruff: noqa: N802 - the names are tf2_ros'

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from simkit.msgs import message_class

from .transform_broadcaster import QUEUE_SIZE, as_tf_message

if TYPE_CHECKING:
    from simkit.ros1 import rospy
else:
    import rospy


class StaticTransformBroadcaster:
    """Broadcasts where fixed frames are, also to listeners that start later.

    Only the last message is kept for those: a second `sendTransform` of another
    frame hides the first from them. One list with all frames is right, and a warning says so.

    Source:
        tf2_ros in Python (Noetic) latches the last message; in C++ the messages add up.
    """

    _latched: frozenset[str] = frozenset()  # of this node, like rospy's latch

    def __init__(self) -> None:
        self.pub_tf = rospy.Publisher(
            "/tf_static", message_class("tf2_msgs/TFMessage"), queue_size=QUEUE_SIZE, latch=True
        )

    def sendTransform(self, transform: Any) -> None:
        """Send one geometry_msgs/TransformStamped, or a list of them, and latch it.

        Raises:
            TypeError: It is something else.
            ROSSerializationException: A field holds a value of the wrong type.
        """
        message = as_tf_message(transform)
        self.pub_tf.publish(message)
        frames = frozenset(one.child_frame_id for one in message.transforms)
        hidden = sorted(StaticTransformBroadcaster._latched - frames)
        StaticTransformBroadcaster._latched = frames
        if hidden:
            rospy.logwarn(
                f"/tf_static keeps the last message of this node only: a node that starts later "
                f"will not hear of {', '.join(hidden)}. Send all static transforms in one list: "
                "sendTransform([first, second])."
            )
