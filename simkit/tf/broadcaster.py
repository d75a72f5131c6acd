"""What a node broadcasts to TF: moving frames on /tf, fixed ones on /tf_static."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, TypeAlias

from simkit.msgs import Message, message_class

if TYPE_CHECKING:
    from simkit.graph import Node

Transforms: TypeAlias = Message | Iterable[Message]
"One geometry_msgs/TransformStamped, or several that travel in one message."

TF_MESSAGE = "tf2_msgs/TFMessage"


class TransformBroadcaster:
    """Sends the transforms of moving frames.

    Args:
        node: In-process node that publishes.
    """

    def __init__(self, node: Node) -> None:
        self._message_class = message_class(TF_MESSAGE)
        self._publisher = node.advertise("/tf", self._message_class, queue_size=100)

    def send_transform(self, transforms: Transforms) -> None:
        """Publish on /tf."""
        self._publisher.publish(self._message_class(_as_list(transforms)))


class StaticTransformBroadcaster:
    """Sends transforms that hold for ever; a node that subscribes later receives them all.

    Args:
        node: In-process node that publishes.

    Source:
        tf2_ros in C++: the latched message holds the last transform of every child frame so far.
    """

    def __init__(self, node: Node) -> None:
        self._message_class = message_class(TF_MESSAGE)
        self._publisher = node.advertise("/tf_static", self._message_class, latch=True)
        self._by_child: dict[str, Any] = {}

    def send_transform(self, transforms: Transforms) -> None:
        """Add to the latched message of /tf_static and publish it."""
        for transform in _as_list(transforms):
            self._by_child[transform.child_frame_id] = transform
        self._publisher.publish(self._message_class(list(self._by_child.values())))


def _as_list(transforms: Transforms) -> list[Any]:
    return [transforms] if isinstance(transforms, Message) else list(transforms)
