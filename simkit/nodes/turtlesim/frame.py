"""Several turtles in one window: who is there, and what an update does to all of them.

Source: turtlesim `TurtleFrame`. No graph and no clock here; `node` connects both.
"""

from __future__ import annotations

from simkit.errors import SimkitError, UnknownNameError
from simkit.nodes.turtlesim.paper import Paper
from simkit.nodes.turtlesim.state import TurtleReading
from simkit.nodes.turtlesim.turtle import Turtle
from simkit.nodes.turtlesim.window import BACKGROUND, CENTRE, Rgb


class TurtleExistsError(SimkitError):
    """A turtle was to be spawned under a name that is taken."""

    def __init__(self, name: str) -> None:
        self.name = name
        super().__init__(f"a turtle named {name!r} is here already; spawn it under another name")


class Frame:
    """A window with turtles; empty until one is spawned.

    Args:
        background: Colour of the empty paper.
    """

    def __init__(self, background: Rgb = BACKGROUND) -> None:
        self.paper = Paper(background)
        self._turtles: dict[str, Turtle] = {}
        self._everyone: list[Turtle] = []
        self._name_counter = 0
        self._made = 0

    @property
    def turtles(self) -> tuple[Turtle, ...]:
        """The turtles, sorted by name: the order in which they are updated and drawn."""
        return tuple(self._turtles[name] for name in sorted(self._turtles))

    @property
    def everyone(self) -> tuple[Turtle, ...]:
        """Every turtle that ever was here, in the order of their births."""
        return tuple(self._everyone)

    def turtle(self, name: str) -> Turtle:
        """The turtle of that name.

        Raises:
            UnknownNameError: There is none.
        """
        if name not in self._turtles:
            raise UnknownNameError("turtle", name, self._turtles)
        return self._turtles[name]

    def spawn(
        self, name: str = "", *, x: float = CENTRE, y: float = CENTRE, theta: float = 0.0
    ) -> Turtle:
        """Add a turtle.

        Args:
            name: Its name; empty for the next free one of turtle1, turtle2, ...
            x: To the right [m]; outside the window it is clamped by the next update.
            y: Upwards [m].
            theta: Heading [rad].

        Raises:
            TurtleExistsError: The name is taken.
        """
        name = name or self._next_name()
        if name in self._turtles:
            raise TurtleExistsError(name)
        turtle = Turtle(name, x=x, y=y, theta=theta, number=self._made)
        self._made += 1
        self._turtles[name] = turtle
        self._everyone.append(turtle)
        return turtle

    def kill(self, name: str) -> None:
        """Remove a turtle; its trail stays.

        Raises:
            UnknownNameError: There is none of that name.
        """
        self.turtle(name).gone_ns = self.paper.now_ns
        del self._turtles[name]

    def reset(self, background: Rgb) -> Turtle:
        """Remove all turtles and trails, and spawn turtle1 in the centre."""
        for name in list(self._turtles):
            self.kill(name)
        self._name_counter = self._made = 0
        self.paper.clear(background)
        return self.spawn()

    def update(self, now_ns: int) -> list[tuple[Turtle, TurtleReading]]:
        """Move every turtle on by one tick, in the order of their names.

        Args:
            now_ns: Virtual time [ns].

        Returns:
            Each turtle and what it gives the outside world.
        """
        self.paper.now_ns = now_ns
        return [(turtle, turtle.update(now_ns, self.paper)) for turtle in self.turtles]

    def _next_name(self) -> str:
        while True:
            self._name_counter += 1
            name = f"turtle{self._name_counter}"
            if name not in self._turtles:
                return name
