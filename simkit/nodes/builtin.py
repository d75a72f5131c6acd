"""The handle of a built-in node that runs: the same questions as a script's."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from simkit.graph import Graph
from simkit.graph.names import CommandLine, join
from simkit.nodes import BuiltinNode
from simkit.packages import PackagePath

if TYPE_CHECKING:
    from simkit.graph.process import NodeFailure


class RunningBuiltin:
    """A built-in node on the graph.

    Args:
        graph: The graph it joins.
        definition: Which node.
        command_line: What its arguments say.
        packages: Where packages are.
    """

    def __init__(
        self,
        graph: Graph,
        definition: BuiltinNode,
        command_line: CommandLine,
        packages: PackagePath,
    ) -> None:
        name = join(command_line.namespace, command_line.node_name or definition.node_name)
        self._node = graph.create_node(name, command_line.resolved_remappings(name))
        for key, value in command_line.private_parameters.items():
            self._node.set_param("~" + key, value)
        try:
            self.program: Any = definition(self._node, list(command_line.arguments), packages)
        except BaseException:
            self._node.shutdown()  # half a node must not stay on the graph
            raise
        self.failure: NodeFailure | None = None
        self.refusals: list[str] = []

    def __repr__(self) -> str:
        return f"<node {self.name} (built in), {'running' if self.alive else 'ended'}>"

    @property
    def name(self) -> str:
        """Resolved name."""
        return self._node.name

    @property
    def alive(self) -> bool:
        """Whether it is still on the graph."""
        return self._node.alive

    @property
    def exit_code(self) -> int | None:
        """What the program ended with; None while it runs."""
        code: int | None = getattr(self.program, "exit_code", None)
        return code

    @property
    def output(self) -> str:
        """What the program has printed so far; most print nothing."""
        return str(getattr(self.program, "output", ""))

    def shutdown(self) -> None:
        """Leave the graph."""
        self._node.shutdown()
