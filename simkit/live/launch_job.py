"""A launch that was begun from another terminal."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.graph.log import LogLevel
from simkit.launch import Launch
from simkit.live.jobs import press, takes_keys
from simkit.simulation import Simulation

NO_PROCESSES = "No processes to monitor"
"""What roslaunch says when there is nothing to wait for."""
CLOSING = "shutting down processing monitor...\n... shutting down processing monitor complete\n"
"""What roslaunch says at its end."""


class LaunchJob:
    """A launch at work: its nodes speak in its terminal, and end with it.

    Args:
        sim: The simulation.
        launch: The launch, just started.
        before: What there is to say first.
        begin: How many lines of rosout there were before it started.
    """

    def __init__(self, sim: Simulation, launch: Launch, before: str, *, begin: int) -> None:
        self._sim = sim
        self._launch = launch
        self._text = before
        self._lines = 0
        self._shown: dict[int, int] = {}
        self._records = begin
        self.exit_code: int | None = None
        self.takes_keys = any(map(takes_keys, launch.nodes.values()))
        self._text += self._new_lines()

    def press(self, key: str) -> None:
        """Hand a key to the nodes that take keys."""
        for node in self._launch.nodes.values():
            press(node, key)

    def poll(self) -> str:
        """What its nodes and the launch itself have said since the last time."""
        over = self._launch.exit_code is not None and not self._launch.alive
        text, self._text = self._text, ""
        text += "".join([*self._outputs(), *self._log(), self._new_lines()])
        if over and self.exit_code is None:
            self.exit_code = exit_code_of(self._launch)
            text += f"{CLOSING}done\n" if self._launch.handles else f"{NO_PROCESSES}\n{CLOSING}"
        return text

    def cancel(self) -> None:
        """End its nodes."""
        self._launch.shutdown()

    def _new_lines(self) -> str:
        lines = self._launch.lines[self._lines :]
        self._lines += len(lines)
        return "".join(f"{line}\n" for line in lines)

    def _outputs(self) -> Iterator[str]:
        for number, (planned, node) in enumerate(self._launch.handles):
            shown = self._shown.get(number, 0)
            new = node.output[shown:]
            self._shown[number] = shown + len(new)
            if new and self._launch.hides(planned.resolved_name):
                self._launch.note_hidden(planned.resolved_name)
            else:
                yield new

    def _log(self) -> Iterator[str]:
        names = {planned.resolved_name for planned, _ in self._launch.handles}
        records = self._sim.log[self._records :]
        self._records += len(records)
        for record in records:
            if record.node not in names:
                continue
            if record.level < LogLevel.WARN and self._launch.hides(record.node):
                self._launch.note_hidden(record.node)
            elif record.level >= LogLevel.INFO:
                yield f"{record}\n"


def exit_code_of(launch: Launch) -> int:
    """What `roslaunch` ends with: 1 if a required node has ended, or nothing could be started."""
    return 1 if launch.exit_code or (launch.failures and not launch.handles) else 0
