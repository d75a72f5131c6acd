"""The node joint_state_publisher: publishes at a fixed rate the state of each joint, and of those that follow it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from simkit.graph import Node
from simkit.msgs import Duration, Time, message_class
from simkit.nodes.joint_state_publisher.joints import Follower, FreeJoint, RobotJoints, read_joints
from simkit.nodes.joint_state_publisher.settings import Crash, SliderSettings, read_settings
from simkit.nodes.program import Program


class JointStatePublisher(Program):
    """The program `joint_state_publisher` of the package of that name.

    It reads the robot once, at its start. If it cannot, it prints the last line of the traceback
    that the original ends with, logs what to do, and leaves with exit code 1.

    Args:
        node: Its place in the graph.
        _argv: Arguments of its command line; it takes none of its own.
    """

    def __init__(self, node: Node, _argv: list[str]) -> None:
        super().__init__(node)
        self._table: JointTable | None = None
        self.period = Duration(0)
        try:
            settings = read_settings(node)
            self._table = JointTable(read_joints(settings, node.warn))
        except Crash as crash:
            self._end(crash)
            return
        self._begin(settings)

    def _begin(self, settings: SliderSettings) -> None:
        self._delta = settings.delta
        self.period = Duration.from_nsec(max(1, round(1e9 / settings.rate)))
        message = message_class("sensor_msgs/JointState")
        for topic in settings.source_list:
            self._node.subscribe(topic, message, self._take)
        self._publisher = self._node.advertise("joint_states", message, queue_size=5)
        # The first message belongs to the start; a node that starts at this instant receives it too.
        self._node.graph.executor.call_soon(self._publish)
        self._node.create_timer(self.period, self._publish)

    def _take(self, message: Any) -> None:
        if self._table is not None:
            self._table.take(message)

    def _publish(self) -> None:
        if self._table is None or not self._node.alive:
            return
        if self._delta > 0.0:
            self._table.sweep(self._delta)
        if not self._table.names:
            return
        try:
            self._publisher.publish(self._table.message(self._node.now()))
        except Crash as crash:
            self._end(crash)

    def _end(self, crash: Crash) -> None:
        if crash.last_line:
            self._print(f"{crash.last_line}\n")
        self._node.error(str(crash))
        self._exit(1)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Row:
    """One joint of the message: factor * the state of a free joint + offset."""

    name: str
    joint: FreeJoint | None
    """None if it has no range: then the original has nothing to say, and ends."""
    factor: float = 1.0
    offset: float = 0.0


class JointTable:
    """The joints, and the message about them.

    Args:
        joints: What was found in the robot.

    Raises:
        Crash: A chain of followers has no end, or ends at a joint that has no state.
    """

    def __init__(self, joints: RobotJoints) -> None:
        self.free = joints.free
        self._length = len(joints.free) + len(joints.followers)
        self._has_followers = bool(joints.followers)
        self._rows = tuple(_rows(joints))
        self._message_class: Any = message_class("sensor_msgs/JointState")

    @property
    def names(self) -> tuple[str, ...]:
        """Names in the message, in the order of the file."""
        return tuple(row.name for row in self._rows)

    def take(self, message: Any) -> None:
        """Take over the states of free joints in a JointState message."""
        for index, name in enumerate(message.name):
            joint = self.free.get(name)
            if joint is None:
                continue
            # An empty array changes nothing; one that is too short changes the first joints.
            if index < len(message.position):
                joint.position = message.position[index]
            if index < len(message.velocity):
                joint.velocity = message.velocity[index]
            if index < len(message.effort):
                joint.effort = message.effort[index]

    def sweep(self, delta: float) -> None:
        """Move each joint by `delta` [rad or m], to and fro in its range; continuous ones go round."""
        for joint in self.free.values():
            if joint.position is not None:
                _sweep(joint, joint.position, delta)

    def message(self, stamp: Time) -> Any:
        """The sensor_msgs/JointState of this moment.

        Raises:
            Crash: There is a joint without a range, or one of a name that stands twice.
        """
        message = self._message_class()
        message.header.stamp = stamp
        message.name = list(self.names)
        free = self.free.values()
        if self._has_followers or any(joint.position is not None for joint in free):
            message.position = self._column(
                lambda row, joint: (
                    None if joint.position is None else joint.position * row.factor + row.offset
                )
            )
        if any(joint.velocity is not None for joint in free):
            message.velocity = self._column(
                lambda row, joint: None if joint.velocity is None else joint.velocity * row.factor
            )
        if any(joint.effort is not None for joint in free):
            message.effort = self._column(lambda _, joint: joint.effort)
        return message

    def _column(self, value: Callable[[_Row, FreeJoint], float | None]) -> list[float]:
        # As long as the original makes it: with a follower that is in no file, longer than the names.
        column = [0.0] * self._length
        for index, row in enumerate(self._rows):
            if row.joint is None:
                raise Crash(
                    "TypeError: argument of type 'NoneType' is not iterable",
                    f"joint {row.name} has no range: <limit lower='...' upper='...' "
                    "effort='...' velocity='...'/>, or type='continuous'",
                )
            found = value(row, row.joint)
            if found is not None and index >= self._length:
                raise Crash(
                    "IndexError: list assignment index out of range",
                    f"two joints are named {row.name}; each needs a name of its own",
                )
            if found is not None:
                column[index] = found
        return column


def _rows(joints: RobotJoints) -> Iterator[_Row]:
    found: dict[str, _Row] = {name: _Row(name=name, joint=one) for name, one in joints.free.items()}
    for name in joints.names:
        if name not in found and name in joints.followers:
            _follow(name, joints, found)
        yield found.get(name) or _Row(name=name, joint=None)


def _follow(name: str, joints: RobotJoints, found: dict[str, _Row]) -> None:
    """Find what a joint follows, and what those between follow; each once."""
    chain = {name: joints.followers[name]}
    master = joints.followers[name].parent
    while master in joints.followers and master not in found:
        if master in chain:
            loop = ", ".join([*chain, master])
            raise Crash("", f"Found an infinite recursive mimic chain: [{loop}]")
        chain[master] = joints.followers[master]
        master = chain[master].parent
    for follower, rule in reversed(chain.items()):
        above = found.get(rule.parent)
        if above is None:
            raise _no_master(follower, rule)
        found[follower] = _Row(
            name=follower,
            joint=above.joint,
            factor=rule.factor * above.factor,
            offset=rule.offset + rule.factor * above.offset,
        )


def _no_master(name: str, follower: Follower) -> Crash:
    return Crash(
        f"KeyError: {follower.parent!r}",
        f"joint {name} follows {follower.parent!r}, but no joint of that name moves",
    )


def _sweep(joint: FreeJoint, position: float, delta: float) -> None:
    position += delta if joint.moves_up else -delta
    if joint.moves_up and position > joint.upper:
        joint.moves_up = joint.is_continuous
        position = joint.lower if joint.is_continuous else joint.upper
    elif not joint.moves_up and position < joint.lower:
        joint.moves_up = True
        position = joint.lower
    joint.position = position
