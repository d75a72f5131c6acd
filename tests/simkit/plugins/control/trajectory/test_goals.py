"""The action follow_joint_trajectory: goals reached, missed, cancelled, replaced and refused."""

from __future__ import annotations

import pytest

from simkit.msgs import Duration, Time, message_class
from tests.simkit.plugins.control.conftest import arm

JTC = "position_controllers/JointTrajectoryController"
ACTION = "control_msgs/FollowJointTrajectory"
NAMES = ["hip", "shoulder"]
ACTIVE, PREEMPTED, SUCCEEDED, ABORTED, REJECTED, RECALLED = 1, 2, 3, 4, 5, 8


class Client:
    """One who sends goals."""

    def __init__(self, bench):
        self.bench = bench
        self.space = "/arm/follow_joint_trajectory"
        self.results = bench.stage.listen(f"{self.space}/result", f"{ACTION}ActionResult")
        self.feedback = bench.stage.listen(f"{self.space}/feedback", f"{ACTION}ActionFeedback")
        self.statuses = bench.stage.listen(f"{self.space}/status", "actionlib_msgs/GoalStatusArray")

    def send(self, *points, name="g", names=NAMES, stamp_s=0.0, **fields):
        kind = message_class("trajectory_msgs/JointTrajectory")
        trajectory = kind(joint_names=list(names), points=list(points))
        goal = message_class(f"{ACTION}Goal")(trajectory=trajectory, **fields)
        goal_id = message_class("actionlib_msgs/GoalID")(
            id=name, stamp=Time.from_nsec(round(stamp_s * 1e9))
        )
        self.bench.tell(f"{self.space}/goal", f"{ACTION}ActionGoal", goal_id=goal_id, goal=goal)

    def cancel(self, name="", stamp_s=0.0):
        stamp = Time.from_nsec(round(stamp_s * 1e9))
        self.bench.tell(f"{self.space}/cancel", "actionlib_msgs/GoalID", id=name, stamp=stamp)

    def status(self, name="g"):
        """The last status of a goal; None if it is not listed."""
        found = [one.status for one in self.statuses[-1].status_list if one.goal_id.id == name]
        return found[0] if found else None

    def outcome(self):
        """Status, code and words of the last result."""
        last = self.results[-1]
        return last.status.status, last.result.error_code, last.result.error_string


def point(time_s, *positions, **more):
    return message_class("trajectory_msgs/JointTrajectoryPoint")(
        positions=list(positions), time_from_start=Duration.from_nsec(round(time_s * 1e9)), **more
    )


def tolerance(name, **values):
    return message_class("control_msgs/JointTolerance")(name=name, **values)


@pytest.fixture
def client(bench):
    """One who sends goals to a controller that runs, at 1 s."""
    bench.put(arm())
    assert bench.start("arm", JTC, joints=NAMES)
    found = Client(bench)
    bench.stage.run(1.0)
    return found


def blocked(bench, **parameters):
    """One who sends goals to an arm that cannot follow: its joints get no command."""
    bench.put(arm("EffortJointInterface"))
    kind = "effort_controllers/JointTrajectoryController"
    gains = {name: {"p": 0.0} for name in NAMES}
    assert bench.start("arm", kind, joints=NAMES, gains=gains, **parameters)
    return Client(bench)


def test_a_goal_is_reached(client):
    client.send(point(0.5, 0.1, -0.5))
    assert client.status() == ACTIVE
    client.bench.stage.run(0.4)
    assert client.results == []
    client.bench.stage.run(0.2)
    assert client.outcome() == (SUCCEEDED, 0, "")
    assert client.status() == SUCCEEDED
    assert client.bench.positions() == [0.1, -0.5]


def test_meanwhile_it_says_how_far_it_is(client):
    client.send(point(0.5, 0.1, -0.5))
    client.bench.stage.run(0.26)
    assert len(client.feedback) == 5, "20 times a second"
    last = client.feedback[-1]
    assert last.status.goal_id.id == "g"
    assert list(last.feedback.joint_names) == NAMES
    assert list(last.feedback.desired.positions) == pytest.approx([0.0498, -0.249])
    assert list(last.feedback.error.positions) == [0.0, 0.0]


