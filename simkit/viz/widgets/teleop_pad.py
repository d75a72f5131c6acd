"""Drives a robot or a turtle by hand: a pad of buttons in a notebook that publishes velocities."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Final

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Node
from simkit.msgs import message_class
from simkit.viz.widgets.kernel_loop import Later
from simkit.viz.widgets.panel import Panel

TYPE: Final = "geometry_msgs/Twist"
"""Type of the messages."""
TICK: Final = 0.1
"""While it runs, so much virtual time passes in one go, and as much of the wall clock's [s]."""
KEYS: Final = {"up": (1, 0), "down": (-1, 0), "left": (0, 1), "right": (0, -1), "stop": (0, 0)}
"""Shares of the linear and of the angular speed that each key commands, as in turtle_teleop_key."""
_FASTEST: Final = 1000.0
"No greater speed is taken [m/s, rad/s]."


class TeleopPad(Panel):
    """Four arrows and a stop, which publish geometry_msgs/Twist.

    Each press publishes once, as in teleop_turtle_key, and lets virtual time pass by `step`. With
    "Run" on, time passes by itself, about as fast as that of the wall clock, until it is off. While a
    cell runs, a press waits for its end.

    Args:
        node: The node that publishes.
        topic: Resolved name of the topic.
        linear: Speed of the arrows up and down [m/s].
        angular: Speed of the arrows to the left and right [rad/s].
        step: Virtual time that a press takes [s].
        run: Lets virtual time pass [s].
        later: Where a run waits for its turn; the kernel's event loop if None.
        view: What is shown beside the buttons; nothing if None.

    Raises:
        SimkitError: A speed or the step is negative, NaN or too large.
    """

    SCRIPT = "pad"

    def __init__(
        self,
        node: Node,
        topic: str,
        *,
        linear: float,
        angular: float,
        step: float,
        run: Callable[[float], None],
        later: Later | None = None,
        view: Any = None,
    ) -> None:
        self._turtles = view if hasattr(view, "picture") else None
        super().__init__(later=later, view=None if self._turtles else view)
        self._node = node
        self._step = _from_zero("step", step)
        self._speeds = {
            "linear": _from_zero("linear", linear),
            "angular": _from_zero("angular", angular),
        }
        self._twist: Any = message_class(TYPE)
        self._publisher = node.advertise(topic, self._twist)
        self._run = run
        self._wanted: str | None = None
        self._last = "stop"
        self._is_running = self._is_ticking = False

    @property
    def topic(self) -> str:
        """Resolved name of the topic."""
        return self._publisher.topic

    @property
    def is_running(self) -> bool:
        """Whether time passes by itself."""
        return self._is_running

    def press(self, key: str) -> None:
        """Publish what a key commands, and let time pass by one step.

        Args:
            key: "up", "down", "left", "right" or "stop".

        Raises:
            UnknownNameError: There is no such key.
        """
        if key not in KEYS:
            raise UnknownNameError("key of the pad", key, KEYS)
        self._publish(key)
        self._run(self._step)

    def state(self) -> dict[str, Any]:
        """Speeds, what was commanded last, and the time."""
        return {
            **self._speeds,
            "running": self._is_running,
            "lines": list(self._lines()),
            "message": self._message,
        }

    def picture(self) -> dict[str, str]:
        """The window of turtlesim, if that is the view."""
        return {} if self._turtles is None else {"svg": self._turtles.picture()._repr_svg_()}

    def hear(self, message: Mapping[str, Any]) -> None:
        """A key, the button Run, or a speed."""
        match message:
            case {"press": str(key)} if key in KEYS:
                self._on_press(key)
            case {"run": bool(wanted)}:
                self._on_run(wanted=wanted)
            case {"linear": float() | int() as speed}:
                self._attempt(lambda: self._set_speed("linear", speed))
            case {"angular": float() | int() as speed}:
                self._attempt(lambda: self._set_speed("angular", speed))

    def __repr__(self) -> str:
        return "\n".join(["TeleopPad", *self._lines(), "From Python: pad.press('up')"])

    def _lines(self) -> tuple[str, str, str]:
        linear, angular = self._command(self._last)
        time = self._node.now().to_sec()
        return self.topic, f"{linear:g} m/s, {angular:g} rad/s", f"time {time:.2f} s"

    def _set_speed(self, name: str, speed: float) -> None:
        self._speeds[name] = _from_zero(name, speed)
        self.say("")

    # -- presses and time

    def _on_press(self, key: str) -> None:
        # Presses may come faster than the simulation runs: then the last one counts.
        self._wanted = key
        self._soon(self._advance)

    def _on_run(self, *, wanted: bool) -> None:
        self._is_running = wanted
        if wanted and not self._is_ticking:
            self._is_ticking = True
            self._later.soon(self._tick)
        self.refresh()

    def _advance(self) -> None:
        key, self._wanted = self._wanted, None
        if key is not None:
            step = 0.0 if self._is_running else self._step
            if self._attempt(lambda: self._publish(key)) and self._attempt(lambda: self._run(step)):
                self.say(self._silence())
        self.refresh()

    def _tick(self) -> None:
        self._is_ticking = self._is_running and self._attempt(lambda: self._run(TICK))
        if self._is_ticking:
            self._later.after(TICK, self._tick)
        else:
            self._is_running = False
        self.refresh()

    def _publish(self, key: str) -> None:
        self._last = key
        message = self._twist()
        message.linear.x, message.angular.z = self._command(key)
        self._publisher.publish(message)

    def _command(self, key: str) -> tuple[float, float]:
        linear, angular = KEYS[key]
        # Adding 0.0 makes -0.0 a plain 0.
        return linear * self._speeds["linear"] + 0.0, angular * self._speeds["angular"] + 0.0

    def _silence(self) -> str:
        """A sentence if no node listens; empty if one does."""
        if self._publisher.num_connections:
            return ""
        heard = _listened_to(self._node)
        topics = f"; topics of {TYPE} with listeners: {', '.join(heard)}" if heard else ""
        return f"No node listens to {self.topic}{topics}."


def _listened_to(node: Node) -> list[str]:
    topics: Mapping[str, Any] = node.graph.topics
    return sorted(
        name
        for name, topic in topics.items()
        if topic.message_class._type == TYPE and topic.subscriptions
    )


def _from_zero(name: str, value: float) -> float:
    if not 0.0 <= value <= _FASTEST:
        raise SimkitError(f"{name} of a teleop pad is a number from 0 to {_FASTEST:g}, not {value}")
    return float(value)
