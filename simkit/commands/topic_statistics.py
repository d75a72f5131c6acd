"""`rostopic hz`, `bw` and `delay`: what is measured of the messages of a topic.

Source:
    rostopic's `ROSTopicHz`, `ROSTopicBandwidth` and `ROSTopicDelay`: what is measured, windows, and the printouts.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from simkit.commands.command import Write
from simkit.commands.errors import ToolError
from simkit.commands.parser import ArgumentParser
from simkit.commands.topic_programs import TopicWatcher
from simkit.commands.topic_search import Found
from simkit.graph import Node
from simkit.msgs import Duration

NO_TIME = -1
"""Stands for the time of the message before the first one."""
REPORT_EVERY = Duration(1)
"""How often what is measured is printed."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Gauge:
    """What `rostopic hz`, `bw` and `delay` measure, and how they print it."""

    window: int
    """So many messages count when no window is given."""
    sample: Callable[[bytes, int, int, Found], float | None]
    """A number of a message: of its bytes, the time now and the time of the message before [ns], and the topic."""
    text: Callable[[Sequence[float], float], str]
    """What is printed of the numbers, and of the time since the first of them [s]."""
    gaps: int = 0
    """So many messages more than numbers: between two messages there is one gap."""


class TopicStatistics(TopicWatcher):
    """Prints what it measures of a topic once a second.

    Args:
        node: The node that listens.
        words: The topic.
        write: Takes what is printed.
        on_done: Called when nothing more will be printed.
        gauge: What is measured.
        window: So many of the latest messages count.
    """

    def __init__(
        self,
        node: Node,
        words: str,
        write: Write,
        on_done: Callable[[], None] | None = None,
        *,
        gauge: Gauge,
        window: int,
    ) -> None:
        self._gauge = gauge
        self._numbers: deque[float] = deque(maxlen=max(1, window - gauge.gaps))
        self._times: deque[int] = deque(maxlen=window)
        self._is_new = False
        super().__init__(node, words, write, on_done)

    def _listen(self, found: Found) -> None:
        graph = self.node.graph
        self.node.subscriptions.append(
            graph.add_subscription(
                found.topic,
                found.message_class,
                self.node.name,
                lambda data, _by: self._note(data, found),
            )
        )
        self._write(f"subscribed to [{found.topic}]\n")
        self.node.create_timer(REPORT_EVERY, self._report)

    def _note(self, data: bytes, found: Found) -> None:
        now = self.node.now().to_nsec()
        last = self._times[-1] if self._times else NO_TIME
        self._times.append(now)
        try:
            number = self._gauge.sample(data, now, last, found)
        except ToolError as error:
            self._finish(error)
            return
        if number is not None:
            self._numbers.append(number)
            self._is_new = True

    def _report(self) -> None:
        if self.done:
            return
        if not self._is_new:
            self._write("no new messages\n")
            return
        self._is_new = False
        span = (self.node.now().to_nsec() - self._times[0]) / 1e9
        self._write(self._gauge.text(list(self._numbers), span))


def _gap(_data: bytes, now: int, last: int, _found: Found) -> float | None:
    return None if last == NO_TIME else (now - last) / 1e9


def _size(data: bytes, _now: int, _last: int, _found: Found) -> float:
    return float(len(data))


def _age(data: bytes, now: int, _last: int, found: Found) -> float:
    if not found.message_class._has_header:
        raise ToolError("msg does not have header")
    message: Any = found.message_class.from_bytes(data)
    return float((now - message.header.stamp.to_nsec()) / 1e9)


def rate_text(gaps: Sequence[float], _span: float = 0.0) -> str:
    """What `rostopic hz` prints of the gaps between messages [s]."""
    mean = sum(gaps) / len(gaps)
    rate = 1.0 / mean if mean > 0.0 else 0.0
    return f"average rate: {rate:.3f}\n{_spread(gaps, len(gaps) + 1)}"


def delay_text(ages: Sequence[float], _span: float = 0.0) -> str:
    """What `rostopic delay` prints of the ages of messages [s]."""
    return f"average delay: {sum(ages) / len(ages):.3f}\n{_spread(ages, len(ages))}"


def _spread(numbers: Sequence[float], window: int) -> str:
    mean = sum(numbers) / len(numbers)
    deviation = math.sqrt(sum((number - mean) ** 2 for number in numbers) / len(numbers))
    return (
        f"\tmin: {min(numbers):.3f}s max: {max(numbers):.3f}s "
        f"std dev: {deviation:.5f}s window: {window}\n"
    )


def bandwidth_text(sizes: Sequence[float], span: float) -> str:
    """What `rostopic bw` prints.

    Args:
        sizes: Of messages [bytes].
        span: Since the first of them [s].
    """
    rate = sum(sizes) / span if span > 0.0 else 0.0
    factor, unit = next(
        (factor, unit)
        for limit, factor, unit in ((1e3, 1.0, "B"), (1e6, 1e3, "KB"), (math.inf, 1e6, "MB"))
        if rate < limit
    )
    numbers = (rate, sum(sizes) / len(sizes), min(sizes), max(sizes))
    average, mean, least, most = (f"{number / factor:.2f}{unit}" for number in numbers)
    return f"average: {average}/s\n\tmean: {mean} min: {least} max: {most} window: {len(sizes)}\n"


GAUGES: Mapping[str, Gauge] = {
    "hz": Gauge(window=50_000, sample=_gap, text=rate_text, gaps=1),
    "bw": Gauge(window=100, sample=_size, text=bandwidth_text),
    "delay": Gauge(window=50_000, sample=_age, text=delay_text),
}
"""What is measured, by the command of `rostopic`."""


def start_statistics(
    node: Node,
    words: Sequence[str],
    write: Write,
    on_done: Callable[[], None] | None = None,
    *,
    command: str = "hz",
) -> TopicStatistics:
    """Begin `rostopic hz`, `bw` or `delay`, each `[-w WINDOW] /topic`.

    Args:
        node: The node that listens.
        words: The words after the command.
        write: Takes what is printed.
        on_done: Called when nothing more will be printed.
        command: Which one.

    Raises:
        UsageError: The words ask for nothing.
    """
    gauge = GAUGES[command]
    parser = ArgumentParser(f"rostopic {command}")
    parser.add_argument("-w", "--window", type=int, default=gauge.window)
    parser.add_argument("topic")
    found = parser.parse_args(words)
    if found.window < 2:
        parser.error("WINDOW must be at least 2 messages")
    return TopicStatistics(node, found.topic, write, on_done, gauge=gauge, window=found.window)
