"""The window of turtlesim to look at: as a picture, live, and as a replay."""

from __future__ import annotations

from collections.abc import Callable

from simkit.nodes.turtlesim import Frame, TurtlesimNode
from simkit.viz.live_view import LiveView
from simkit.viz.turtlesim.picture import Picture
from simkit.viz.turtlesim.replay import TurtleReplay


class TurtlesimView:
    """What `sim.turtlesim` is.

    Args:
        node: The turtlesim that runs.
        add_view: Is given a function to call after each stretch of virtual time.
    """

    def __init__(
        self, node: TurtlesimNode, *, add_view: Callable[[Callable[[], None]], object]
    ) -> None:
        self._node = node
        self._add_view = add_view

    @property
    def frame(self) -> Frame:
        """The turtles and their trails."""
        return self._node.frame

    def picture(self, *, names: bool = False) -> Picture:
        """What the window shows now.

        Args:
            names: Write each turtle's name below it.
        """
        return Picture(self._node.frame, names=names)

    def replay(self) -> TurtleReplay:
        """Everything that happened in the window so far, to be played again."""
        return TurtleReplay(self._node.frame)

    def live(self, *, names: bool = True) -> LiveView:
        """A window in a notebook that follows the simulation.

        Args:
            names: Write each turtle's name below it.
        """
        view = LiveView(lambda: self.picture(names=names))
        self._add_view(view.refresh)
        return view
