"""What a controller is given: its parameters, its joints, its topics; and how it says that it cannot work."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeVar

from simkit.errors import SimkitError
from simkit.graph import Node, Publisher, Subscription, Timer
from simkit.graph.endpoint import Endpoint
from simkit.msgs import Duration, Message
from simkit.plugins.control.advice import missing_joint
from simkit.plugins.control.hardware import RobotHardware
from simkit.plugins.control.interfaces import in_cpp
from simkit.plugins.control.joint_drive import JointHandle
from simkit.urdf import Robot, read_robot

MessageT = TypeVar("MessageT", bound=Message)


class InitError(SimkitError):
    """A controller cannot be loaded.

    Args:
        *texts: What is said, in the words of ros_control.
        hint: What would be right.
    """

    def __init__(self, *texts: str, hint: str = "") -> None:
        super().__init__("\n".join(texts))
        self.texts = texts
        self.hint = hint


class ControllerPlace:
    """The place of one controller.

    Args:
        node: The node in which it works.
        hardware: The joints.
        root: Namespace of the controller manager, without a slash at its end; empty at the root.
        name: Its name.
        type_name: Its type.
        interface: What it tells joints.
    """

    def __init__(
        self,
        node: Node,
        hardware: RobotHardware,
        *,
        root: str,
        name: str,
        type_name: str,
        interface: str,
    ) -> None:
        self.node = node
        self.hardware = hardware
        self.root = root
        self.name = name
        self.type_name = type_name
        self.interface = interface
        self._endpoints: list[Endpoint] = []
        self._timers: list[Timer] = []

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
            InitError: It is none.
        """
        value = self.parameter(key, default)
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if not is_number or not math.isfinite(value) or (is_positive and value <= 0):
            kind = "a number above 0" if is_positive else "a number"
            raise InitError(f"The parameter {self.namespace}/{key} must be {kind}, not {value!r}.")
        return float(value)

    def robot(self) -> Robot:
        """The robot in the parameter robot_description.

        Raises:
            InitError: There is none, or it is of no use.
        """
        params = self.node.graph.params
        text = params.get(f"{self.root}/robot_description", params.get("/robot_description", None))
        robot = None
        if isinstance(text, str):
            robot = read_robot(text, file="robot_description").robot
        if robot is None:
            raise InitError("Failed to parse URDF contained in 'robot_description' parameter")
        return robot

    def names(self, key: str) -> tuple[str, ...]:
        """A parameter of it that is a list of joints.

        Raises:
            InitError: It is none.
        """
        value, space = self.parameter(key), f"(namespace: {self.namespace})."
        right = f"write {key}: [hip, shoulder], or one line `- hip` for each"
        if value is None:
            raise InitError(f"Could not find '{key}' parameter {space}", hint=right)
        if not isinstance(value, list):
            raise InitError(f"The '{key}' parameter is not an array {space}", hint=right)
        if not all(isinstance(one, str) for one in value):
            raise InitError(
                f"The '{key}' parameter contains a non-string element {space}", hint=right
            )
        if not value:
            raise InitError(f"The '{key}' parameter is empty {space}", hint=right)
        twice = next((one for number, one in enumerate(value) if one in value[:number]), None)
        if twice is not None:
            raise InitError(f"The '{key}' parameter names '{twice}' twice {space}")
        return tuple(value)

    def joint(self, name: str, refusal: str) -> JointHandle:
        """A joint with the interface that the controller uses.

        Args:
            name: The joint.
            refusal: What is said if there is none, with `{joint}`, `{controller}` and `{interface}` in it.

        Raises:
            InitError: There is none.
        """
        found = self.hardware.joints_of(self.interface).get(name)
        if found is None:
            interface = in_cpp(self.interface)
            raise InitError(
                refusal.format(joint=name, controller=self.name, interface=interface),
                hint=self._joint_hint(name),
            )
        return found

    def _joint_hint(self, name: str) -> str:
        """Why the controller cannot have a joint: which of the three places does not fit."""
        from simkit.plugins.control.registry import controllers  # it knows of places itself

        return missing_joint(
            name,
            types=controllers(),
            controller=self.name,
            type_name=self.type_name,
            wanted=self.interface,
            offered={one: drive.handle.interface for one, drive in self.hardware.drives.items()},
        )

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
