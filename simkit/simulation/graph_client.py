"""How Python code takes part in the graph: publish, listen, call."""

from __future__ import annotations

import weakref
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from simkit import msgs
from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Node, ServiceFailed
from simkit.msgs import Message

if TYPE_CHECKING:
    from simkit.simulation.simulation import Simulation


class GraphClient:
    """The part of a `Simulation` that takes part in its graph, in the name of its own node.

    Args:
        sim: The simulation.
    """

    def __init__(self, sim: Simulation) -> None:
        self._sim: Simulation = weakref.proxy(sim)

    def topics(self) -> dict[str, str]:
        """Type of each topic in use, by name."""
        return self._sim.graph.topic_types()

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

        Raises:
            SimkitError: What `rostopic pub` says: no such type, or a value does not fit.
        """
        from simkit.commands.topic_pub import publish, value_of

        self._sim.require_open()
        read = value_of(value) if isinstance(value, str) else value
        values = read if isinstance(read, list | tuple) else [read]
        return publish(self._sim.graph, topic, type_name, values, rate=rate)

    def latest(self, topic: str) -> Any:
        """The last message of a topic, or None if there was none yet.

        Sensors and the world publish only while somebody listens: on a topic that nobody has listened to, the simulation
        does so from now on.

        Raises:
            UnknownNameError: No node uses the topic.
        """
        entry = self._sim.graph.topics.get(self._sim.node.resolve(topic))
        if entry is None:
            raise UnknownNameError("topic", self._sim.node.resolve(topic), self.topics())
        if entry.last is not None:
            return entry.message_class.from_bytes(entry.last)
        if entry.publishers and not entry.subscriptions:
            self._sim.node.subscribe(entry.name, entry.message_class, lambda _message: None)
            self._sim.node.info(
                f"nobody has listened to {entry.name} so far; sim.latest() does from now on: let time pass, then ask again"
            )
        return None

    def wait_for_message(self, topic: str, timeout: float = 10.0) -> Any:
        """Let virtual time pass until the next message of a topic, and return it.

        Raises:
            UnknownNameError: No node uses the topic.
            SimkitError: None came within `timeout` [s].
        """
        with_messages = self._sim.record([topic])
        name = with_messages.topics()[0]
        try:
            if self._sim.run_until(lambda: bool(with_messages.raw(name)), timeout):
                return with_messages[name][0][1]
        finally:
            with_messages.stop()
        raise SimkitError(f"no message on {name} within {timeout:g} s")

    def message_classes(
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
            resolved = self._sim.node.resolve(name)
            entry = self._sim.graph.topics.get(resolved)
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
            name: server.service_class._type
            for name, server in sorted(self._sim.graph.services.items())
        }

    def call(self, /, service: str, *arguments: Any, timeout: float = 10.0, **fields: Any) -> Any:
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
        self._sim.require_open()
        name = self._sim.node.resolve(service)
        if name not in self._sim.graph.services:
            raise UnknownNameError("service", name, self._sim.graph.services)
        service_class = self._sim.graph.services[name].service_class
        request = service_class._request_class(*arguments, **fields)
        answers: list[tuple[bool, bytes]] = []
        self._sim.graph.call_service(
            name,
            request.to_bytes(),
            self._sim.node.name,
            lambda ok, data: answers.append((ok, data)),
        )
        if not self._sim.run_until(lambda: bool(answers), timeout):
            raise ServiceFailed(f"service {name} did not answer within {timeout:g} s")
        success, data = answers[0]
        if not success:
            raise ServiceFailed(f"service {name}: {data.decode(errors='replace')}")
        return service_class._response_class.from_bytes(data)
