"""What a command given in another terminal becomes in the host: something that says more from time to time, and ends."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Protocol

from simkit.errors import UnknownNameError
from simkit.graph.process import ScriptNode
from simkit.live.keyboard import Keyboard
from simkit.nodes.builtin import RunningBuiltin
from simkit.simulation import Simulation


class Job(Protocol):
    """A command at work."""

    exit_code: int | None
    """None while it works."""

    @property
    def takes_keys(self) -> bool:
        """Whether the keys that are pressed in its terminal are meant for it."""

    def poll(self) -> str:
        """What it has to say since the last time; called after each slice of virtual time."""

    def press(self, key: str) -> None:
        """A key was pressed in its terminal: `up`, `down`, `left`, `right`, or a character."""

    def cancel(self) -> None:
        """Its terminal is gone, or Ctrl-C was pressed there."""


Command = Callable[[Simulation, Sequence[str]], Job]
"""Begins a command with its arguments; raises SimkitError when it cannot."""


def takes_keys(node: ScriptNode | RunningBuiltin) -> bool:
    """Whether a node reads the keyboard of its terminal: its program has a method `press`."""
    return node.alive and hasattr(getattr(node, "program", None), "press")


def press(node: ScriptNode | RunningBuiltin, key: str) -> None:
    """Hand a key to a node that takes keys; one that the program does not know is ignored, as in ROS."""
    if isinstance(node, RunningBuiltin) and takes_keys(node):
        with contextlib.suppress(UnknownNameError):
            node.program.press(key)


@contextlib.contextmanager
def keys_of_this_terminal(
    nodes: Iterable[ScriptNode | RunningBuiltin],
) -> Iterator[Callable[[], None]]:
    """A function that hands the keys pressed in the terminal of this process to the nodes that read them.

    Args:
        nodes: What was just started in this terminal.
    """
    readers = [node for node in nodes if takes_keys(node)]
    keyboard = Keyboard()

    def hand_over() -> None:
        for key in keyboard.pressed():
            for node in readers:
                press(node, key)

    with keyboard.reading() if readers else contextlib.nullcontext():
        yield hand_over


class DoneJob:
    """A command that was finished at once."""

    def __init__(self, text: str, exit_code: int = 0) -> None:
        self._text = text
        self.exit_code: int | None = exit_code
        self.takes_keys = False

    def poll(self) -> str:
        """The text, once."""
        text, self._text = self._text, ""
        return text

    def press(self, key: str) -> None:
        """Nobody waits for a key."""

    def cancel(self) -> None:
        """Nothing to end."""


class NodeJob:
    """A node that was started from a terminal: it speaks there, and ends with it.

    Args:
        sim: The simulation.
        node: The node.
        begin: How many lines of rosout there were before it started; as many as now if None.
    """

    def __init__(
        self, sim: Simulation, node: ScriptNode | RunningBuiltin, *, begin: int | None = None
    ) -> None:
        self._sim = sim
        self._node = node
        self._shown = 0
        self._records = len(sim.log) if begin is None else begin
        self.exit_code: int | None = None
        self.takes_keys = takes_keys(node)

    def press(self, key: str) -> None:
        """Hand a key to the node."""
        press(self._node, key)

    def poll(self) -> str:
        """New output and log lines."""
        output, records = self._node.output, self._sim.log
        text = output[self._shown :]
        self._shown = len(output)
        for record in records[self._records :]:
            if record.node == self._node.name:
                text += f"[{record.level.name}] [{record.time.to_sec():.6f}]: {record.text}\n"
        self._records = len(records)
        if not self._node.alive:
            self.exit_code = self._node.exit_code or (1 if self._node.failure else 0)
        return text

    def cancel(self) -> None:
        """Shut the node down."""
        self._node.shutdown()
