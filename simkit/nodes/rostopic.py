"""`rostopic` as a node, for launch files: `<node pkg="rostopic" type="rostopic" args="pub ..."/>`."""

from __future__ import annotations

from simkit.commands.errors import ToolError
from simkit.commands.topic_commands import read_echo, read_hz, read_pub
from simkit.commands.topic_echo import TopicEcho
from simkit.commands.topic_hz import TopicHz
from simkit.commands.topic_pub import ONCE_SECONDS, TopicPub, announcement, message_of, value_of
from simkit.commands.topic_search import TopicWatcher
from simkit.graph import Node
from simkit.msgs import Duration
from simkit.nodes.program import Program


class RostopicProgram(Program):
    """`rostopic pub`, `echo` or `hz`, until it is done or killed.

    Args:
        node: Its place in the graph.
        argv: The words after `rostopic`.
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        commands = {"pub": self._pub, "echo": self._echo, "hz": self._hz}
        try:
            if not argv or argv[0] not in commands:
                raise ToolError(f"as a node, rostopic can {', '.join(commands)}", exit_code=64)
            commands[argv[0]](argv[1:])
        except ToolError as error:
            self._print(f"{error}\n")
            self._exit(error.exit_code)

    def _pub(self, words: list[str]) -> None:
        line = read_pub(words)
        message = message_of(
            line.type_name, [value_of(word) for word in line.words], self._node.now()
        )
        TopicPub(self._node, line.topic, message, rate=line.rate, latch=line.latch)
        self._print(announcement(rate=line.rate, once=line.once))
        if line.once:
            self._node.create_timer(
                Duration.from_nsec(round(ONCE_SECONDS * 1e9)), lambda: self._exit(0)
            )

    def _echo(self, words: list[str]) -> None:
        topic, form = read_echo(words)
        self._watcher: TopicWatcher = TopicEcho(
            self._node, topic, self._print, form=form, on_done=self._finish
        )

    def _hz(self, words: list[str]) -> None:
        topic, window = read_hz(words)
        self._watcher = TopicHz(self._node, topic, self._print, window=window)

    def _finish(self) -> None:
        # A fault may be found before the watcher is there to be asked.
        self._node.graph.executor.call_soon(self._end)

    def _end(self) -> None:
        fault = self._watcher.fault
        if fault is not None:
            self._print(f"{fault}\n")
        self._exit(fault.exit_code if fault is not None else 0)
