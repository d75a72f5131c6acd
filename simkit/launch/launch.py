"""A launch that runs: its nodes, what roslaunch would print about them, respawn and required.

Source: roslaunch's `ProcessMonitor`, on virtual time.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Protocol

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Graph
from simkit.graph.executor import nanoseconds
from simkit.launch.parameters import apply_parameters, description_lines
from simkit.launch.plan import TEXT_NAME, LaunchPlan, PlannedNode
from simkit.launch.process import Process, arguments_of
from simkit.launch.summary import summary_of, warning_lines
from simkit.nodes import builtin_nodes

if TYPE_CHECKING:
    from simkit.graph.process import Permissions
    from simkit.launch.process import NodeHandle

RESTART_SECONDS = 0.1
"""roslaunch looks after its processes this often, so a node is never started again sooner [s]."""
NAME = "/roslaunch"
"""Who says the lines of a launch on the screen."""


class Rosrun(Protocol):
    """Starts a node, as `Simulation.rosrun` does."""

    def __call__(
        self, package: str, executable: str, *arguments: str, permissions: Permissions | None = None
    ) -> NodeHandle:
        """Start it."""


class Launch:
    """A launch file at work; made by `Simulation.roslaunch`.

    Args:
        plan: What the launch file comes to.
        graph: The graph on which its nodes live.
        rosrun: Starts a node.
        folders: Where packages are looked for, for messages.
        permissions: What it and its nodes may do; anything if None.
        all_on_screen: Whether to show what nodes print, whatever `output=` says.
    """

    def __init__(
        self,
        plan: LaunchPlan,
        graph: Graph,
        rosrun: Rosrun,
        *,
        folders: list[str],
        permissions: Permissions | None = None,
        all_on_screen: bool = False,
    ) -> None:
        self.plan = plan
        self.lines: list[str] = []
        self.failures: list[str] = []
        self.refusals: list[str] = []
        self.handles: list[tuple[PlannedNode, NodeHandle]] = []
        self.exit_code: int | None = None
        self._graph = graph
        self._rosrun = rosrun
        self._folders = folders
        self._permissions = permissions
        self._all_on_screen = all_on_screen
        self._processes: list[Process] = []
        self._ending = False
        self._looking = False
        self._said_hidden = False

    def __repr__(self) -> str:
        state = "running" if self.alive else "ended"
        return f"<launch {self.plan.shown_file}: {', '.join(self.nodes) or 'no nodes'}, {state}>"

    @property
    def summary(self) -> str:
        """What roslaunch prints first: the parameters and nodes."""
        return summary_of(self.plan)

    @property
    def nodes(self) -> dict[str, NodeHandle]:
        """The nodes that were started, by resolved name: the handle of the last start of each."""
        return {
            process.planned.resolved_name: process.node
            for process in self._processes
            if process.node is not None
        }

    @property
    def alive(self) -> bool:
        """Whether a node of it is up, or will be."""
        return any(process.is_busy for process in self._processes)

    def is_of(self, file: str, given: Mapping[str, str]) -> bool:
        """Whether it is the launch of a file with certain arguments; one text may be another than the next."""
        is_file = self.plan.file != TEXT_NAME
        return is_file and self.plan.file == file and dict(self.plan.given) == dict(given)

    def start(self) -> None:
        """Set the parameters, then start the nodes in the order of the file."""
        self._graph.departures.append(self._look_soon)
        for line in warning_lines(self.plan):
            self.say(line)
        for line in apply_parameters(self.plan, self._graph.params, self._permissions):
            self.say(line)
            if line.startswith("refused: "):
                self.refusals.append(line.removeprefix("refused: "))
        for line in description_lines(self.plan, self._graph.params.names()):
            self.say(line)
        for number, planned in enumerate(self.plan.nodes, 1):
            process = Process(planned, f"{planned.name}-{number}")
            self._processes.append(process)
            self._start(process)
        self._look_soon()

    def shutdown(self) -> None:
        """End its nodes, the last one first."""
        if self._ending:
            return
        self._ending = True
        for process in reversed(self._processes):
            process.restarts = False
            if process.node is not None and process.node.alive:
                self.say(f"[{process.label}] killing on exit")
                process.node.shutdown()
        self._look_soon()

    def say(self, line: str) -> None:
        """Print a line of roslaunch's own: on the screen, and to `lines`."""
        self.lines.append(line)
        self._graph.show_output(NAME, f"{line}\n")

    def hides(self, node_name: str) -> bool:
        """Whether what a node of it prints is kept off the screen."""
        process = self._process(node_name)
        hidden = process is not None and process.planned.output == "log"
        return hidden and not self._all_on_screen

    def note_hidden(self, node_name: str) -> None:
        """Say once that a script prints what nobody sees."""
        process = self._process(node_name)
        is_script = process is not None and not process.is_builtin
        if is_script and not self._said_hidden:
            self._said_hidden = True
            self.say(
                f'note: what {node_name} prints is not shown: its <node> has no output="screen"'
            )

    # -- private

    def _process(self, node_name: str) -> Process | None:
        return next(
            (one for one in self._processes if one.planned.resolved_name == node_name), None
        )

    def _start(self, process: Process) -> None:
        planned = process.planned
        process.ended = process.restarts = False
        refusal = self._refusal(planned)
        if refusal:
            self.refusals.append(refusal)
            self.say(f"refused: {refusal}")
            return
        name = planned.resolved_name
        if self.hides(name):
            process.mute = lambda: self.note_hidden(name)
            self._graph.muted[name] = process.mute
        else:  # an older launch may have hidden it
            self._graph.muted.pop(name, None)
        started = f"process[{process.label}]: started {planned.package}/{planned.type}"
        if process.is_builtin:
            self.say(started)  # it speaks at once, a script a moment later
        try:
            arguments = arguments_of(planned)
            process.node = self._rosrun(
                planned.package, planned.type, *arguments, permissions=self._permissions
            )
        except (SimkitError, ValueError) as error:
            self._unmute(process)
            self._fail(planned, error)
            return
        self.handles.append((planned, process.node))
        if not process.is_builtin:
            self.say(started)

    def _refusal(self, planned: PlannedNode) -> str | None:
        if self._permissions is None or (planned.package, planned.type) not in builtin_nodes():
            return None
        return self._permissions.refuse_node(planned.package, planned.type)

    def _fail(self, planned: PlannedNode, error: Exception) -> None:
        kind = f"{planned.package}/{planned.type}"
        line = f"ERROR: cannot launch node of type [{kind}]: {self._why(planned, error)}"
        place = f"{planned.shown_file}:{planned.span.line}:{planned.span.column}"
        self.failures.append(line)
        self.say(f"{line}\n{place}: {error}")

    def _why(self, planned: PlannedNode, error: Exception) -> str:
        """The reason in the words of roslaunch."""
        if not isinstance(error, UnknownNameError):
            return str(error)
        if error.kind == "package":
            places = "".join(f"\nROS path [{n}]={path}" for n, path in enumerate(self._folders))
            return f"{planned.package}{places}"
        return (
            f"Cannot locate node of type [{planned.type}] in package [{planned.package}]. Make sure file "
            "exists in package path and permission is set to executable (chmod +x)"
        )

    def _look_soon(self) -> None:
        # A node leaves the graph in the middle of its last turn: what became of it is known a moment later.
        if not self._looking:
            self._looking = True
            self._graph.executor.call_soon(self._look)

    def _look(self) -> None:
        """Notice the ends of nodes, and do what the launch file wants then."""
        self._looking = False
        noticed = False
        for process in self._processes:
            if process.node is None or process.node.alive or process.ended:
                continue
            process.ended = noticed = True
            self._unmute(process)
            if not self._ending:
                self._after_end(process)
        if not self.alive and self._look_soon in self._graph.departures:
            self._graph.departures.remove(self._look_soon)
            if noticed and not self._ending:
                self.say("all processes on machine have died, roslaunch will exit")
            self.exit_code = self.exit_code or 0

    def _unmute(self, process: Process) -> None:
        name = process.planned.resolved_name
        if process.mute is not None and self._graph.muted.get(name) is process.mute:
            del self._graph.muted[name]

    def _after_end(self, process: Process) -> None:
        name = process.planned.resolved_name
        if name in self._graph.nodes:
            self.say(f"[{process.label}] another node took the name {name}")
        elif process.planned.required:
            line = "=" * 80
            self.say(
                f"{line}REQUIRED process [{process.label}] has died!\n{process.ending()}\n"
                f"Initiating shutdown!\n{line}"
            )
            self._tell_last_words(process)
            self.exit_code = 1
            self.shutdown()
        else:
            self.say(f"[{process.label}] {process.ending()}")
            self._tell_last_words(process)
            if process.planned.respawn:
                self._restart_later(process)

    def _tell_last_words(self, process: Process) -> None:
        """What a node that died said where nobody saw it."""
        words = process.last_words() if self.hides(process.planned.resolved_name) else ""
        if words:
            self.say(words)

    def _restart_later(self, process: Process) -> None:
        process.restarts = True
        delay = nanoseconds(max(process.planned.respawn_delay, RESTART_SECONDS))
        now = self._graph.executor.now_ns
        self._graph.executor.call_at(now + delay, lambda: self._restart(process))

    def _restart(self, process: Process) -> None:
        if not process.restarts:
            return
        if process.planned.resolved_name in self._graph.nodes:
            process.restarts = False  # somebody else has taken its place
            self._look_soon()
            return
        self.say(f"[{process.label}] restarting process")
        self._start(process)
