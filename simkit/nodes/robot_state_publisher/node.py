"""The node robot_state_publisher: from joint_states to /tf, and the fixed joints to /tf_static."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from simkit.errors import SimkitError
from simkit.graph import Node
from simkit.graph.names import namespace_of, resolve
from simkit.msgs import Duration, Time, message_class
from simkit.nodes.program import Program
from simkit.nodes.robot_state_publisher.joint_messages import (
    PATIENCE,
    MissingJoints,
    PublishGate,
    Throttle,
)
from simkit.nodes.robot_state_publisher.segments import segments_of
from simkit.tf import StaticTransformBroadcaster, TransformBroadcaster
from simkit.urdf import Robot, read_robot
from simkit.urdf.loader import robot_of

PARAMETER = "robot_description"
"""Parameter with the text of the URDF file."""
AHEAD = Duration.from_nsec(500_000_000)
"""Fixed joints on /tf are dated so far ahead, to hold until the next time."""
OLD = Duration(30)
"""Positions older than this are worth a warning."""
_EMPTY_PAUSE = 300  # [s]
_PAUSE = 10  # [s]


class RobotStatePublisher(Program):
    """The program `robot_state_publisher` of the package of that name.

    It reads the robot once, at its start; without one it logs an error and leaves with exit code 1.

    Args:
        node: Its place in the graph; `~publish_frequency` [Hz], `~use_tf_static`,
            `~ignore_timestamp` and the nearest `tf_prefix` are its parameters.
        _argv: Arguments of its command line; it takes none of its own.
    """

    def __init__(self, node: Node, _argv: list[str]) -> None:
        super().__init__(node)
        try:
            robot = find_robot(node, lambda line: self._print(f"{line}\n"))
        except SimkitError as error:
            node.error(str(error))
            self._exit(1)
            return
        self._begin(robot)

    def _begin(self, robot: Robot) -> None:
        node = self._node
        self._segments = segments_of(robot, info=node.info, warn=node.warn)
        interval = Duration.from_sec(1.0 / max(self._number("~publish_frequency", 50.0), 1.0))
        self._gate = PublishGate(
            interval.to_nsec(), ignore_stamps=self._switch("~ignore_timestamp", default=False)
        )
        self._use_tf_static = self._switch("~use_tf_static", default=True)
        self._last_stamp = Time(0)
        self._empty, self._old, self._unknown = (
            Throttle(_EMPTY_PAUSE),
            Throttle(_PAUSE),
            Throttle(_PAUSE),
        )
        self._missing = MissingJoints(self._segments.moving)
        self._moving_broadcaster = TransformBroadcaster(node)
        self._static_broadcaster = StaticTransformBroadcaster(node)
        self._joint_states = node.subscribe(
            "joint_states",
            message_class("sensor_msgs/JointState"),
            self._on_joint_state,
            queue_size=1,
        )
        self._fixed_timer = node.create_timer(interval, self._publish_fixed)
        self._hint_timer = node.create_timer(PATIENCE, self._hint)

    # -- fixed joints

    def _publish_fixed(self) -> None:
        stamp = self._node.now()
        if self._use_tf_static:
            self._fixed_timer.cancel()
        else:
            stamp = stamp + AHEAD
        prefix = self._prefix()
        messages = [s.message(0.0, stamp, prefix) for s in self._segments.fixed.values()]
        if self._use_tf_static:
            self._static_broadcaster.send_transform(messages)
        else:
            self._moving_broadcaster.send_transform(messages)

    # -- moving joints

    def _on_joint_state(self, state: Any) -> None:
        stamp: Time = state.header.stamp
        self._missing.count_message(stamped=bool(stamp.to_nsec()))
        if len(state.name) != len(state.position):
            self._refuse(state)
            return
        self._check_clock(stamp)
        now_ns = self._node.now().to_nsec()
        if self._gate.counts(state.name, stamp_ns=stamp.to_nsec(), now_ns=now_ns):
            self._publish_moving(self._positions(state), stamp)

    def _refuse(self, state: Any) -> None:
        if state.position:
            self._node.error("Robot state publisher ignored an invalid JointState message")
        elif self._empty.permits(self._node.now().to_nsec()):
            self._node.warn(
                "Robot state publisher ignored a JointState message about joint(s) "
                f'"{state.name[0]}"(,...) whose position member was empty. '
                f"This message will not reappear for {_EMPTY_PAUSE} seconds."
            )

    def _check_clock(self, stamp: Time) -> None:
        now = self._node.now()
        if self._last_stamp > now:
            self._node.warn(
                "Moved backwards in time (probably because ROS clock was reset), "
                "re-publishing joint transforms!"
            )
            self._gate.forget()
        if stamp + OLD < now and self._old.permits(now.to_nsec()):
            self._node.warn(f"Received JointState is {(now - stamp).to_sec():f} seconds old.")
        self._last_stamp = now

    def _positions(self, state: Any) -> dict[str, float]:
        """Position of each joint that is named, and of those that follow one of them."""
        positions: dict[str, float] = {}
        for name, position in zip(state.name, state.position, strict=True):
            positions.setdefault(name, position)
        for name, joint in self._segments.mimics.items():
            mimic = joint.mimic
            if mimic is not None and mimic.joint in positions:
                value = positions[mimic.joint] * mimic.multiplier + mimic.offset
                positions.setdefault(name, value)
        return positions

    def _publish_moving(self, positions: dict[str, float], stamp: Time) -> None:
        prefix, messages = self._prefix(), []
        for name in sorted(positions):
            segment = self._segments.moving.get(name)
            if segment is not None:
                messages.append(segment.message(positions[name], stamp, prefix))
            elif self._unknown.permits(self._node.now().to_nsec()):
                self._node.warn(
                    f'Joint state with name: "{name}" was received but not found in URDF'
                )
        self._moving_broadcaster.send_transform(messages)
        self._missing.note_positions(positions)

    def _hint(self) -> None:
        self._hint_timer.cancel()
        topic = self._joint_states.topic
        known = self._node.graph.topics.get(topic)
        speakers = sorted({p.node_name for p in known.publishers}) if known is not None else []
        hint = self._missing.hint(topic, speakers)
        if hint is not None:
            self._node.warn(hint)

    # -- parameters

    def _prefix(self) -> str:
        params = self._node.graph.params
        name = params.search(self._node.name, "tf_prefix")
        value = "" if name is None else params.get(name, "")
        return value if isinstance(value, str) else ""

    def _number(self, name: str, default: float) -> float:
        """A parameter; one of another type counts as not set, as in roscpp."""
        value = self._node.get_param(name, default)
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        return float(value) if is_number and math.isfinite(value) else default

    def _switch(self, name: str, *, default: bool) -> bool:
        value = self._node.get_param(name, default)
        return value if isinstance(value, bool) else default


class StatePublisher(RobotStatePublisher):
    """The same program under its old name, `state_publisher`."""

    def __init__(self, node: Node, argv: list[str]) -> None:
        node.warn(
            "The 'state_publisher' executable is deprecated. "
            "Please use 'robot_state_publisher' instead"
        )
        super().__init__(node, argv)


class NoRobotError(SimkitError):
    """Nobody has loaded a robot."""


def find_robot(node: Node, log: Callable[[str], None]) -> Robot:
    """The robot that a node finds on the parameter server.

    Args:
        node: Whose namespace is searched, from the inside out.
        log: Is given each line that urdfdom prints about the file.

    Raises:
        NoRobotError: There is no such parameter.
        UrdfError: urdfdom refuses the robot.
    """
    name = _parameter_name(node)
    if name is None:
        raise NoRobotError(f"Could not find parameter {PARAMETER} on parameter server")
    text = node.graph.params.get(name)
    if not isinstance(text, str):
        raise NoRobotError(f"Could not read parameter {PARAMETER} on parameter server")
    reading = read_robot(text, file=PARAMETER)
    for message in reading.messages:
        log(message)
    return robot_of(reading)


def _parameter_name(node: Node) -> str | None:
    params, remapped = node.graph.params, node.resolve(PARAMETER)
    if remapped != resolve(PARAMETER, node.name):
        return remapped if params.has(remapped) else None
    return params.search(namespace_of(node.name), PARAMETER)
