"""The services of a controller manager, as its programs call them, and why there are none.

A program is a routine that waits for things, written as if it had time of its own:

def routine(self):
    yield 0.1                                     # virtual time passes
    answer = yield Call("/spawn", "turtlesim/Spawn", {"x": 1.0})
"""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from simkit.graph import Graph, Node, ServiceFailed
from simkit.msgs import service_class

STRICT, BEST_EFFORT = 2, 1
"""Strictness of a switch: all of it or nothing; what can be done."""
POLL_SECONDS = 0.1
"""How often a program looks whether a service is there [s]."""
PATIENCE_SECONDS = 5.0
"""After so long a wait it logs what could be wrong [s]."""
_MANAGER = "controller_manager"
_PLUGIN = "libgazebo_ros_control.so"


class ManagerClient:
    """A controller manager, seen from a program.

    Args:
        node: The program's node.
        namespace: Where the manager is, relative to the node's own; empty for there.
    """

    def __init__(self, node: Node, namespace: str = "") -> None:
        self._node = node
        self._space = f"{namespace.rstrip('/')}/" if namespace else ""
        self._has_hinted = False

    def shown(self, service: str) -> str:
        """Name of a service as it is shown: `controller_manager/load_controller`."""
        return f"{self._space}{_MANAGER}/{service}"

    def wait_for(self, service: str, timeout_s: float | None) -> Generator[float, Any, bool]:
        """Wait for a service; whether it came in time.

        Args:
            service: E.g. `load_controller`.
            timeout_s: How long [s]; None: as long as it takes.
        """
        graph, name = self._node.graph, self._node.resolve(self.shown(service))
        begin_ns = graph.executor.now_ns
        while name not in graph.services:
            waited_s = (graph.executor.now_ns - begin_ns) / 1e9
            if waited_s >= PATIENCE_SECONDS or (timeout_s is not None and waited_s >= timeout_s):
                self._hint(name)
            if timeout_s is not None and waited_s >= timeout_s:
                return False
            yield POLL_SECONDS
        return True

    def call(self, service: str, kind: str, **fields: Any) -> ServiceCall:
        """A call of a service."""
        return ServiceCall(
            service=self._node.resolve(self.shown(service)),
            type_name=f"controller_manager_msgs/{kind}",
            fields=fields,
        )

    def load(self, name: str) -> ServiceCall:
        """Load a controller."""
        return self.call("load_controller", "LoadController", name=name)

    def unload(self, name: str) -> ServiceCall:
        """Unload a controller."""
        return self.call("unload_controller", "UnloadController", name=name)

    def switch(
        self, start: Sequence[str] = (), stop: Sequence[str] = (), *, strictness: int = STRICT
    ) -> ServiceCall:
        """Start and stop controllers."""
        return self.call(
            "switch_controller",
            "SwitchController",
            start_controllers=list(start),
            stop_controllers=list(stop),
            strictness=strictness,
        )

    def list(self) -> ServiceCall:
        """List controllers."""
        return self.call("list_controllers", "ListControllers")

    def _hint(self, name: str) -> None:
        if not self._has_hinted:
            self._has_hinted = True
            self._node.warn(f"hint: {why_no_manager(self._node.graph, name)}")


def why_no_manager(graph: Graph, name: str) -> str:
    """What to look at when a service of a controller manager is not there.

    Args:
        graph: The graph.
        name: Resolved name of the service.
    """
    service = name.rpartition("/")[2]
    end = f"/{_MANAGER}/{service}"
    others = [one for one in sorted(graph.services) if one.endswith(end)]
    if others:
        space = others[0].removesuffix(end) or "/"
        return (
            f"there is no {name}, but a {others[0]}: the controller manager is in the namespace {space}; "
            f"add --namespace {space}, or ns={space.strip('/')!r} to the <node>"
        )
    if not any(one.endswith("/gazebo/spawn_urdf_model") for one in graph.services):
        return (
            f"nobody offers {name}, and no simulation runs: the launch file must include "
            "$(find gazebo_ros)/launch/empty_world.launch"
        )
    description = graph.params.get("/robot_description", None)
    if isinstance(description, str) and _PLUGIN not in description:
        return (
            f"nobody offers {name}: the URDF in the parameter robot_description has no "
            f'<gazebo><plugin name="control" filename="{_PLUGIN}"/></gazebo>, where the controller '
            "manager lives"
        )
    if description is None:
        return (
            f"nobody offers {name}, and no parameter robot_description is set: the plugin "
            f"{_PLUGIN} waits for it"
        )
    return (
        f"nobody offers {name}: the robot must be in the simulation first, by spawn_model; with a "
        "<robotNamespace> in its plugin the spawner needs --namespace"
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ServiceCall:
    """A call of a service."""

    service: str
    """Its resolved name."""
    type_name: str
    """Its type."""
    fields: Mapping[str, Any] = field(default_factory=dict)
    """Of the request."""


Routine: TypeAlias = Generator[float | ServiceCall, Any, None]
"""Yields a time to wait [s], or a call; a call gives its response, or raises `ServiceFailed`."""


def start_routine(node: Node, routine: Routine, *, after_shutdown: bool = False) -> None:
    """Begin a routine; it goes on while its node lives.

    Args:
        node: Whose routine it is.
        routine: What is to be done.
        after_shutdown: Whether it goes on when the node has left, without waiting.
    """

    def go_on(value: Any = None, error: ServiceFailed | None = None) -> None:
        if not (node.alive or after_shutdown):
            routine.close()
            return
        try:
            wish = routine.send(value) if error is None else routine.throw(error)
        except StopIteration:
            return
        if isinstance(wish, ServiceCall):
            _call(node, wish, go_on)
        else:
            executor = node.graph.executor
            executor.call_at(executor.now_ns + round(wish * 1e9), go_on)

    node.graph.executor.call_soon(go_on)


def _call(node: Node, call: ServiceCall, go_on: Any) -> None:
    kind: Any = service_class(call.type_name)

    def take(is_good: bool, data: bytes) -> None:
        if is_good:
            go_on(kind._response_class.from_bytes(data))
        else:
            go_on(
                error=ServiceFailed(f"service [{call.service}] responded with an error: {data!r}")
            )

    if call.service not in node.graph.services:
        go_on(error=ServiceFailed(f"service [{call.service}] unavailable"))
        return
    request = kind._request_class(**call.fields)
    node.graph.call_service(call.service, request.to_bytes(), node.name, take)
