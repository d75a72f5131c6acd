"""Drives a robot or a turtle by hand: a pad of buttons in a notebook that publishes velocities."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Node
from simkit.msgs import message_class
from simkit.viz.by_hand.drive_keys import PAD_CLASS, DriveKey, button_class, keyboard_html
from simkit.viz.by_hand.notebook_widgets import BOX, NotebookWidgets, ipywidgets_for
from simkit.viz.kernel_loop import KernelLoop, Later
from simkit.viz.live_view import SvgPicture
from simkit.viz.page.html import escaped

TYPE = "geometry_msgs/Twist"
"""Type of the messages."""
TICK = 0.1
"""While it runs, so much virtual time passes in one go, and as much of the wall clock's [s]."""
_PAUSE = 0.05
"At most so often the picture beside it is drawn [s of wall-clock time]."
_KEY_WIDTH = "4.4em"
_FASTEST = 1000.0
"No greater speed is taken [m/s, rad/s]."


class HasPicture(Protocol):
    """A window that can be drawn, such as `sim.turtlesim`."""

    def picture(self) -> SvgPicture:
        """What it shows now."""


class HasPage(Protocol):
    """A view that follows by itself, such as `sim.rviz(live=True)`."""

    def _repr_html_(self) -> str: ...


class TeleopPad(NotebookWidgets):
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
        SimkitError: A speed or the step is no number from 0 on.
    """

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
        view: HasPicture | HasPage | None = None,
    ) -> None:
        self._node = node
        self._step = _from_zero("step", step)
        self._speeds = [_from_zero("linear", linear), _from_zero("angular", angular)]
        self._twist: Any = message_class(TYPE)
        self._publisher = node.advertise(topic, self._twist)
        self._run, self._later, self._view = run, later or KernelLoop(), view
        self._box: Any = None
        self._status: Any = None
        self._picture: Any = None
        self._toggle: Any = None
        self._wanted: DriveKey | None = None
        self._last = DriveKey.STOP
        self._is_drawing = self._is_ticking = False

    @property
    def topic(self) -> str:
        """Resolved name of the topic."""
        return self._publisher.topic

    @property
    def is_running(self) -> bool:
        """Whether time passes by itself."""
        return self._toggle is not None and bool(self._toggle.value)

    @property
    def widget(self) -> Any:
        """The ipywidgets box.

        Raises:
            SimkitError: ipywidgets is not installed.
        """
        if self._box is None:
            self._box = self._build(ipywidgets_for("the buttons"))
            self.refresh()
        return self._box

    def press(self, key: str) -> None:
        """Publish what a key commands, and let time pass by one step.

        Args:
            key: "up", "down", "left", "right" or "stop".

        Raises:
            UnknownNameError: There is no such key.
        """
        known = {one.value: one for one in DriveKey}
        if key not in known:
            raise UnknownNameError("key of the pad", key, known)
        self._publish(known[key])
        self._run(self._step)

    def refresh(self) -> None:
        """Show the time, what was commanded, and the picture beside it."""
        if self._box is None:
            return
        self._status.value = "<br>".join(escaped(line) for line in self._state())
        if self._picture is not None and not self._is_drawing:
            self._is_drawing = True
            self._later.after(_PAUSE, self._draw)

    def __repr__(self) -> str:
        return "\n".join(["TeleopPad", *self._state(), "From Python: pad.press('up')"])

    def _state(self) -> tuple[str, str, str]:
        linear, angular = self._command(self._last)
        time = self._node.now().to_sec()
        return self.topic, f"{linear:g} m/s, {angular:g} rad/s", f"time {time:.2f} s"

    # -- the widgets

    def _build(self, widgets: Any) -> Any:
        self.message = widgets.Label(layout={"display": "none"})
        self._status = widgets.HTML()
        self._toggle = widgets.ToggleButton(description="Run", tooltip="Let time pass by itself")
        self._toggle.observe(lambda _: self._on_toggle(), names="value")
        buttons = {key: self._button(widgets, key) for key in DriveKey}
        empty = widgets.Label(layout={"width": _KEY_WIDTH})
        arrows = widgets.GridBox(
            [
                *(empty, buttons[DriveKey.UP], empty),
                *(buttons[DriveKey.LEFT], buttons[DriveKey.STOP], buttons[DriveKey.RIGHT]),
                *(empty, buttons[DriveKey.DOWN], self._toggle),
            ],
            layout={"grid_template_columns": "repeat(3, 4.6em)"},
        )
        self._toggle.layout.width = _KEY_WIDTH
        speeds = [self._speed(widgets, 0, "m/s"), self._speed(widgets, 1, "rad/s")]
        keyboard = widgets.HTML(keyboard_html())
        rows = [arrows, keyboard, *speeds, self._status, self.message]
        pad = widgets.VBox(rows, layout={**BOX, "width": "16.5em", "flex": "0 0 auto"})
        pad.add_class(PAD_CLASS)
        if self._view is None:
            return pad
        beside = widgets.HTML(self._html(), layout={"flex": "1 1 auto", "min_width": "24em"})
        self._picture = beside if hasattr(self._view, "picture") else None
        return widgets.HBox([pad, beside], layout={"align_items": "flex-start"})

    def _button(self, widgets: Any, key: DriveKey) -> Any:
        button = widgets.Button(description=key.sign, layout={"width": _KEY_WIDTH})
        button.tooltip = key.value
        button.add_class(button_class(key))
        button.on_click(lambda _: self._on_press(key))
        return button

    def _speed(self, widgets: Any, number: int, unit: str) -> Any:
        field = widgets.BoundedFloatText(
            value=self._speeds[number],
            min=0.0,
            max=_FASTEST,
            step=0.1,
            description=("linear", "angular")[number],
            layout={"width": "10em"},
            style={"description_width": "4em"},
        )
        field.observe(lambda change: self._set_speed(number, change["new"]), names="value")
        return widgets.HBox([field, widgets.Label(unit)])

    def _set_speed(self, number: int, value: float) -> None:
        self._speeds[number] = value

    def _html(self) -> str:
        view: Any = self._view
        return str(view.picture()._repr_svg_() if hasattr(view, "picture") else view._repr_html_())

    def _draw(self) -> None:
        self._is_drawing = False
        self._picture.value = self._html()

    # -- presses and time

    def _on_press(self, key: DriveKey) -> None:
        # Presses may come faster than the simulation runs: then the last one counts.
        is_first, self._wanted = self._wanted is None, key
        if is_first:
            self._later.soon(self._advance)

    def _on_toggle(self) -> None:
        if self.is_running and not self._is_ticking:
            self._is_ticking = True
            self._later.soon(self._tick)

    def _advance(self) -> None:
        key, self._wanted = self._wanted, None
        if key is not None:
            step = 0.0 if self.is_running else self._step
            if self._attempt(lambda: self._publish(key)) and self._attempt(lambda: self._run(step)):
                self.say(self._silence())
        self.refresh()

    def _tick(self) -> None:
        self._is_ticking = self.is_running and self._attempt(lambda: self._run(TICK))
        if self._is_ticking:
            self._later.after(TICK, self._tick)
        elif self.is_running:
            self._toggle.value = False
        self.refresh()

    def _attempt(self, act: Callable[[], None]) -> bool:
        try:
            act()
        except SimkitError as error:
            self.say(str(error))
            return False
        return True

    def _publish(self, key: DriveKey) -> None:
        self._last = key
        message = self._twist()
        message.linear.x, message.angular.z = self._command(key)
        self._publisher.publish(message)

    def _command(self, key: DriveKey) -> tuple[float, float]:
        linear, angular = (
            share * speed + 0.0 for share, speed in zip(key.shares, self._speeds, strict=True)
        )
        return linear, angular

    def _silence(self) -> str:
        """A sentence if nobody listens; empty if somebody does."""
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
