"""The sliders of joint_state_publisher_gui, without a window: `simkit.viz.widgets` draws them.

`use_gui` turns the publisher into this one.

Source: joint_state_publisher_gui 1.15: a slider of 10000 steps per joint, Randomize, Center.
"""

from __future__ import annotations

import random
from dataclasses import dataclass
from typing import Any

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Node
from simkit.msgs import message_class
from simkit.nodes.joint_state_publisher.joints import FreeJoint
from simkit.nodes.joint_state_publisher.node import JointStatePublisher
from simkit.nodes.joint_state_publisher.settings import look_up

STEPS = 10_000
"""Places of a slider, besides its first."""
MOVE_TOPIC = "~move"
"""Topic with the positions of whoever has no sliders."""
DEPRECATED = (
    "The 'use_gui' parameter was specified, which is deprecated. It counts here, as in Melodic; "
    "Noetic ignores it and shows no sliders: there, start the node joint_state_publisher_gui of "
    "the package joint_state_publisher_gui instead."
)
"""What the parameter `use_gui` is answered with."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SliderJoint:
    """A joint with a slider, at one moment."""

    name: str
    """Its name."""
    lower: float
    """Left end of the slider [rad or m]."""
    upper: float
    """Right end of the slider [rad or m]."""
    position: float
    """Where it stands [rad or m]."""
    unit: str
    """`rad` or `m`."""


class JointStatePublisherGui(JointStatePublisher):
    """The program `joint_state_publisher_gui`: joints that a person moves.

    A joint whose range is a single position has no slider.

    Args:
        node: Its place in the graph.
        argv: Arguments of its command line; it takes none of its own.
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node, argv)
        self._random = random.Random(node.seed)
        if self._table is not None:
            self.center()

    @property
    def title(self) -> str:
        """Title of its window."""
        return f"Node: {self._node.name}"

    @property
    def name(self) -> str:
        """Resolved name of its node."""
        return self._node.name

    @property
    def alive(self) -> bool:
        """Whether its node is up."""
        return self._node.alive

    @property
    def joints(self) -> tuple[SliderJoint, ...]:
        """The joints with a slider, in the order of the file."""
        return tuple(
            SliderJoint(
                name=name,
                lower=joint.lower,
                upper=joint.upper,
                position=joint.zero if joint.position is None else joint.position,
                unit=joint.unit,
            )
            for name, joint in self._with_slider().items()
        )

    def set_position(self, name: str, value: float) -> None:
        """Move a joint to exactly this position [rad or m]; the next message has it.

        Raises:
            UnknownNameError: No joint of that name has a slider.
            SimkitError: The position is beyond an end of the slider.
        """
        joint = self._joint(name)
        low, high = sorted((joint.lower, joint.upper))
        if not low <= value <= high:
            raise SimkitError(
                f"{name} cannot stand at {value:g} {joint.unit}: "
                f"its slider goes from {low:.4g} to {high:.4g} {joint.unit}"
            )
        joint.position = float(value)

    def move_slider(self, name: str, step: int) -> None:
        """Put the slider of a joint on a step from 0 to `STEPS`, as a mouse does; further is the end.

        Raises:
            UnknownNameError: No joint of that name has a slider.
        """
        joint = self._joint(name)
        share = min(max(step, 0), STEPS) / STEPS
        joint.position = joint.lower + (joint.upper - joint.lower) * share

    def center(self) -> None:
        """Move every joint to its zero, on the step below it."""
        self._node.info("Centering")
        for name, joint in self._with_slider().items():
            self.move_slider(name, _step(joint, joint.zero))

    def randomize(self) -> None:
        """Move every joint somewhere in its range, drawn from the seed of the simulation."""
        self._node.info("Randomizing")
        for name, joint in self._with_slider().items():
            self.move_slider(name, _step(joint, self._random.uniform(joint.lower, joint.upper)))

    def listen(self) -> None:
        """Take positions from a topic of its own too, and say how: for those who have no sliders.

        It says so as a warning that begins with `hint:`, which every terminal shows.
        """
        if not self._node.alive or not self.joints:
            return
        self._node.subscribe(MOVE_TOPIC, message_class("sensor_msgs/JointState"), self._move)
        topic, first = self._node.resolve(MOVE_TOPIC), self.joints[0]
        names = ", ".join(joint.name for joint in self.joints)
        self._node.warn(
            "hint: there is no window with sliders here, as there is in a notebook; "
            f"to move {names}, in another terminal:\n"
            f"  simkit rostopic pub -1 {topic} sensor_msgs/JointState "
            f'"{{name: [{first.name}], position: [{_example(first)}]}}"'
        )

    def _move(self, message: Any) -> None:
        for name, value in zip(message.name, message.position, strict=False):
            try:
                self.set_position(name, value)
            except SimkitError as error:
                self._node.error(str(error))

    def _joint(self, name: str) -> FreeJoint:
        joints = self._with_slider()
        if name not in joints:
            raise UnknownNameError("joint with a slider", name, joints)
        return joints[name]

    def _with_slider(self) -> dict[str, FreeJoint]:
        if self._table is None:
            return {}
        free = self._table.free
        return {name: free[name] for name in self._table.names if _has_slider(free.get(name))}


def start_joint_state_publisher(node: Node, argv: list[str]) -> JointStatePublisher:
    """The program `joint_state_publisher` of Melodic.

    Args:
        node: Its place in the graph.
        argv: Arguments of its command line.
    """
    if not look_up(node, "use_gui", False):
        return JointStatePublisher(node, argv)
    node.warn(DEPRECATED)
    return JointStatePublisherGui(node, argv)


def _has_slider(joint: FreeJoint | None) -> bool:
    return joint is not None and joint.lower != joint.upper


def _step(joint: FreeJoint, position: float) -> int:
    """The step of a slider at or below a position."""
    return int((position - joint.lower) * STEPS / (joint.upper - joint.lower))


def _example(joint: SliderJoint) -> str:
    """A position that is seen well: half a radian, or halfway to the end."""
    return f"{min(0.5, round(joint.upper / 2.0, 3)):g}" if joint.upper > 0.0 else f"{joint.lower:g}"
