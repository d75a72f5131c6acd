"""Fills a buffer from the topics /tf and /tf_static."""

from __future__ import annotations

from typing import TYPE_CHECKING

from simkit.msgs import message_class
from simkit.tf.listener import TransformFeed

if TYPE_CHECKING:
    from simkit.ros1.rospy.storing import StoringSubscriber, now_ns
    from simkit.ros1.tf2_py import BufferCore
else:
    from rospy.storing import StoringSubscriber, now_ns


class TransformListener:
    """Hears all transforms from now on; right after its creation it knows none.

    It listens until `unregister`, also when nobody holds the object.

    Args:
        buffer: The buffer to fill; it is cleared when the clock jumps back.
        queue_size: At most so many messages wait.
        buff_size: Taken for tf2_ros' sake.
        tcp_nodelay: Taken for tf2_ros' sake.
    """

    def __init__(
        self,
        buffer: BufferCore,
        queue_size: int | None = None,
        buff_size: int = 65536,
        tcp_nodelay: bool = False,
    ) -> None:
        self.buffer = buffer
        feed = TransformFeed(buffer._buffer, now_ns=now_ns, warn=buffer._warn)
        tf_message = message_class("tf2_msgs/TFMessage")
        self.tf_sub = StoringSubscriber(
            "/tf", tf_message, feed.on_transforms, queue_size=queue_size
        )
        self.tf_static_sub = StoringSubscriber(
            "/tf_static", tf_message, feed.on_static_transforms, queue_size=queue_size
        )

    def unregister(self) -> None:
        """Stop listening; what the buffer holds stays."""
        self.tf_sub.unregister()
        self.tf_static_sub.unregister()
