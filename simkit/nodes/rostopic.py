"""`rostopic` as a node, for launch files: `<node pkg="rostopic" type="rostopic" args="pub ..."/>`."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from simkit.commands.errors import ToolError
from simkit.commands.topic_echo import start_echo
from simkit.commands.topic_programs import TopicProgram, start_pub
from simkit.commands.topic_statistics import GAUGES, start_statistics
from simkit.graph import Node
from simkit.nodes.program import Program

COMMANDS: Mapping[str, Callable[..., TopicProgram]] = {
    "pub": start_pub,
    "echo": start_echo,
    **{name: partial(start_statistics, command=name) for name in GAUGES},
}
"""What goes on, and so can be a node."""


class RostopicProgram(Program):
    """`rostopic pub`, `echo`, `hz`, `bw` or `delay`, until it is done or killed.

    Args:
        node: Its place in the graph.
        argv: The words after `rostopic`.
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        try:
            if not argv or argv[0] not in COMMANDS:
                raise ToolError(f"as a node, rostopic can {', '.join(COMMANDS)}", exit_code=64)
            start = COMMANDS[argv[0]]
            self._program = start(node, argv[1:], self._print, self._finish)
        except ToolError as error:
            self._print(f"{error}\n")
            self._exit(error.exit_code)

    def _finish(self) -> None:
        # A fault may be found before the program is there to be asked.
        self._node.graph.executor.call_soon(self._end)

    def _end(self) -> None:
        fault = self._program.fault
        if fault is not None:
            self._print(f"{fault}\n")
        self._exit(fault.exit_code if fault is not None else 0)
