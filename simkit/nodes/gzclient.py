"""gzclient as a node: the window of Gazebo; the simulation makes the view of it.

Source: gazebo_ros `empty_world.launch`, which starts it as `gazebo_gui`; gzclient's command line.
"""

from __future__ import annotations

from typing import Final

from simkit.commands.errors import UsageError
from simkit.graph import Node
from simkit.msgs import Duration
from simkit.nodes.program import Program

USAGE: Final = "usage: gzclient [--verbose]"
HINT: Final = "sim.gzclient() shows the world, sim.gzclient(live=True) follows it"
HINT_AFTER: Final = Duration.from_nsec(250_000_000)
"""When a node whose window nobody has opened logs how it is opened."""
_FLAGS: Final = ("--verbose", "-q", "--quiet")
_WITH_VALUE: Final = ("-g", "--gui-plugin", "--gui-client-plugin")


class GzclientProgram(Program):
    """The program `gzclient` of the package gazebo_ros.

    Args:
        node: Its place in the graph.
        argv: Options of gzclient; they change nothing here.

    Raises:
        UsageError: An argument is none of these.
    """

    window = "Gazebo"

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        _check(argv)
        self._timer = node.create_timer(HINT_AFTER, self._hint)

    def show_address(self, url: str) -> None:
        """Print where its page is; then there is no need of a hint."""
        self._timer.cancel()
        super().show_address(url)

    def _hint(self) -> None:
        self._timer.cancel()
        self._print(f"no window opens here: {HINT}\n")


def _check(argv: list[str]) -> None:
    rest = list(argv)
    while rest:
        word = rest.pop(0)
        if word in _WITH_VALUE and rest:
            rest.pop(0)
        elif word not in _FLAGS:
            raise UsageError(f"gzclient: {word!r} is no argument of it; {USAGE}")