def test_status_is_told_five_times_a_second_and_to_those_who_come_late(client):
    before = len(client.statuses)
    client.bench.stage.run(1.0)
    assert len(client.statuses) - before == 5
    late = client.bench.stage.listen(
        "/arm/follow_joint_trajectory/status", "actionlib_msgs/GoalStatusArray"
    )
    client.bench.stage.run(0.0)
    assert len(late) == 1


def test_a_goal_that_has_ended_is_forgotten_after_five_seconds(client):
    client.send(point(0.1, 0.1, 0.1))
    client.bench.stage.run(4.9)
    assert client.status() == SUCCEEDED
    client.bench.stage.run(0.6)
    assert client.status() is None


def test_a_new_goal_replaces_the_old_one(client):
    client.send(point(1.0, 1.0, 0.0), name="old")
    client.bench.stage.run(0.3)
    client.send(point(0.2, 0.0, 0.0), name="new")
    assert client.outcome()[0] == PREEMPTED
    assert (client.status("old"), client.status("new")) == (PREEMPTED, ACTIVE)
    client.bench.stage.run(0.4)
    assert client.results[-1].status.goal_id.id == "new"
    assert client.outcome()[0] == SUCCEEDED


def test_a_command_on_the_topic_replaces_a_goal(client):
    client.send(point(1.0, 1.0, 0.0))
    client.bench.stage.run(0.1)
    client.bench.tell(
        "/arm/command",
        "trajectory_msgs/JointTrajectory",
        joint_names=NAMES,
        points=[point(0.1, 0.5, 0.5)],
    )
    assert client.outcome()[0] == PREEMPTED
    client.bench.stage.run(0.3)
    assert client.bench.positions() == [0.5, 0.5]
    assert len(client.results) == 1


def test_a_refused_command_leaves_the_goal_alone(client):
    client.send(point(0.3, 1.0, 0.0))
    client.bench.tell("/arm/command", "trajectory_msgs/JointTrajectory", joint_names=["x"], points=[point(1.0, 0.0)])  # fmt: skip
    client.bench.stage.run(0.4)
    assert client.outcome()[0] == SUCCEEDED


@pytest.mark.parametrize(("name", "stamp_s"), [("g", 0.0), ("", 0.0), ("", 5.0)])
def test_a_goal_is_cancelled_by_name_with_all_or_by_time(client, name, stamp_s):
    client.send(point(1.0, 1.0, 0.0))
    client.bench.stage.run(0.3)
    here = client.bench.positions()
    client.cancel(name, stamp_s)
    assert client.outcome()[0] == PREEMPTED
    client.bench.stage.run(1.0)
    assert client.bench.positions() == here


def test_a_cancel_for_another_goal_changes_nothing(client):
    client.send(point(0.3, 1.0, 0.0))
    client.cancel("other")
    client.cancel("", 0.5)
    client.bench.stage.run(0.5)
    assert client.outcome()[0] == SUCCEEDED


def test_a_goal_can_be_cancelled_before_it_comes(client):
    client.cancel("g")
    client.send(point(0.3, 1.0, 0.0))
    assert client.outcome()[0] == RECALLED
    client.bench.stage.run(0.5)
    assert client.bench.positions() == [0.0, 0.0]


def test_a_goal_from_before_the_last_cancel_is_recalled(client):
    client.cancel("", 0.9)
    client.send(point(0.3, 1.0, 0.0), stamp_s=0.8)
    assert client.outcome()[0] == RECALLED
    assert "before the timestamp of the last cancel request" in client.results[-1].status.text


def test_a_goal_without_a_name_gets_one(client):
    client.send(point(0.1, 0.1, 0.0), name="")
    client.bench.stage.run(0.2)
    assert client.results[-1].status.goal_id.id == "/gazebo-1-1.000000000"
    assert client.results[-1].status.goal_id.stamp == Time(1)


def test_the_same_goal_counts_once(client):
    client.send(point(0.3, 1.0, 0.0))
    client.send(point(0.1, 5.0, 5.0))
    client.bench.stage.run(0.5)
    assert client.bench.positions() == [1.0, 0.0]
    assert len(client.results) == 1


