from __future__ import annotations

from typing import Any

import pytest

from simkit.graph import Executor, Graph, ServiceFailed
from simkit.msgs import message_class, service_class
from simkit.nodes import builtin_nodes

START_NS = 1_600_088_400_000_000_000


class Bench:
    """A graph with a tester's node in it."""

    def __init__(self) -> None:
        self.executor = Executor(START_NS)
        self.graph = Graph(self.executor)
        self.tester = self.graph.create_node("/tester")

    def start(self, executable: str, name: str = "", **remappings: str) -> Any:
        builtin = builtin_nodes()[("turtlesim", executable)]
        node = self.graph.create_node(name or f"/{builtin.node_name}", remappings)
        return builtin(node, [])

    def run(self, seconds: float) -> None:
        self.executor.run_to(self.executor.now_ns + round(seconds * 1e9))

    def call(self, service: str, type_name: str, **fields: object) -> Any:
        """The response of a service call; raises ServiceFailed with the server's text."""
        service_type: Any = service_class(type_name)
        answers: list[tuple[bool, bytes]] = []
        self.graph.call_service(
            service,
            service_type._request_class(**fields).to_bytes(),
            "/tester",
            lambda success, data: answers.append((success, data)),
        )
        self.run(0.0)
        ((success, data),) = answers
        if not success:
            raise ServiceFailed(data.decode())
        return service_type._response_class.from_bytes(data)

    def hear(self, topic: str, type_name: str) -> list[Any]:
        """A list that grows with each message of a topic."""
        heard: list[Any] = []
        self.tester.subscribe(topic, message_class(type_name), heard.append)
        return heard

    def command(self, topic: str, linear: float = 0.0, angular: float = 0.0) -> None:
        twist: Any = message_class("geometry_msgs/Twist")()
        twist.linear.x, twist.angular.z = linear, angular
        self.tester.advertise(topic, type(twist)).publish(twist)

    def said(self, level: str) -> list[str]:
        return [record.text for record in self.graph.records if record.level.name == level]


@pytest.fixture
def bench() -> Bench:
    return Bench()
