"""What a controller is: something that reads joints and commands them, step by step."""

from __future__ import annotations

import enum
import math
from collections.abc import Callable
from typing import Any, TypeVar

from simkit.errors import SimkitError
from simkit.graph import Node, Publisher, Subscription, Timer
from simkit.graph.endpoint import Endpoint
from simkit.msgs import Duration, Message
from simkit.plugins.control.hardware import RobotHardware
from simkit.plugins.control.joint_drive import JointHandle
from simkit.plugins.control.registry import ControllerType, in_cpp
from simkit.urdf import Robot, read_robot

MessageT = TypeVar("MessageT", bound=Message)


class ControllerState(enum.Enum):
    """What a controller does."""

    INITIALIZED = "initialized"
    """It is loaded, and has not worked yet."""
    RUNNING = "running"
    """It works."""
    STOPPED = "stopped"
    """It has worked, and does not now."""


class InitError(SimkitError):
    """A controller cannot be loaded.

    Args:
        *texts: What is logged, in the words of ros_control.
        hint: What would be right.
    """

    def __init__(self, *texts: str, hint: str = "") -> None:
        super().__init__("\n".join(texts))
        self.texts = texts
        self.hint = hint


class Controller:
    """One controller; a subclass overrides `init` and what it does in a step.

    Times are virtual times [ns]. An update prepares the step that ends at its time.

    Args:
        node: The node in which it works.
        hardware: The joints.
        root: Namespace of the controller manager, without a slash at its end; empty at the root.
        name: Its name.
        type_: Its type.
    """

    def __init__(
        self, node: Node, hardware: RobotHardware, *, root: str, name: str, type_: ControllerType
    ) -> None:
        self.node = node
        self.hardware = hardware
        self.root = root
        self.name = name
        self.type = type_
        self.state = ControllerState.INITIALIZED
        self.claims: tuple[str, ...] = ()
        """Names of the joints that it needs for itself while it runs."""
        self._endpoints: list[Endpoint] = []
        self._timers: list[Timer] = []

    # -- what a subclass overrides

    def init(self) -> None:
        """Take its parameters, joints and topics.

        Raises:
            InitError: It cannot work so.
        """

    def starting(self, time_ns: int) -> None:
        """It begins to work."""

    def update(self, time_ns: int, period_ns: int) -> None:
        """Command the joints; so much time has passed since the last update."""

    def is_due(self, time_ns: int) -> bool:  # noqa: ARG002 - for those that override it
        """Whether it has something to publish after a step; asked once a step."""
        return False

    def publish(self, time_ns: int) -> None:
        """Publish its state: the step is made, it is due, and the joints were read again."""

    def stopping(self, time_ns: int) -> None:
        """It ceases to work."""

    # -- what it has

    @property
    def is_running(self) -> bool:
        """Whether it works."""
        return self.state is ControllerState.RUNNING

    @property
    def namespace(self) -> str:
        """Where its parameters and topics are."""
        return f"{self.root}/{self.name}"

    def parameter(self, key: str, default: Any = None) -> Any:
        """A parameter of it."""
        return self.node.graph.params.get(f"{self.namespace}/{key}", default)

    def number(self, key: str, default: float, *, is_positive: bool = False) -> float:
        """A parameter of it that is a number.

        Raises:
            InitError: It is not a number.
        """
        value = self.parameter(key, default)
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if not is_number or not math.isfinite(value) or (is_positive and value <= 0):
            kind = "a number above 0" if is_positive else "a number"
            raise InitError(f"The parameter {self.namespace}/{key} must be {kind}, not {value!r}.")
        return float(value)

    def joint_names(self) -> tuple[str, ...]:
        """Its parameter `joints`, a list of joints.

        Raises:
            InitError: It is not a list of names, or one stands twice.
        """
        value, space = self.parameter("joints"), f"(namespace: {self.namespace})."
        fault = _fault_of_names(value)
        if fault:
            right = "write joints: [hip, shoulder], or one line `- hip` for each"
            raise InitError(f"{fault} {space}", hint=right)
        twice = next((one for number, one in enumerate(value) if one in value[:number]), None)
        if twice is not None:
            raise InitError(f"The 'joints' parameter names '{twice}' twice {space}")
        return tuple(value)

    def robot(self) -> Robot:
        """The robot in the parameter robot_description.

        Raises:
            InitError: There is none, or it is invalid.
        """
        params = self.node.graph.params
        text = params.get(f"{self.root}/robot_description", params.get("/robot_description", None))
        robot = None
        if isinstance(text, str):
            robot = read_robot(text, file="robot_description").robot
        if robot is None:
            raise InitError("Failed to parse URDF contained in 'robot_description' parameter")
        return robot

    def joint(self, name: str, refusal: str) -> JointHandle:
        """A joint with the interface that the controller uses.

        Args:
            name: The joint.
            refusal: What is logged if there is none, with `{joint}`, `{controller}` and `{interface}` in it.

        Raises:
            InitError: There is none.
        """
        found = self.hardware.joints_of(self.type.interface).get(name)
        if found is None:
            interface = in_cpp(self.type.interface)
            raise InitError(
                refusal.format(joint=name, controller=self.name, interface=interface),
                hint=self.hardware.why_no_joint(name, controller=self.name, type_=self.type),
            )
        return found

    def advertise(
        self, topic: str, message_class: type[Message], *, latch: bool = False
    ) -> Publisher:
        """Publish on a topic of the controller, until it is unloaded."""
        publisher = self.node.advertise(self._absolute(topic), message_class, latch=latch)
        self._endpoints.append(publisher)
        return publisher

    def subscribe(
        self,
        topic: str,
        message_class: type[MessageT],
        callback: Callable[[MessageT], None],
        *,
        queue_size: int | None = 1,
    ) -> Subscription:
        """Listen to a topic of the controller, until it is unloaded."""
        found = self.node.subscribe(
            self._absolute(topic), message_class, callback, queue_size=queue_size
        )
        self._endpoints.append(found)
        return found

    def advertise_service(
        self, service: str, service_class: Any, handler: Callable[[Any], Message]
    ) -> None:
        """Answer calls of a service of the controller, until it is unloaded."""
        self._endpoints.append(
            self.node.advertise_service(self._absolute(service), service_class, handler)
        )

    def create_timer(self, period_s: float, callback: Callable[[], None]) -> Timer:
        """Call back every period [s], until the controller is unloaded."""
        timer = self.node.create_timer(Duration.from_nsec(round(period_s * 1e9)), callback)
        self._timers = [*(one for one in self._timers if not one.cancelled), timer]
        return timer

    def close(self) -> None:
        """Withdraw from all topics and services."""
        for endpoint in self._endpoints:
            endpoint.unregister()
        for timer in self._timers:
            timer.cancel()

    def _absolute(self, name: str) -> str:
        return name if name.startswith("/") else f"{self.namespace}/{name}"


def _fault_of_names(value: Any) -> str:
    """What keeps a value from being a list of names; empty if nothing does."""
    if value is None:
        return "Could not find 'joints' parameter"
    if not isinstance(value, list):
        return "The 'joints' parameter is not an array"
    if not all(isinstance(one, str) for one in value):
        return "The 'joints' parameter contains a non-string element"
    return "" if value else "The 'joints' parameter is empty"


class PublishClock:
    """Whether a message is due that is published so many times a second.

    Args:
        hertz: Times a second; 0 or less: never.

    Source:
        `publishState` of ros_controllers: `if (last + period < time) last += period`.
    """

    def __init__(self, hertz: float) -> None:
        self._period_ns = round(1e9 / hertz) if hertz > 0.0 else 0
        self._last_ns = 0

    def begin(self, time_ns: int) -> None:
        """The first one is due a period after this time [ns]."""
        self._last_ns = time_ns

    def is_due(self, time_ns: int) -> bool:
        """Whether one is due; asked once a step."""
        if not self._period_ns or self._last_ns + self._period_ns >= time_ns:
            return False
        self._last_ns += self._period_ns
        return True
