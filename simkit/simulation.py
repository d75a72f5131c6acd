"""`Simulation`: one clock, one graph, one TF buffer, and what runs on them."""

from __future__ import annotations

import weakref
import zlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from simkit.errors import UnknownNameError
from simkit.graph import Executor, Graph, LogRecord
from simkit.graph.errors import GraphError
from simkit.graph.executor import nanoseconds
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
from simkit.launching import Launching
from simkit.msgs import Time
from simkit.nodes import builtin_nodes
from simkit.packages import PackagePath
from simkit.plotting import Plotting
from simkit.running import RunningBuiltin
from simkit.seeing_world import SeeingWorld
from simkit.simulating import GZSERVER, Simulating
from simkit.steering import Steering
from simkit.talking import Talking
from simkit.tf import Buffer, TransformListener

if TYPE_CHECKING:
    from types import TracebackType

    from simkit.launch import Launch

EPOCH_NS = 1_600_088_400 * 10**9
"""Virtual time at the start [ns]: 14 September 2020, 13:00 UTC, the hour of the lecture."""
_DEFAULT_SCREEN = StreamScreen()


class Simulation(Talking, Steering, Simulating, Plotting, SeeingWorld, Launching):
    """A world of nodes on virtual time. Same seed, same bytes.

    Args:
        seed: Seeds everything random; every node gets a seed of its own from it.
        package_path: Folders in which ROS packages are found; the working folder if None.
        runtime: Where scripts run as processes; one that all simulations of this process share if None.
        screen: Where what nodes say is shown; standard output by default, None for silence.
        confined: Whether launch files and robots may read only the files of packages, and nothing of the environment.
    """

    def __init__(
        self,
        seed: int = 0,
        *,
        package_path: Sequence[str | Path] | None = None,
        runtime: NodeRuntime | None = None,
        screen: Screen | None = _DEFAULT_SCREEN,
        confined: bool = False,
    ) -> None:
        self.seed = seed
        self.packages = PackagePath(package_path, confined=confined)
        self.graph = Graph(Executor(EPOCH_NS), screen, seed=seed)
        self._runtime = runtime
        self._scripts: list[ScriptNode] = []
        self._builtins: list[RunningBuiltin] = []
        self._views: list[Callable[[], None]] = []
        self._launches: list[Launch] = []
        self._sliders = []
        self._closers = []
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
        self._close_views()
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
        executor.run_to(executor.now_ns + nanoseconds(seconds))
        self._refresh_views()

    def run_until(self, predicate: Callable[[], bool], timeout: float) -> bool:
        """Let virtual time pass until `predicate()` holds, at most `timeout` [s]; whether it holds."""
        self._require_open()
        executor = self.graph.executor
        holds = executor.run_to(executor.now_ns + nanoseconds(timeout), predicate)
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
        if (package, executable) == GZSERVER:
            self._begin_with_world()
        command_line = split_command_line(arguments)
        if (package, executable) in builtin_nodes():
            definition = builtin_nodes()[package, executable]
            named = definition.named(command_line, self.graph.nodes)
            builtin = RunningBuiltin(self.graph, definition, named, self.packages)
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


class _Script:
    """A script file and how to show its path."""

    def __init__(self, path: Path, shown: str) -> None:
        self.path = path
        self.shown = shown
