"""The node joint_state_publisher: says at a fixed rate where each joint stands."""

from __future__ import annotations

from typing import Any

from simkit.graph import Node
from simkit.msgs import Duration, message_class
from simkit.nodes.joint_state_publisher.joints import read_joints
from simkit.nodes.joint_state_publisher.settings import Crash, SliderSettings, read_settings
from simkit.nodes.joint_state_publisher.table import JointTable
from simkit.nodes.program import Program


class JointStatePublisher(Program):
    """The program `joint_state_publisher` of the package of that name.

    It reads the robot once, at its start. If it cannot, it prints the last line of the traceback
    that the original ends with, says on rosout what to do, and leaves with exit code 1.

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
        # The first message belongs to the start; whoever starts at this instant hears it too.
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
        if crash.said:
            self._print(f"{crash.said}\n")
        self._node.error(str(crash))
        self._exit(1)
