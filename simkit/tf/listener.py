"""A node's ears for TF: keeps a buffer up to date."""

from __future__ import annotations

from typing import TYPE_CHECKING

from simkit.msgs import message_class
from simkit.tf.buffer import Buffer
from simkit.tf.feed import TransformFeed

if TYPE_CHECKING:
    from simkit.graph import Node


class TransformListener:
    """Fills a buffer from /tf and /tf_static for as long as the node lives.

    Args:
        node: In-process node that subscribes; it also logs what is wrong with transforms.
        buffer: The buffer to fill; it is cleared when the clock jumps back.
    """

    def __init__(self, node: Node, buffer: Buffer) -> None:
        self.buffer = buffer
        executor = node.graph.executor
        feed = TransformFeed(buffer, now_ns=lambda: executor.now_ns, warn=node.warn)
        tf_message = message_class("tf2_msgs/TFMessage")
        self._subscriptions = (
            node.subscribe("/tf", tf_message, feed.on_transforms),
            node.subscribe("/tf_static", tf_message, feed.on_static_transforms),
        )

    def unregister(self) -> None:
        """Stop listening; what the buffer holds stays."""
        for subscription in self._subscriptions:
            subscription.unregister()
