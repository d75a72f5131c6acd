"""What a cell shows of a node that it starts."""

from __future__ import annotations

import sys
from types import TracebackType

from simkit.graph import LogRecord
from simkit.graph.process import ScriptNode
from simkit.graph.screen import Screen
from simkit.launch import Launch
from simkit.nodes.builtin import RunningBuiltin
from simkit.simulation import Simulation


class StartWatch:
    """Notes what the screen of a simulation shows while a node starts, and shows the rest.

    A silent simulation shows nothing, and some built-in nodes do not print as they go; in a cell
    that starts a node, what it says belongs below it all the same.

    Args:
        sim: The simulation.
    """

    def __init__(self, sim: Simulation) -> None:
        self._graph = sim.graph
        self._screen: Screen | None = sim.graph.screen
        self._shown: dict[str, int] = {}

    def __enter__(self) -> StartWatch:
        self._graph.screen = self
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._graph.screen = self._screen

    def record(self, record: LogRecord) -> None:
        """Hand on a line of rosout."""
        if self._screen is not None:
            self._screen.record(record)

    def output(self, node: str, text: str) -> None:
        """Hand on what a node printed, and note it."""
        if self._screen is not None:
            self._screen.output(node, text)
            self._shown[node] = self._shown.get(node, 0) + len(text)

    def show_launch(self, launch: Launch) -> None:
        """Print what a launch and its nodes have said and nobody has shown."""
        if self._screen is None:
            print("\n".join(launch.lines))
        for name, node in launch.nodes.items():
            if not launch.hides(name):
                self.show_rest(node)

    def show_rest(self, node: ScriptNode | RunningBuiltin) -> None:
        """Print what the node has said and nobody has shown, and why it died."""
        rest = node.output[self._shown.get(node.name, 0) :]
        sys.stdout.write(rest)
        if self._screen is None and node.failure is not None:
            print(f"{node.name} has died: {node.failure}", file=sys.stderr)
