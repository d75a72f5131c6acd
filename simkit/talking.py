"""How Python code takes part in the graph: publish, listen, record, call."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import yaml

from simkit import msgs
from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Graph, Node, ServiceFailed
from simkit.graph.executor import nanoseconds
from simkit.msgs import Duration, Message, Time
from simkit.recording import Recording


class Talking:
    """The part of `Simulation` that talks with nodes, in the name of its own node."""

    graph: Graph
    _node: Node

    @property
    def now(self) -> Time:
        """Virtual time."""
        raise NotImplementedError

    def run_until(self, predicate: Callable[[], bool], timeout: float) -> bool:
        """Let virtual time pass until `predicate()` holds, at most `timeout` [s]; whether it holds."""
        raise NotImplementedError

    def _require_open(self) -> None:
        raise NotImplementedError

    def topics(self) -> dict[str, str]:
        """Type of each topic in use, by name."""
        return self.graph.topic_types()

    def rostopic_pub(
        self,
        topic: str,
        type_name: str,
        value: str | Mapping[str, Any] | Sequence[Any] | Message = "{}",
        *,
        rate: float | None = None,
    ) -> Node:
        """Publish as `rostopic pub` does.

        Args:
            topic: Topic name.
            type_name: E.g. `geometry_msgs/Twist`.
            value: YAML text, the same as Python values, or a message.
            rate: Repeat so often [Hz]; once and latched if None.

        Returns:
            The node that publishes; `shutdown()` ends it.
        """
        self._require_open()
        if rate is not None and not rate > 0:
            raise SimkitError(f"a rate of {rate} Hz is none: give a number above 0")
        message = self._message(type_name, value)
        node = self.graph.create_node(self._free_name("/rostopic"))
        publisher = node.advertise(topic, type(message), latch=rate is None)
        publisher.publish(message)
        if rate is not None:
            node.create_timer(
                Duration.from_nsec(nanoseconds(1.0 / rate)), lambda: publisher.publish(message)
            )
        return node

    def latest(self, topic: str) -> Any:
        """The last message of a topic, or None if there was none yet.

        Raises:
            UnknownNameError: No node uses the topic.
        """
        entry = self.graph.topics.get(self._node.resolve(topic))
        if entry is None:
            raise UnknownNameError("topic", self._node.resolve(topic), self.topics())
        return None if entry.last is None else entry.message_class.from_bytes(entry.last)

    def wait_for_message(self, topic: str, timeout: float = 10.0) -> Any:
        """Let virtual time pass until the next message of a topic, and return it.

        Raises:
            UnknownNameError: No node uses the topic.
            SimkitError: None came within `timeout` [s].
        """
        with_messages = self.record([topic])
        name = with_messages.topics()[0]
        try:
            if self.run_until(lambda: bool(with_messages.raw(name)), timeout):
                return with_messages[name][0][1]
        finally:
            with_messages.stop()
        raise SimkitError(f"no message on {name} within {timeout:g} s")

    def record(self, topics: Iterable[str] | Mapping[str, str]) -> Recording:
        """Record topics from now on.

        Args:
            topics: Names of topics in use, or names with types for topics that are still to come.

        Raises:
            UnknownNameError: A topic is not in use and no type is given.
        """
        return Recording(self._node, self._message_classes(topics))

    def _message_classes(
        self, topics: Iterable[str] | Mapping[str, str]
    ) -> dict[str, type[Message]]:
        """Resolved names of topics with the classes of their messages.

        Raises:
            UnknownNameError: A topic is not in use and no type is given.
        """
        if isinstance(topics, str):
            topics = [topics]
        given = dict(topics) if isinstance(topics, Mapping) else dict.fromkeys(topics)
        classes: dict[str, type[Message]] = {}
        for name, type_name in given.items():
            resolved = self._node.resolve(name)
            entry = self.graph.topics.get(resolved)
            if type_name is not None:
                classes[resolved] = msgs.message_class(type_name)
            elif entry is not None:
                classes[resolved] = entry.message_class
            else:
                raise UnknownNameError("topic", resolved, self.topics())
        return classes

    # -- services

    def services(self) -> dict[str, str]:
        """Type of each service on offer, by name."""
        return {
            name: server.service_class._type for name, server in sorted(self.graph.services.items())
        }

    def call(self, service: str, *arguments: Any, timeout: float = 10.0, **fields: Any) -> Any:
        """Call a service and let virtual time pass until it answers.

        Args:
            service: Service name.
            *arguments: All fields of the request in order,
            timeout: Virtual time to wait for the answer [s].
            **fields: or some of them by name.

        Raises:
            UnknownNameError: Nobody offers the service.
            ServiceFailed: The server refused, or did not answer in time.
        """
        self._require_open()
        name = self._node.resolve(service)
        if name not in self.graph.services:
            raise UnknownNameError("service", name, self.graph.services)
        service_class = self.graph.services[name].service_class
        request = service_class._request_class(*arguments, **fields)
        answers: list[tuple[bool, bytes]] = []
        self.graph.call_service(
            name, request.to_bytes(), self._node.name, lambda ok, data: answers.append((ok, data))
        )
        if not self.run_until(lambda: bool(answers), timeout):
            raise ServiceFailed(f"service {name} did not answer within {timeout:g} s")
        success, data = answers[0]
        if not success:
            raise ServiceFailed(f"service {name}: {data.decode(errors='replace')}")
        return service_class._response_class.from_bytes(data)

    def _free_name(self, base: str) -> str:
        number = 1
        while f"{base}_{number}" in self.graph.nodes:
            number += 1
        return f"{base}_{number}"

    def _message(self, type_name: str, value: Any) -> Message:
        if isinstance(value, Message):
            if value._type != type_name:
                raise SimkitError(f"the message is a {value._type}, not a {type_name}")
            return value
        try:
            parsed = yaml.safe_load(value) if isinstance(value, str) else value
        except yaml.YAMLError as error:
            raise SimkitError(f"{value!r} is not YAML: {error}") from error
        return msgs.fill_message(msgs.message_class(type_name), parsed, now=self.now)
