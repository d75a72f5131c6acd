"""Robots that drive or turn the other way than they are told."""

from __future__ import annotations

from simkit.gazebo.watching.motion import Means, means, signed
from simkit.gazebo.watching.watcher import DriveWatcher, Finding, Scene

LOOKS = 6
"""It must go the wrong way for so many looks; the first one is for the motors to obey."""
SLOWEST = (0.03, 0.08)
"""Slower commands [m/s, rad/s] say nothing."""
CLEARLY = 0.3
"""It goes the wrong way with at least this share of the speed."""


class WrongWay(DriveWatcher):
    """Compares what the wheels are told with where the robot goes, for half a second."""

    rule = "GZ-W02"
    is_said_by_rule = True

    def __init__(self, scene: Scene) -> None:
        super().__init__(scene)
        self._judged = (0, 0)

    def look(self) -> Finding | None:
        """Whether it goes the wrong way; once for each way that it is told to go."""
        way = _way(self.drive.command())
        moments = [] if way == self._judged else self.motion.last(LOOKS)
        if not moments or any(_way(one.command) != way for one in moments):
            return None
        self._judged = way
        found = means(moments[1:])
        text = self._backward(found) or self._turned(found) or self._spinning(found)
        return None if text is None else Finding(text=text)

    def _backward(self, found: Means) -> str | None:
        told, moved = found.command[0], found.moved[0]
        if abs(told) < SLOWEST[0] or moved * told > -CLEARLY * told * told:
            return None
        return (
            f"{self.model.name} is told to drive at {signed(told)} m/s, and drives at {signed(moved)} m/s: its wheels "
            "roll backward. A wheel that turns about +y rolls forward along x: turn the axes of its joints round"
        )

    def _turned(self, found: Means) -> str | None:
        told, moved = found.command[1], found.moved[1]
        if abs(told) < SLOWEST[1] or moved * told > -CLEARLY * told * told:
            return None
        left, right = self.drive.left[0].name, self.drive.right[0].name
        return (
            f"{self.model.name} is told to turn at {signed(told)} rad/s, and turns at {signed(moved)} rad/s: left and "
            f"right are swapped. Left is where y is greater: the left joint is {left!r} now, the right one {right!r}"
        )

    def _spinning(self, found: Means) -> str | None:
        told, moved = found.command, found.moved
        turn = 2.0 * told[0] / self.drive.separation
        if abs(told[0]) < SLOWEST[0] or abs(told[1]) > 1e-6:
            return None
        if abs(moved[1]) < CLEARLY * abs(turn) or abs(moved[0]) > CLEARLY * abs(told[0]):
            return None
        return (
            f"{self.model.name} is told to drive straight on at {signed(told[0])} m/s, and turns on the spot at "
            f"{signed(moved[1])} rad/s: its wheels turn against each other. Give both joints the same axis"
        )


def _way(command: tuple[float, float]) -> tuple[int, int]:
    """Forward (1) or backward (-1), to the left (1) or to the right (-1)."""
    speed, turn = command
    return (speed > 0.0) - (speed < 0.0), (turn > 0.0) - (turn < 0.0)
