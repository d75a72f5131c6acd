"""Recordings: messages of topics, with the virtual time of each message."""

from __future__ import annotations

from collections.abc import Mapping

from simkit.errors import UnknownNameError
from simkit.graph import Node
from simkit.graph.topics import Sink
from simkit.msgs import Message, Time


class Recording:
    """Listens to topics from its creation on.

    Args:
        node: The node that listens.
        topics: Resolved topic name to message class.
    """

    def __init__(self, node: Node, topics: Mapping[str, type[Message]]) -> None:
        self._executor = node.graph.executor
        self._classes = dict(topics)
        self._messages: dict[str, list[tuple[int, bytes]]] = {name: [] for name in topics}
        self._subscriptions = [
            node.graph.add_subscription(name, cls, node.name, self._sink(name))
            for name, cls in topics.items()
        ]

    def __getitem__(self, topic: str) -> list[tuple[Time, Message]]:
        """Messages of a topic with their times, oldest first."""
        messages = self.raw(topic)
        cls = self._classes[topic]
        return [(Time.from_nsec(time_ns), cls.from_bytes(data)) for time_ns, data in messages]

    def raw(self, topic: str) -> list[tuple[int, bytes]]:
        """Wire bytes of each message with its virtual time [ns], oldest first.

        Raises:
            UnknownNameError: The topic is not recorded.
        """
        if topic not in self._messages:
            raise UnknownNameError("recorded topic", topic, self._messages)
        return list(self._messages[topic])

    def topics(self) -> list[str]:
        """The recorded topics, sorted."""
        return sorted(self._messages)

    def types(self) -> dict[str, str]:
        """Type of the messages of each topic, sorted by name."""
        return {name: self._classes[name]._type for name in self.topics()}

    def stop(self) -> None:
        """Listen no more; what was heard stays."""
        for subscription in self._subscriptions:
            subscription.unregister()

    def _sink(self, topic: str) -> Sink:
        kept, executor = self._messages[topic], self._executor
        return lambda data, _caller: kept.append((executor.now_ns, data))
