"""`Simulation`: one clock, one graph, one TF buffer, and what runs on them."""

from __future__ import annotations

import math
import weakref
import zlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import yaml

from simkit import msgs
from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Executor, Graph, LogRecord, Node, ServiceFailed
from simkit.graph.errors import GraphError
from simkit.graph.names import split_command_line
from simkit.graph.params import ParameterServer
from simkit.graph.process import (
    NodeRuntime,
    Permissions,
    ScriptNode,
    StartSpec,
    shared_runtime,
)
from simkit.graph.screen import Screen, StreamScreen
from simkit.msgs import Duration, Message, Time
from simkit.nodes import builtin_nodes
from simkit.packages import PackagePath
from simkit.recording import Recording
from simkit.running import RunningBuiltin
from simkit.seeing import Seeing
from simkit.tf import Buffer, TransformListener

if TYPE_CHECKING:
    from types import TracebackType

EPOCH_NS = 1_600_088_400 * 10**9
"""Virtual time at the start [ns]: 14 September 2020, 13:00 UTC, the hour of the lecture."""
_DEFAULT_SCREEN = StreamScreen()
MessageT = TypeVar("MessageT", bound=Message)


class Simulation(Seeing):
    """A world of nodes on virtual time. Same seed, same bytes.

    Args:
        seed: Seeds everything random; every node gets a seed of its own from it.
        package_path: Folders in which ROS packages are found; the working folder if None.
        runtime: Where scripts run as processes; one that all simulations of this process share if None.
        screen: Where what nodes say is shown; standard output by default, None for silence.
    """

    def __init__(
        self,
        seed: int = 0,
        *,
        package_path: Sequence[str | Path] | None = None,
        runtime: NodeRuntime | None = None,
        screen: Screen | None = _DEFAULT_SCREEN,
    ) -> None:
        self.seed = seed
        self.packages = PackagePath(package_path)
        self.graph = Graph(Executor(EPOCH_NS), screen)
        self._runtime = runtime
        self._scripts: list[ScriptNode] = []
        self._builtins: list[RunningBuiltin] = []
        self._views: list[Callable[[], None]] = []
        self._node = self.graph.create_node("/simkit")
        self.graph.reserved_names.add(self._node.name)
        self.tf = Buffer()
        self._tf_listener = TransformListener(self._node, self.tf)
        self._closed = False
        _close_abandoned()
        weakref.finalize(self, _abandoned.append, self._scripts)
        _made.append(weakref.ref(self, _made.remove))

    def __enter__(self) -> Simulation:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """End every node; no process is left behind. Harmless when closed already."""
        self._closed = True
        for script in self._scripts:
            script.close()

    @property
    def closed(self) -> bool:
        """Whether it has been closed."""
        return self._closed

    # -- time

    @property
    def now(self) -> Time:
        """Virtual time."""
        return self.graph.now()

    def run(self, seconds: float) -> None:
        """Let virtual time pass [s], as fast as the machine can.

        Raises:
            SimkitError: The simulation is closed.
        """
        self._require_open()
        executor = self.graph.executor
        executor.run_to(executor.now_ns + _nanoseconds(seconds))
        self._refresh_views()

    def run_until(self, predicate: Callable[[], bool], timeout: float) -> bool:
        """Let virtual time pass until `predicate()` holds, at most `timeout` [s]; whether it holds."""
        self._require_open()
        executor = self.graph.executor
        holds = executor.run_to(executor.now_ns + _nanoseconds(timeout), predicate)
        self._refresh_views()
        return holds

    def step(self) -> bool:
        """Run the next event; False if nothing is left to happen."""
        self._require_open()
        stepped = self.graph.executor.step()
        self._refresh_views()
        return stepped

    # -- nodes

    def rosrun(
        self,
        package: str,
        executable: str,
        *arguments: str,
        permissions: Permissions | None = None,
    ) -> ScriptNode | RunningBuiltin:
        """Start a node: a built-in one (`turtlesim turtlesim_node`) or a script of a package.

        Args:
            package: Package name.
            executable: File name of the script, or name of the built-in node.
            *arguments: As on the command line of `rosrun`: `_turtle:=turtle2`, `__name:=x`, `a:=b`, the script's own.
            permissions: What the script may write; anything if None.

        Returns:
            A handle with `name`, `alive`, `exit_code`, `output`, `failure`.

        Raises:
            UnknownNameError: No such package, or no such executable in it; names near ones.
        """
        self._require_open()
        command_line = split_command_line(arguments)
        if (package, executable) in builtin_nodes():
            definition = builtin_nodes()[package, executable]
            named = definition.named(command_line, self.graph.nodes)
            builtin = RunningBuiltin(self.graph, definition, named)
            self._builtins.append(builtin)
            return builtin
        script = self._find_script(package, executable)
        spec = StartSpec(
            script=str(script.path),
            shown_path=script.shown,
            arguments=command_line.arguments,
            seed=zlib.crc32(f"{self.seed}/{package}/{executable}/{' '.join(arguments)}".encode()),
        )
        node = ScriptNode(
            self.graph,
            self._runtime or shared_runtime(),
            spec,
            command_line,
            permissions or Permissions(),
        )
        self._scripts.append(node)
        return node

    def nodes(self) -> list[str]:
        """Names of the nodes that are up, sorted."""
        return sorted(self.graph.nodes)

    @property
    def log(self) -> list[LogRecord]:
        """Everything said on rosout so far."""
        return self.graph.records

    @property
    def params(self) -> ParameterServer:
        """The parameter server."""
        return self.graph.params

    # -- topics

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
                Duration.from_nsec(_nanoseconds(1.0 / rate)), lambda: publisher.publish(message)
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
        return Recording(self._node, classes)

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

    # -- private

    def _require_open(self) -> None:
        if self._closed:
            raise GraphError("this simulation is closed; make a new one: sim = Simulation()")

    def _find_script(self, package: str, executable: str) -> _Script:
        builtin_packages = {name for name, _ in builtin_nodes()}
        try:
            found = self.packages.find(package)
        except UnknownNameError as error:
            known = sorted({*error.known, *builtin_packages})
            if package in builtin_packages:
                programs = [program for name, program in builtin_nodes() if name == package]
                raise UnknownNameError(f"program in {package!r}", executable, programs) from None
            raise UnknownNameError("package", package, known) from None
        path = found.find_executable(executable)
        return _Script(path, path.relative_to(found.folder.parent).as_posix())

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


_made: list[weakref.ref[Simulation]] = []


def newest_simulation() -> Simulation | None:
    """The open simulation of this process that was made last: what a line of a notebook acts on."""
    for made in reversed(_made):
        sim = made()
        if sim is not None and not sim.closed:
            return sim
    return None


_abandoned: list[list[ScriptNode]] = []


def _close_abandoned() -> None:
    # A notebook's `sim = Simulation()` drops the one before it: its processes end when the next one begins, and not in the
    # middle of whatever runs when the garbage is collected.
    while _abandoned:
        for script in _abandoned.pop():
            script.close()


def _nanoseconds(seconds: float) -> int:
    if not math.isfinite(seconds) or seconds < 0:
        raise SimkitError(f"a time of {seconds} s cannot pass: give a number of seconds, 0 or more")
    return round(seconds * 1e9)


class _Script:
    """A script file and how to show its path."""

    def __init__(self, path: Path, shown: str) -> None:
        self.path = path
        self.shown = shown