@pytest.mark.parametrize(
    ("points", "names", "code", "text"),
    [
        ([point(1.0, 0.0)], ["hip"], -2, ""),
        ([point(1.0, 0.0, 0.0)], ["hip", "knee"], -2, ""),
        ([], [], -2, ""),
        (
            [point(1.0, 0.0, 0.0), point(0.5, 0.0, 0.0)],
            NAMES,
            -1,
            "Trajectory message contains waypoints that are not strictly increasing in time.",
        ),
        (
            [point(1.0, 0.0)],
            NAMES,
            -1,
            "Size mismatch in trajectory point position, velocity or acceleration data.",
        ),
    ],
)
def test_a_goal_that_cannot_be_followed_is_rejected(client, points, names, code, text):
    client.send(*points, names=names)
    assert client.outcome() == (REJECTED, code, text)
    assert client.bench.said()[-1].startswith("hint: ")


def test_one_that_does_not_run_rejects_goals(client):
    client.bench.switch(stop=["arm"])
    client.send(point(1.0, 0.0, 0.0))
    assert client.outcome() == (REJECTED, -1, "")
    assert client.bench.said()[-1] == "Can't accept new action goals. Controller is not running."


def test_a_stop_of_the_controller_ends_the_goal(client):
    client.send(point(1.0, 1.0, 0.0))
    client.bench.stage.run(0.1)
    client.bench.switch(stop=["arm"])
    assert client.outcome()[0] == PREEMPTED


def test_a_joint_too_far_from_its_path_aborts_the_goal(bench):
    constraints = {"hip": {"trajectory": 0.1}}
    client = blocked(bench, constraints=constraints)
    client.send(point(10.0, 0.0, 0.0))
    bench.stage.run(0.5)
    status, code, text = client.outcome()
    assert (status, code) == (ABORTED, -4)
    assert text.startswith("hip path error -0.1")


def test_a_goal_says_how_far_is_too_far(bench):
    client = blocked(bench)
    far = tolerance("shoulder", position=0.05)
    client.send(point(10.0, 0.0, 0.0), path_tolerance=[far])
    bench.stage.run(0.5)
    assert client.outcome()[:2] == (ABORTED, -4)
    assert client.outcome()[2].startswith("shoulder path error")


def test_a_goal_may_take_a_tolerance_away(bench):
    client = blocked(bench, constraints={"hip": {"trajectory": 0.01}})
    client.send(point(10.0, 0.0, 0.0), path_tolerance=[tolerance("hip", position=-1.0)])
    bench.stage.run(0.5)
    assert client.results == []


def test_joints_that_are_not_there_in_the_end_abort_the_goal(bench):
    client = blocked(bench, constraints={"hip": {"goal": 0.01}, "goal_time": 0.2})
    client.send(point(0.1, 1.0, 0.0))
    bench.stage.run(0.28)
    assert client.results == []
    bench.stage.run(0.1)
    status, code, text = client.outcome()
    assert (status, code) == (ABORTED, -5)
    assert text.startswith("hip goal error ")


def test_joints_must_be_at_rest_in_the_end(bench):
    client = blocked(bench)
    client.send(point(0.1, 0.0, 0.0))
    bench.stage.run(0.3)
    assert client.outcome()[:2] == (ABORTED, -5), "they fall"


def test_a_goal_may_wait_longer_for_its_end(bench):
    client = blocked(bench)
    client.send(point(0.1, 0.0, 0.0), goal_time_tolerance=Duration(5))
    bench.stage.run(1.0)
    assert client.results == []


def test_with_partial_goals_the_other_joints_count_as_there(bench):
    bench.put(arm())
    assert bench.start("arm", JTC, joints=NAMES, allow_partial_joints_goal=True)
    client = Client(bench)
    client.send(point(0.2, 0.3), names=["shoulder"])
    bench.stage.run(0.3)
    assert client.outcome()[0] == SUCCEEDED
    assert bench.positions() == [0.0, 0.3]
