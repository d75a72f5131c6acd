"""JointTrajectoryController: joints follow trajectories, all of them together.

Source: joint_trajectory_controller `JointTrajectoryController`, texts and order.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from simkit.graph import LogLevel, ServiceFailed
from simkit.msgs import Time, message_class, service_class
from simkit.plugins.control.action_server import ServerGoal
from simkit.plugins.control.angles import shortest_angular_distance
from simkit.plugins.control.controller import Controller, PublishClock
from simkit.plugins.control.pid import NO_GAIN, Gains, Pid, read_gains
from simkit.plugins.control.registry import POSITION
from simkit.plugins.control.trajectory.command import (
    TrajectoryCommand,
    TrajectoryRefused,
    read_command,
)
from simkit.plugins.control.trajectory.goals import Goals, fill_states
from simkit.plugins.control.trajectory.replacement import Instant, replace_trajectories
from simkit.plugins.control.trajectory.segment import (
    State,
    Trajectory,
    find_segment,
    hold,
    sample,
    stop,
)
from simkit.plugins.control.trajectory.settings import goal_tolerances, settings_of

_NO_JOINT = "Could not find joint '{joint}' in '{interface}'."
_STATE = "control_msgs/JointTrajectoryControllerState"
_QUERY = "control_msgs/QueryTrajectoryState"


class JointTrajectoryController(Controller):
    """The controller. Its clock, the uptime, is 0 when it is started."""

    def init(self) -> None:
        """Take the joints, and the gains if they are commanded by velocity or effort.

        Raises:
            InitError: Its parameters do not fit the robot.
        """
        self._settings = settings_of(self)
        self.claims = self._settings.joints.names
        self._handles = [self.joint(name, _NO_JOINT) for name in self.claims]
        self._pids: list[Pid] = []
        if self.type.interface != POSITION:
            self._pids = [self._pid(name) for name in self.claims]
            self._forward = [self.number(f"velocity_ff/{name}", 0.0) for name in self.claims]
        self._clock = PublishClock(self._settings.state_publish_rate)
        self._is_state_due = False
        self._time_ns = self._uptime_ns = self._period_ns = 0
        self._trajectories: list[Trajectory] = []
        self._desired = self._actual = self._error = [State() for _ in self.claims]
        self._state = self.advertise("state", message_class(_STATE))
        kind = message_class("trajectory_msgs/JointTrajectory")
        self.subscribe("command", kind, self._on_command)
        self._goals = Goals(self, self._settings, follow=self._follow, hold=self._hold)
        self.advertise_service("query_state", service_class(_QUERY), self._on_query)

    def starting(self, time_ns: int) -> None:
        """Hold the joints where they are."""
        self._time_ns, self._uptime_ns, self._period_ns = time_ns, 0, 0
        self._desired = [State(one.position, one.velocity) for one in self._handles]
        self._hold()
        self._clock.begin(0)
        for pid in self._pids:
            pid.reset()
        for joint in self._handles:
            joint.command = 0.0 if self._pids else joint.position

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
            self._check_goal()
        for number, joint in enumerate(self._handles):
            joint.command = self._command(number, period_ns * 1e-9)

    def is_due(self, time_ns: int) -> bool:  # noqa: ARG002 - the form of Controller
        """A message of the state, or the feedback of a goal."""
        self._is_state_due = self._clock.is_due(self._uptime_ns)
        return self._is_state_due or self._goals.active is not None

    def publish(self, time_ns: int) -> None:
        """Publish what is desired and what is."""
        self._compare()
        self._goals.keep_feedback(time_ns, self._desired, self._actual, self._error)
        if self._is_state_due:
            message: Any = message_class(_STATE)()
            message.header.stamp, message.joint_names = Time.from_nsec(time_ns), list(self.claims)
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

    def _command(self, number: int, period_s: float) -> float:
        """What the joint of that number is commanded: its position, or what makes its error small."""
        desired, error = self._desired[number], self._error[number]
        if not self._pids:
            return desired.position
        push = self._pids[number].command(error.position, period_s, rate=error.velocity)
        return desired.velocity * self._forward[number] + push

    def _check_goal(self) -> None:
        segments = [one[max(0, find_segment(one, self._uptime_ns))] for one in self._trajectories]
        ends_ns = [one[-1].end_ns for one in self._trajectories]
        self._goals.check(segments, self._uptime_ns, self._error, ends_ns)

    def _hold(self) -> None:
        """Come to rest."""
        self.hardware.read()
        duration_ns = self._settings.stop_ns
        if duration_ns:
            self._trajectories = [stop(one, self._uptime_ns, duration_ns) for one in self._desired]
        else:
            self._trajectories = [hold(one.position, self._uptime_ns) for one in self._handles]

    def _on_command(self, message: Any) -> None:
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
            self.node.log(level, str(refusal))
            if refusal.hint:
                self.node.warn(f"hint: {refusal.hint}")
            return refusal
        return None

    def _replace(self, command: TrajectoryCommand, goal: ServerGoal | None) -> None:
        if not self.is_running:
            raise TrajectoryRefused(
                "Can't accept new commands. Controller is not running.",
                hint="start it: rosrun controller_manager controller_manager start " + self.name,
            )
        if not command.points:
            self._hold()
            return
        joints = self._settings.joints
        if goal is not None:
            tolerances = goal_tolerances(goal.goal, joints.names, joints.tolerances)
            joints = replace(joints, tolerances=tolerances)
        now = Instant(
            time_ns=self._time_ns + self._period_ns, uptime_ns=self._uptime_ns + self._period_ns
        )
        found = replace_trajectories(self._trajectories, command, joints, now, goal=goal)
        self._trajectories = list(found.trajectories)
        self.node.debug(f"It ends with {_table(command)}")
        if found.dropped:
            self.node.warn(
                f"Dropping first {found.dropped} trajectory point(s) out of {len(command.points)}, as "
                "they occur before the current time.\nFirst valid point will be reached in "
                f"{found.first_in_s:.3f}s."
            )

    def _on_query(self, request: Any) -> Any:
        """What is desired at a time."""
        if not self.is_running:
            self.node.error("Can't sample trajectory. Controller is not running.")
            raise ServiceFailed("the controller is not running")
        uptime_ns = self._uptime_ns + request.time.to_nsec() - self._time_ns
        if any(find_segment(one, uptime_ns) < 0 for one in self._trajectories):
            self.node.error("Requested sample time precedes trajectory start time.")
            raise ServiceFailed("the time is before the beginning of the trajectory")
        states = [sample(one, uptime_ns) for one in self._trajectories]
        response: Any = service_class(_QUERY)._response_class()
        response.name = list(self.claims)
        response.position = [one.position for one in states]
        response.velocity = [one.velocity for one in states]
        response.acceleration = [one.acceleration for one in states]
        return response

    def _pid(self, joint: str) -> Pid:
        namespace = f"{self.namespace}/gains/{joint}"
        gains = read_gains(self.node.graph.params, namespace)
        if gains is None:
            self.node.error(NO_GAIN.format(namespace=namespace))
            self.node.warn("Failed to initialize PID gains from ROS parameter server.")
            self.node.warn(
                f"hint: {self.type.name} makes commands by gains, and {joint} has none: it gets no command; "
                f"write gains: {{{joint}: {{p: 100.0, i: 0.01, d: 10.0}}}} in the YAML file, and try out the "
                "numbers"
            )
        return Pid(gains or Gains(p=0.0))


def _table(command: TrajectoryCommand) -> str:
    """Which joint goes where in the end, to be compared with what was meant."""
    ends = zip(command.joints, command.points[-1].positions, strict=True)
    return ", ".join(f"{name}: {position:g}" for name, position in ends)
