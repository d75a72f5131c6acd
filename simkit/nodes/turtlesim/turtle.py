"""One turtle: how it moves, teleports, meets the wall and draws.

No graph and no clock here; `frame` updates it, `endpoints` connects topics and services.

As in turtlesim, the position is kept in metres from the window's upper left corner (`y_down`), in
double precision; what is published is rounded to 32 bits.

Source: turtlesim `Turtle::update`, in its order of operations.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from simkit.nodes.turtlesim.paper import Paper
from simkit.nodes.turtlesim.state import Pen, PoseSample, TurtlePose, TurtleReading, Velocity
from simkit.nodes.turtlesim.window import COMMAND_LIFETIME_NS, SIDE, TICK, Point, float32

PI = 3.14159265  # turtlesim's own, so that headings wrap where they wrap there


@dataclass(frozen=True, slots=True, kw_only=True)
class _Teleport:
    relative: bool
    x: float = 0.0
    y: float = 0.0
    theta: float = 0.0
    linear: float = 0.0


class Turtle:
    """A turtle with its pen, its waiting teleports and the velocity that it was commanded.

    Args:
        name: Name, unique in its frame.
        x: To the right [m].
        y: Upwards [m].
        theta: Heading [rad].
        number: How many turtles its frame made before it; decides its colour in pictures.

    Attributes:
        history: Its pose after each update that changed it.
        gone_ns: Virtual time of the last update before it was removed [ns]; None while it is here.
    """

    def __init__(self, name: str, *, x: float, y: float, theta: float, number: int = 0) -> None:
        self.name = name
        self.number = number
        self.pen = Pen()
        self.history: list[PoseSample] = []
        self.gone_ns: int | None = None
        self._x = float32(x)
        self._y_down = float32(SIDE - float32(y))
        self._theta = float32(theta)
        self._velocity = Velocity()
        self._command: Velocity | None = None
        self._command_time_ns: int | None = None
        self._teleports: list[_Teleport] = []

    @property
    def pose(self) -> TurtlePose:
        """What the turtle would publish now."""
        velocity = self._velocity
        speed = math.sqrt(velocity.x * velocity.x + velocity.y * velocity.y)
        return TurtlePose(
            x=float32(self._x),
            y=float32(SIDE - self._y_down),
            theta=float32(self._theta),
            linear_velocity=float32(speed),
            angular_velocity=float32(velocity.angular),
        )

    def command(self, velocity: Velocity) -> None:
        """Move like this from the next update on; the last command before it counts."""
        self._command = velocity

    def teleport_absolute(self, x: float, y: float, *, theta: float) -> None:
        """Be at x, y [m], heading theta [rad], at the next update."""
        self._teleports.append(
            _Teleport(relative=False, x=float32(x), y=float32(y), theta=float32(theta))
        )

    def teleport_relative(self, linear: float, angular: float) -> None:
        """At the next update turn by `angular` [rad], then jump `linear` [m] ahead."""
        self._teleports.append(
            _Teleport(relative=True, linear=float32(linear), theta=float32(angular))
        )

    def update(self, now_ns: int, paper: Paper) -> TurtleReading:
        """Move on by one tick and draw what the pen passes over.

        Args:
            now_ns: Virtual time [ns].
            paper: What the turtle walks on.
        """
        for teleport in self._teleports:
            self._jump(teleport, paper)
        self._teleports.clear()
        self._obey(now_ns)
        before = (self._x, self._y_down)
        self._move()
        clamped_from = self._clamp()
        here = (self._x, self._y_down)
        pose = self.pose
        reading = TurtleReading(pose=pose, color=paper.color_at(here), clamped_from=clamped_from)
        if here != before and self.pen.is_down:
            paper.draw_line(before, here, turtle=self.name, pen=self.pen)
        if not self.history or self.history[-1].pose != pose:
            self.history.append(PoseSample(time_ns=now_ns, pose=pose))
        return reading

    def _jump(self, teleport: _Teleport, paper: Paper) -> None:
        before = (self._x, self._y_down)
        if teleport.relative:
            self._theta += teleport.theta
            cos, sin = _cos_sin(self._theta)
            self._x += cos * teleport.linear
            self._y_down -= sin * teleport.linear
        else:
            self._x = teleport.x
            self._y_down = max(0.0, SIDE - teleport.y)
            self._theta = teleport.theta
        if self.pen.is_down:
            here = (self._x, self._y_down)
            paper.draw_line(before, here, turtle=self.name, pen=self.pen)

    def _obey(self, now_ns: int) -> None:
        # turtlesim reads its topics once per update, and counts a command's age from that reading.
        if self._command is not None:
            self._velocity, self._command = self._command, None
            self._command_time_ns = now_ns
        commanded = self._command_time_ns
        if commanded is None or now_ns - commanded > COMMAND_LIFETIME_NS:
            self._velocity = Velocity()

    def _move(self) -> None:
        velocity = self._velocity
        self._theta = _wrapped(self._theta + velocity.angular * TICK)
        cos, sin = _cos_sin(self._theta)
        self._x += cos * velocity.x * TICK - sin * velocity.y * TICK
        self._y_down -= sin * velocity.x * TICK + cos * velocity.y * TICK

    def _clamp(self) -> Point | None:
        free = (self._x, self._y_down)
        inside = not (free[0] < 0 or free[0] > SIDE or free[1] < 0 or free[1] > SIDE)
        self._x = min(max(free[0], 0.0), SIDE)
        self._y_down = min(max(free[1], 0.0), SIDE)
        return None if inside else free


def _wrapped(theta: float) -> float:
    # C++ makes an infinite heading "not a number" here; Python would raise.
    if not math.isfinite(theta):
        return math.nan
    return theta - 2 * PI * math.floor((theta + PI) / (2 * PI))


def _cos_sin(theta: float) -> Point:
    if not math.isfinite(theta):
        return (math.nan, math.nan)
    return (math.cos(theta), math.sin(theta))
