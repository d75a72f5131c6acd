"""`Simulation`: one clock, one graph, one TF buffer, and what runs on them."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from simkit.graph import Executor, Graph, LogRecord
from simkit.graph.errors import GraphError
from simkit.graph.executor import nanoseconds
from simkit.graph.log import Screen, StreamScreen
from simkit.graph.names import split_command_line
from simkit.graph.params import ParameterServer
from simkit.graph.topic_hints import TopicHints
from simkit.msgs import Time
from simkit.nodes import builtin_nodes
from simkit.nodes.builtin import RunningBuiltin
from simkit.packages import PackagePath
from simkit.simulation import open_simulations
from simkit.simulation.delegate import delegate
from simkit.simulation.gazebo_starter import GZSERVER, GazeboStarter
from simkit.simulation.graph_client import GraphClient
from simkit.simulation.launcher import Launcher, find_script
from simkit.simulation.recorder import Recorder
from simkit.simulation.view import View
from simkit.simulation.widgets import Widgets
from simkit.simulation.world_window import WorldWindow
from simkit.tf import Buffer, TransformListener, echo_text

if TYPE_CHECKING:
    from types import TracebackType

    from simkit.gazebo import Gazebo
    from simkit.graph.process import NodeRuntime, Permissions, ScriptNode
    from simkit.physics import World
    from simkit.viz import TurtlesimView


EPOCH_NS = 1_600_088_400 * 10**9
"""Virtual time at the start [ns]: 14 September 2020, 13:00 UTC, the hour of the lecture."""
_DEFAULT_SCREEN = StreamScreen()


class Simulation:
    """A world of nodes on virtual time. Same seed, same bytes.

    Args:
        seed: Seeds everything random; every node gets a seed of its own from it.
        package_path: Folders in which ROS packages are found; the working folder if None.
        runtime: Where scripts run as processes; one that all simulations of this process share if None.
        screen: Where what nodes say is shown; standard output by default, None for silence.
        confined: Whether launch files and robots may read only the files of packages, and nothing of the environment.

    Attributes:
        graph: Topics, services, parameters, the log, and the clock below them.
        packages: Where packages are found.
        node: The node in whose name Python code takes part.
        builtins: The built-in nodes started so far.
        tf: The transforms that were broadcast.
        graph_client, launcher, gazebo_starter, recorder, view, world_window, widgets: The parts.
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
        self._runtime = runtime
        self._screen = screen
        self.packages = PackagePath(package_path, confined=confined)
        self._scripts: list[ScriptNode] = []
        self._starts: list[tuple[str, tuple[Any, ...], dict[str, Any]]] = []
        self._begin()
        open_simulations.note_open(self, self._scripts)

    def _begin(self) -> None:
        """Be empty, at the first moment."""
        self.graph = Graph(Executor(EPOCH_NS), self._screen, seed=self.seed)
        self.builtins: list[RunningBuiltin] = []
        self.node = self.graph.create_node("/simkit")
        self.graph.reserved_names.add(self.node.name)
        self.tf = Buffer()
        self._tf_listener = TransformListener(self.node, self.tf)
        self._closed = False
        self.graph_client = GraphClient(self)
        self.launcher = Launcher(self)
        self.gazebo_starter = GazeboStarter(self)
        self.recorder = Recorder(self)
        self.view = View(self)
        self.view.add(TopicHints(self.graph, self._scripts).look)
        self.world_window = WorldWindow(self)
        self.widgets = Widgets(self)

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
        self.view.close()
        for script in self._scripts:
            script.close()

    def reset(self) -> None:
        """Begin anew: the same seed, and what `rosrun`, `roslaunch` and `spawn` have started, in that order.

        A cell of a notebook that begins with it gives the same when it is run again. All else is as in a new simulation:
        topics, parameters, recordings and views made before belong to the simulation that has ended, and what Python code
        did besides is not done again.

        Raises:
            SimkitError: What was started can be started no more: its file has changed.
        """
        starts = list(self._starts)
        self.close()
        self._scripts.clear()
        self._begin()
        try:
            for name, arguments, options in starts:
                getattr(self, name)(*arguments, **options)
        finally:
            self._starts = starts

    def note_start(self, name: str, /, *arguments: Any, **options: Any) -> None:
        """Keep a start for `reset`.

        Args:
            name: The method that did it.
            *arguments: Its arguments.
            **options: Its arguments by name.
        """
        self._starts.append((name, arguments, options))

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
        self.require_open()
        executor = self.graph.executor
        executor.run_to(executor.now_ns + nanoseconds(seconds))
        self.view.refresh()

    def run_until(self, predicate: Callable[[], bool], timeout: float) -> bool:
        """Let virtual time pass until `predicate()` holds, at most `timeout` [s]; whether it holds."""
        self.require_open()
        executor = self.graph.executor
        holds = executor.run_to(executor.now_ns + nanoseconds(timeout), predicate)
        self.view.refresh()
        return holds

    def step(self) -> bool:
        """Run the next event; False if nothing is left to happen."""
        self.require_open()
        stepped = self.graph.executor.step()
        self.view.refresh()
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
        node = self.start_node(package, executable, *arguments, permissions=permissions)
        self.note_start("rosrun", package, executable, *arguments, permissions=permissions)
        return node

    def start_node(
        self,
        package: str,
        executable: str,
        *arguments: str,
        permissions: Permissions | None = None,
    ) -> ScriptNode | RunningBuiltin:
        """As `rosrun`, for a node that is part of another start: `reset` begins it with that."""
        self.require_open()
        if (package, executable) == GZSERVER:
            self.gazebo_starter.begin()
        command_line = split_command_line(arguments)
        if (package, executable) in builtin_nodes():
            definition = builtin_nodes()[package, executable]
            named = definition.named(command_line, self.graph.nodes)
            builtin = RunningBuiltin(self.graph, definition, named, self.packages)
            self.builtins.append(builtin)
            return builtin
        return self._run_script(package, executable, arguments, permissions)

    def _run_script(
        self,
        package: str,
        executable: str,
        arguments: Sequence[str],
        permissions: Permissions | None,
    ) -> ScriptNode:
        # processes are loaded with the first script: a robot with built-in nodes needs none
        from simkit.graph.process import Permissions, ScriptNode, StartSpec, shared_runtime

        command_line = split_command_line(arguments)
        script, shown_path = find_script(self.packages, package, executable)
        spec = StartSpec(
            script=str(script),
            shown_path=shown_path,
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

    # -- what its parts do

    topics = delegate("graph_client", GraphClient.topics)
    services = delegate("graph_client", GraphClient.services)
    latest = delegate("graph_client", GraphClient.latest)
    wait_for_message = delegate("graph_client", GraphClient.wait_for_message)
    rostopic_pub = delegate("graph_client", GraphClient.rostopic_pub)
    call = delegate("graph_client", GraphClient.call)
    launch_plan = delegate("launcher", Launcher.launch_plan)
    roslaunch = delegate("launcher", Launcher.roslaunch, is_start=True)
    spawn = delegate("gazebo_starter", GazeboStarter.spawn, is_start=True)
    record = delegate("recorder", Recorder.record)
    record_model = delegate("recorder", Recorder.record_model)
    record_world = delegate("recorder", Recorder.record_world)
    view_frames = delegate("view", View.view_frames)
    rviz = delegate("view", View.rviz)
    rviz_replay = delegate("view", View.rviz_replay)
    window_of = delegate("view", View.window_of)
    serve_window_of = delegate("view", View.serve_window_of)
    gzclient = delegate("world_window", WorldWindow.gzclient)
    gzclient_replay = delegate("world_window", WorldWindow.gzclient_replay)
    tf_plot = delegate("recorder", Recorder.tf_plot)
    joint_plot = delegate("recorder", Recorder.joint_plot)
    tracking_plot = delegate("recorder", Recorder.tracking_plot)
    path_plot = delegate("recorder", Recorder.path_plot)
    joint_sliders = delegate("widgets", Widgets.joint_sliders)
    teleop = delegate("widgets", Widgets.teleop)
    trajectory_sliders = delegate("widgets", Widgets.trajectory_sliders)

    def tf_echo(self, source: str, target: str, *, precision: int = 3) -> str:
        """What `rosrun tf tf_echo source target` prints: where `target` is, seen from `source`."""
        return echo_text(self.tf, source, target, self.now, precision=precision)

    @property
    def has_world(self) -> bool:
        """Whether a world is there already."""
        return self.gazebo_starter.has_world

    @property
    def gazebo(self) -> Gazebo:
        """The world with its models, plugins and services; an empty world with a ground is started if there is none.

        Raises:
            SimkitError: The simulation is closed, or there is no physics engine on this machine.
        """
        return self.gazebo_starter.gazebo

    @property
    def world(self) -> World:
        """The physics of `gazebo`: models, contacts, steps."""
        return self.gazebo.world

    @property
    def turtlesim(self) -> TurtlesimView:
        """The turtlesim that runs here: `picture()`, `replay()`, `live()`.

        Raises:
            SimkitError: None runs.
        """
        return self.view.turtlesim

    def require_open(self) -> None:
        """Refuse to go on with a simulation that is closed.

        Raises:
            GraphError: It is closed.
        """
        if self._closed:
            raise GraphError("this simulation is closed; make a new one: sim = Simulation()")
