"""A transformer that fills itself from the topics /tf and /tf_static."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from simkit.msgs import message_class
from simkit.tf.listener import TransformFeed

from .transformer_ros import TransformerROS

if TYPE_CHECKING:
    from simkit.ros1 import rospy
    from simkit.ros1.rospy.storing import StoringSubscriber, now_ns
else:
    import rospy
    from rospy.storing import StoringSubscriber, now_ns


class TransformListener(TransformerROS):
    """Hears all transforms from now on; right after its creation it knows none.

    Args:
        *args: As `Transformer`.
        **kwargs: As `Transformer`.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        feed = TransformFeed(self._buffer, now_ns=now_ns, warn=rospy.logwarn)
        tf_message = message_class("tf2_msgs/TFMessage")
        self._subscribers = (
            StoringSubscriber("/tf", tf_message, feed.on_transforms),
            StoringSubscriber("/tf_static", tf_message, feed.on_static_transforms),
        )
        self.setUsingDedicatedThread(True)
