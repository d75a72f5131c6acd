"""`rostopic hz`: how often a topic speaks.

Source:
    rostopic's `ROSTopicHz`: mean, extremes and deviation of the gaps between messages.
"""

from __future__ import annotations

import math
from collections import deque

from simkit.commands.command import Write
from simkit.commands.topic_search import Found, TopicWatcher
from simkit.graph import Node
from simkit.msgs import Duration

LONGEST_WINDOW = 50_000
"""So many messages count when no window is given."""
REPORT_EVERY = Duration(1)
"""How often the rate is printed."""


class TopicHz(TopicWatcher):
    """Prints the rate of a topic once a second.

    Args:
        node: The node that listens.
        words: The topic.
        write: Takes what is printed.
        window: So many of the latest messages count.
    """

    def __init__(
        self, node: Node, words: str, write: Write, *, window: int = LONGEST_WINDOW
    ) -> None:
        self._gaps: deque[float] = deque(maxlen=max(1, window - 1))
        self._last: int | None = None
        self._last_reported: int | None = None
        super().__init__(node, words, write)

    def _listen(self, found: Found) -> None:
        graph = self.node.graph
        self.node.subscriptions.append(
            graph.add_subscription(
                found.topic, found.message_class, self.node.name, lambda _data, _by: self._note()
            )
        )
        self._write(f"subscribed to [{found.topic}]\n")
        self.node.create_timer(REPORT_EVERY, self._report)

    def _note(self) -> None:
        now = self.node.now().to_nsec()
        if self._last is not None:
            self._gaps.append((now - self._last) / 1e9)
        self._last = now

    def _report(self) -> None:
        if not self._gaps or self._last == self._last_reported:
            self._write("no new messages\n")
            return
        self._last_reported = self._last
        self._write(rate_text(list(self._gaps)))


def rate_text(gaps: list[float]) -> str:
    """What `rostopic hz` prints of the gaps between messages [s]."""
    mean = sum(gaps) / len(gaps)
    deviation = math.sqrt(sum((gap - mean) ** 2 for gap in gaps) / len(gaps))
    rate = 1.0 / mean if mean > 0.0 else 0.0
    return (
        f"average rate: {rate:.3f}\n"
        f"\tmin: {min(gaps):.3f}s max: {max(gaps):.3f}s "
        f"std dev: {deviation:.5f}s window: {len(gaps) + 1}\n"
    )
