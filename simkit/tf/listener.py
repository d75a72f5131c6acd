"""From the topics /tf and /tf_static into a buffer, inside and outside node processes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simkit.msgs import message_class
from simkit.tf.admission import BroadcasterWatch, rotation_advice
from simkit.tf.buffer import Buffer

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


class TransformFeed:
    """Stores the transforms of tf2_msgs/TFMessage messages, and warns of what is wrong with them.

    A fault that comes with every message is logged the 1st, 10th, 100th, ... time only.

    Args:
        buffer: Where the transforms go. Its warnings go to `warn` from now on.
        now_ns: Current time [ns]; the buffer is cleared when it jumps back.
        warn: Is given each sentence.

    Source:
        tf2_ros `TransformListener`; it logs a fault every time.
    """

    def __init__(
        self, buffer: Buffer, *, now_ns: Callable[[], int], warn: Callable[[str], None]
    ) -> None:
        self._buffer = buffer
        self._now_ns = now_ns
        self._warn = warn
        self._last_update_ns: int | None = None
        self._watch = BroadcasterWatch()
        self._faults: list[str] = []
        self._counts: dict[tuple[str, ...], int] = {}
        buffer.on_warning = warn

    def on_transforms(self, message: Any) -> None:
        """Take a message of /tf."""
        self._take(message, static=False)

    def on_static_transforms(self, message: Any) -> None:
        """Take a message of /tf_static."""
        self._take(message, static=True)

    def _take(self, message: Any, *, static: bool) -> None:
        self._clear_on_jump_back()
        header = getattr(message, "_connection_header", None) or {}
        authority = str(header.get("callerid", "default_authority"))
        store = self._buffer.set_transform_static if static else self._buffer.set_transform
        self._buffer.on_warning = self._faults.append
        for transform in message.transforms:
            if store(transform, authority):
                self._notice_rivals(transform, authority)
            else:
                self._log_faults(transform, authority)
        self._buffer.on_warning = self._warn

    def _clear_on_jump_back(self) -> None:
        now_ns, last_ns = self._now_ns(), self._last_update_ns
        if last_ns is not None and now_ns < last_ns:
            jump_s = (last_ns - now_ns) / 1e9
            self._warn(f"Detected jump back in time of {jump_s:f}s. Clearing TF buffer.")
            self._buffer.clear()
        self._last_update_ns = now_ns

    def _notice_rivals(self, transform: Any, authority: str) -> None:
        sentence = self._watch.note(
            transform.child_frame_id, transform.header.frame_id, authority=authority
        )
        if sentence:
            self._warn(sentence)

    def _log_faults(self, transform: Any, authority: str) -> None:
        faults = list(self._faults)
        self._faults.clear()
        kinds = (fault.split(maxsplit=1)[0] for fault in faults)
        key = (authority, transform.child_frame_id, *kinds)
        count = self._counts[key] = self._counts.get(key, 0) + 1
        if count != 10 ** (len(str(count)) - 1):
            return
        times = f" ({count} times so far)" if count > 1 else ""
        for fault in faults:
            self._warn(fault + times)
        q = transform.transform.rotation
        advice = rotation_advice(transform.child_frame_id, (q.x, q.y, q.z, q.w))
        if advice:
            self._warn(advice)
