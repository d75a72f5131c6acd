"""One node of a running launch: its handle, how it ended, how it is started again."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from simkit.launch.plan import PlannedNode
from simkit.nodes import builtin_nodes

if TYPE_CHECKING:
    from simkit.graph.process import ScriptNode
    from simkit.nodes.builtin import RunningBuiltin

MOST_LINES = 12
"""So many lines of its last words are shown."""
MOST_COLUMNS = 200
"""So much of each."""
NodeHandle: TypeAlias = "ScriptNode | RunningBuiltin"
"""A node that was started."""


@dataclass(slots=True)
class Process:
    """One node, however often it is started."""

    planned: PlannedNode
    """What the launch file says."""
    label: str
    """Its name in roslaunch's lines, e.g. `listener-2`."""
    node: NodeHandle | None = None
    """The handle of its last start; None if it could not be started."""
    ended: bool = False
    """Whether its end was noticed."""
    restarts: bool = False
    """Whether it is about to be started again."""
    mute: Callable[[], None] | None = None
    """What keeps its output off the screen."""
    reported: bool = False
    """Whether its last words were shown."""

    @property
    def is_busy(self) -> bool:
        """Whether it is up, or will be."""
        return self.restarts or (self.node is not None and self.node.alive)

    @property
    def is_builtin(self) -> bool:
        """Whether its program comes with the kit."""
        return (self.planned.package, self.planned.type) in builtin_nodes()

    @property
    def command(self) -> str:
        """Its command line, for people."""
        planned = self.planned
        return " ".join([f"{planned.package}/{planned.type}", *arguments_of(planned)])

    def ending(self) -> str:
        """How it ended, in the words of roslaunch."""
        node = self.node
        if node is None or (not node.exit_code and node.failure is None):
            return "process has finished cleanly"
        return f"process has died [exit code {node.exit_code}, cmd {self.command}]."

    def last_words(self) -> str:
        """What it printed last, once, if it has failed; roslaunch would name a log file."""
        node = self.node
        if self.reported or node is None or not node.exit_code or not node.output.strip():
            return ""
        self.reported = True
        lines = node.output.rstrip().split("\n")[-MOST_LINES:]
        shown = "".join(f"\n    {line[:MOST_COLUMNS]}" for line in lines)
        return f'what it printed last (its <node> has no output="screen"):{shown}'


def arguments_of(planned: PlannedNode) -> list[str]:
    """The command line of a node, behind its program: its own words, remappings, name, namespace.

    Raises:
        ValueError: A quotation mark in `args=` is not closed.
    """
    words = shlex.split(planned.args)
    words += [f"{source}:={target}" for source, target in planned.remappings]
    words.append(f"__name:={planned.name}")
    if planned.namespace != "/":
        words.append(f"__ns:={planned.namespace.rstrip('/')}")
    return words
