"""A controller manager that only notes what it is asked, and programs that ask."""

from __future__ import annotations

from typing import Any

import pytest

from simkit.graph import Executor, Graph
from simkit.msgs import message_class, service_class
from simkit.nodes import builtin_nodes

KINDS = {
    "list_controllers": "ListControllers",
    "list_controller_types": "ListControllerTypes",
    "load_controller": "LoadController",
    "unload_controller": "UnloadController",
    "switch_controller": "SwitchController",
    "reload_controller_libraries": "ReloadControllerLibraries",
}


class Manager:
    """Answers for controllers that are only names; the one called `bad` cannot be loaded."""

    def __init__(self, graph: Graph, namespace: str) -> None:
        self.node = graph.create_node("/robot" if namespace else "/gazebo")
        self.asked: list[str] = []
        self.states: dict[str, str] = {}
        for name, kind in KINDS.items():
            found: Any = service_class(f"controller_manager_msgs/{kind}")
            service = f"{namespace}/controller_manager/{name}"
            self.node.advertise_service(service, found, self._handler(name, found))

    def _handler(self, name: str, kind: Any) -> Any:
        def answer(request: Any) -> Any:
            response = kind._response_class()
            if not name.startswith("list"):
                response.ok = True
            getattr(self, name)(request, response)
            return response

        return answer

    def list_controllers(self, _request: Any, response: Any) -> None:
        claim: Any = message_class("controller_manager_msgs/HardwareInterfaceResources")()
        claim.hardware_interface = "hardware_interface::PositionJointInterface"
        state: Any = message_class("controller_manager_msgs/ControllerState")
        response.controller = [
            state(name=name, state=what, claimed_resources=[claim])
            for name, what in self.states.items()
        ]

    def list_controller_types(self, _request: Any, response: Any) -> None:
        response.types = ["a/A", "b/B"]

    def load_controller(self, request: Any, response: Any) -> None:
        self.asked.append(f"load {request.name}")
        response.ok = request.name != "bad"
        if response.ok:
            self.states[request.name] = "initialized"

    def unload_controller(self, request: Any, response: Any) -> None:
        self.asked.append(f"unload {request.name}")
        response.ok = self.states.pop(request.name, None) is not None

    def switch_controller(self, request: Any, response: Any) -> None:
        start, stop = list(request.start_controllers), list(request.stop_controllers)
        self.asked.append(f"switch {start} {stop} {request.strictness}")
        response.ok = all(name in self.states for name in (*start, *stop))
        if response.ok:
            self.states.update(dict.fromkeys(start, "running"))
            self.states.update(dict.fromkeys(stop, "stopped"))

    def reload_controller_libraries(self, _request: Any, response: Any) -> None:
        self.asked.append("reload")
        self.states.clear()
        response.ok = True


class Desk:
    """A graph in which programs of controller_manager run."""

    def __init__(self) -> None:
        self.executor = Executor(0)
        self.graph = Graph(self.executor)

    def manager(self, namespace: str = "") -> Manager:
        return Manager(self.graph, namespace)

    def start(self, executable: str, *argv: str, name: str = "/program") -> Any:
        builtin = builtin_nodes()[("controller_manager", executable)]
        return builtin(self.graph.create_node(name), list(argv))

    def run(self, seconds: float) -> None:
        self.executor.run_to(self.executor.now_ns + round(seconds * 1e9))

    def said(self, node: str = "/program") -> list[str]:
        return [f"{one.level.name} {one.text}" for one in self.graph.records if one.node == node]

    def publish(self, topic: str, type_name: str, **fields: Any) -> None:
        kind = message_class(type_name)
        publisher = self.graph.create_node("/other").advertise(topic, kind, latch=True)
        publisher.publish(kind(**fields))

    def shut_down(self, name: str = "/program") -> None:
        self.graph.nodes[name].shutdown()
        self.run(0.0)


@pytest.fixture
def desk() -> Any:
    return Desk()
