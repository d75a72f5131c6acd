"""JointTrajectoryController: joints follow trajectories, all of them together.

Source: joint_trajectory_controller `JointTrajectoryController`, texts and order.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from simkit.graph import LogLevel, ServiceFailed
from simkit.msgs import message_class, service_class
from simkit.plugins.control.action_server import ActionServer, ServerGoal
from simkit.plugins.control.angles import shortest_angular_distance
from simkit.plugins.control.controller import Controller, Due, stamp
from simkit.plugins.control.place import ControllerPlace
from simkit.plugins.control.trajectory import goals
from simkit.plugins.control.trajectory.adapter import make_adapter
from simkit.plugins.control.trajectory.command import TrajectoryCommand, TrajectoryRefused
from simkit.plugins.control.trajectory.reading import fill_states, read_command, read_tolerances
from simkit.plugins.control.trajectory.replacement import (
    ControlledJoints,
    Instant,
    hold,
    replace_trajectories,
    stop,
)
from simkit.plugins.control.trajectory.segment import Trajectory, find_segment, sample
from simkit.plugins.control.trajectory.settings import read_settings
from simkit.plugins.control.trajectory.spline import State

_NO_JOINT = "Could not find joint '{joint}' in '{interface}'."
_ACTION = "control_msgs/FollowJointTrajectory"
_STATE = "control_msgs/JointTrajectoryControllerState"


class JointTrajectoryController(Controller):
    """The controller. Its clock, the uptime, is 0 when it is started.

    Args:
        place: Its parameters, joints and topics.

    Raises:
        InitError: Its parameters do not fit the robot.
    """

    def __init__(self, place: ControllerPlace) -> None:
        super().__init__(place)
        settings = read_settings(place)
        self._settings = settings
        self._joints: ControlledJoints = settings.joints
        self.claims = self._joints.names
        self._handles = [place.joint(name, _NO_JOINT) for name in self.claims]
        self._adapter = make_adapter(place, self._handles)
        self._due = Due(settings.state_publish_rate)
        self._says_state = False
        self._time_ns = self._uptime_ns = self._period_ns = 0
        self._trajectories: list[Trajectory] = []
        self._desired = self._actual = self._error = [State() for _ in self.claims]
        self._state = place.advertise("state", message_class(_STATE))
        place.subscribe("command", message_class("trajectory_msgs/JointTrajectory"), self._hear)
        self._server = ActionServer(
            place,
            "follow_joint_trajectory",
            _ACTION,
            on_goal=self._hear_goal,
            on_cancel=self._hear_cancel,
        )
        self._goals = goals.Goals(place, self._server, self.claims, settings.action_monitor_rate)
        query = service_class("control_msgs/QueryTrajectoryState")
        place.advertise_service("query_state", query, self._answer)

    def starting(self, time_ns: int) -> None:
        """Hold the joints where they are."""
        self._time_ns, self._uptime_ns, self._period_ns = time_ns, 0, 0
        self._desired = [State(one.position, one.velocity) for one in self._handles]
        self._hold()
        self._due.begin(0)
        self._adapter.starting()

    def stopping(self, time_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Give up the goal, if there is one."""
        self._goals.give_up()

    def update(self, time_ns: int, period_ns: int) -> None:
        """Command what the trajectory wants at a time [ns]."""
        self._time_ns, self._period_ns = time_ns, period_ns
        self._uptime_ns += period_ns
        self._desired = [sample(one, self._uptime_ns) for one in self._trajectories]
        self._compare()
        if self._goals.active is not None:
            self._look()
        self._adapter.command(self._desired, self._error, period_ns * 1e-9)

    def is_due(self, time_ns: int) -> bool:  # noqa: ARG002 - the form of Controller
        """A message, or what a goal is told."""
        self._says_state = self._due.at(self._uptime_ns)
        return self._says_state or self._goals.active is not None

    def publish(self, time_ns: int) -> None:
        """Say what is desired and what is."""
        self._compare()
        self._goals.note(time_ns, self._desired, self._actual, self._error)
        if self._says_state:
            message: Any = message_class(_STATE)()
            message.header.stamp, message.joint_names = stamp(time_ns), list(self.claims)
            fill_states(message, self._desired, self._actual, self._error)
            self._state.publish(message)

    def _compare(self) -> None:
        self._actual = [State(one.position, one.velocity) for one in self._handles]
        self._error = [
            State(
                shortest_angular_distance(actual.position, desired.position),
                desired.velocity - actual.velocity,
            )
            for actual, desired in zip(self._actual, self._desired, strict=True)
        ]

    def _look(self) -> None:
        segments = [one[max(0, find_segment(one, self._uptime_ns))] for one in self._trajectories]
        ends_ns = [one[-1].end_ns for one in self._trajectories]
        self._goals.look(segments, self._uptime_ns, self._error, ends_ns)

    def _hold(self) -> None:
        """Come to rest."""
        self.place.hardware.read()
        duration_ns = self._settings.stop_ns
        if duration_ns:
            self._trajectories = [stop(one, self._uptime_ns, duration_ns) for one in self._desired]
        else:
            self._trajectories = [hold(one.position, self._uptime_ns) for one in self._handles]

    def _hear(self, message: Any) -> None:
        """A command has come on the topic."""
        if self._follow(read_command(message)) is None:
            self._goals.give_up()

    def _follow(
        self, command: TrajectoryCommand, goal: ServerGoal | None = None
    ) -> TrajectoryRefused | None:
        """Follow a command from now on; why not, if it is refused."""
        try:
            self._replace(command, goal)
        except TrajectoryRefused as refusal:
            level = LogLevel.WARN if refusal.is_late else LogLevel.ERROR
            self.place.node.log(level, str(refusal))
            if refusal.hint:
                self.place.node.warn(f"hint: {refusal.hint}")
            return refusal
        return None

    def _replace(self, command: TrajectoryCommand, goal: ServerGoal | None) -> None:
        if not self.is_running:
            raise TrajectoryRefused(
                "Can't accept new commands. Controller is not running.",
                hint="start it: rosrun controller_manager controller_manager start "
                + self.place.name,
            )
        if not command.points:
            self._hold()
            return
        joints = self._joints
        if goal is not None:
            tolerances = read_tolerances(goal.goal, joints.names, joints.tolerances)
            joints = replace(joints, tolerances=tolerances)
        now = Instant(
            time_ns=self._time_ns + self._period_ns, uptime_ns=self._uptime_ns + self._period_ns
        )
        found = replace_trajectories(self._trajectories, command, joints, now, goal=goal)
        self._trajectories = list(found.trajectories)
        self.place.node.debug(f"It ends with {_table(command)}")
        if found.dropped:
            self.place.node.warn(
                f"Dropping first {found.dropped} trajectory point(s) out of {len(command.points)}, as "
                "they occur before the current time.\nFirst valid point will be reached in "
                f"{found.first_in_s:.3f}s."
            )

    def _hear_goal(self, goal: ServerGoal) -> None:
        if not self.is_running:
            self.place.node.error("Can't accept new action goals. Controller is not running.")
            self._reject(goal, goals.INVALID_GOAL, "")
            return
        command = read_command(goal.goal.trajectory)
        if not self._fits(command):
            text = "Joints on incoming goal don't match the controller joints."
            self.place.node.error(text)
            self.place.node.warn(f"hint: the controller moves: {', '.join(self.claims)}")
            self._reject(goal, goals.INVALID_JOINTS, "")
            return
        refusal = self._follow(command, goal)
        if refusal is None:
            self._goals.begin(goal)
        else:
            self._reject(goal, goals.INVALID_GOAL, str(refusal))

    def _fits(self, command: TrajectoryCommand) -> bool:
        """Whether a goal names the right joints."""
        names = set(command.joints)
        is_whole = len(command.joints) == len(self.claims)
        is_allowed = is_whole or (self._joints.allow_partial and bool(names))
        return is_allowed and names <= set(self.claims)

    def _reject(self, goal: ServerGoal, code: int, text: str) -> None:
        result = self._server.result()
        result.error_code, result.error_string = code, text
        self._server.reject(goal, result)

    def _hear_cancel(self, goal: ServerGoal) -> None:
        if self._goals.active is goal:
            self._hold()
            self._goals.give_up()

    def _answer(self, request: Any) -> Any:
        """What is desired at a time."""
        if not self.is_running:
            self.place.node.error("Can't sample trajectory. Controller is not running.")
            raise ServiceFailed("the controller is not running")
        uptime_ns = self._uptime_ns + request.time.to_nsec() - self._time_ns
        if any(find_segment(one, uptime_ns) < 0 for one in self._trajectories):
            self.place.node.error("Requested sample time precedes trajectory start time.")
            raise ServiceFailed("the time is before the beginning of the trajectory")
        states = [sample(one, uptime_ns) for one in self._trajectories]
        found = service_class("control_msgs/QueryTrajectoryState")
        response: Any = found._response_class()
        response.name = list(self.claims)
        response.position = [one.position for one in states]
        response.velocity = [one.velocity for one in states]
        response.acceleration = [one.acceleration for one in states]
        return response


def _table(command: TrajectoryCommand) -> str:
    """Which joint goes where in the end, to be compared with what was meant."""
    ends = zip(command.joints, command.points[-1].positions, strict=True)
    return ", ".join(f"{name}: {position:g}" for name, position in ends)
