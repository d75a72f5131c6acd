"""JointTrajectoryController: what joints do after a command, and what it says of one that it refuses."""

from __future__ import annotations

import math

import pytest

from simkit.graph import LogLevel, ServiceFailed
from simkit.msgs import Duration, Time, message_class
from tests.simkit.plugins.control.conftest import arm

JTC = "position_controllers/JointTrajectoryController"
STATE = "control_msgs/JointTrajectoryControllerState"
NAMES = ["hip", "shoulder"]


def point(time_s, *positions, **more):
    return message_class("trajectory_msgs/JointTrajectoryPoint")(
        positions=list(positions), time_from_start=Duration.from_nsec(round(time_s * 1e9)), **more
    )


def command(bench, *points, names=NAMES, stamp_s=0.0, topic="/arm/command"):
    header = message_class("std_msgs/Header")(stamp=Time.from_nsec(round(stamp_s * 1e9)))
    bench.tell(
        topic,
        "trajectory_msgs/JointTrajectory",
        header=header,
        joint_names=list(names),
        points=list(points),
    )


def follow(bench, steps):
    """The positions of hip after each of so many steps."""
    found = []
    for _ in range(steps):
        bench.stage.run(0.001)
        found.append(bench.joint("hip").position)
    return found


@pytest.fixture
def jtc(bench):
    """An arm with a controller that runs, at 1 s."""
    bench.put(arm())
    assert bench.start("arm", JTC, joints=NAMES)
    bench.stage.run(1.0)
    return bench


def test_it_holds_the_joints_where_they_are(jtc):
    assert jtc.positions() == [0.0, 0.0]
    jtc.stage.run(1.0)
    assert jtc.positions() == [0.0, 0.0]


def test_positions_are_followed_exactly_from_the_next_step_on(jtc):
    command(jtc, point(1.0, 0.1, -0.5))
    jtc.stage.run(0.001)
    assert jtc.positions() == [0.0, 0.0]
    for part in (0.25, 0.5, 1.0):
        jtc.stage.run(0.25 if part < 1.0 else 0.5)
        assert jtc.positions() == pytest.approx([0.1 * part, -0.5 * part], abs=1e-12)
    jtc.stage.run(1.0)
    assert jtc.positions() == [0.1, -0.5]


def test_a_motion_that_begins_and_ends_at_rest_is_a_cubic(jtc):
    rest = {"velocities": [0.0, 0.0]}
    command(jtc, point(2.0, 1.0, -1.0, **rest))
    jtc.stage.run(0.501)
    assert jtc.positions() == pytest.approx([0.15625, -0.15625], abs=1e-12)
    jtc.stage.run(0.5)
    assert jtc.positions() == pytest.approx([0.5, -0.5], abs=1e-12)


def test_with_accelerations_it_is_a_quintic(jtc):
    rest = {"velocities": [0.0, 0.0], "accelerations": [0.0, 0.0]}
    command(jtc, point(2.0, 1.0, -1.0, **rest))
    jtc.stage.run(0.501)
    assert jtc.positions() == pytest.approx([0.103515625, -0.103515625], abs=1e-12)


def test_names_may_stand_in_another_order(jtc):
    command(jtc, point(0.1, -0.5, 0.1), names=["shoulder", "hip"])
    jtc.stage.run(0.2)
    assert jtc.positions() == [0.1, -0.5]


def test_which_joint_goes_where_can_be_looked_up(jtc):
    command(jtc, point(0.1, -0.5, 0.1), names=["shoulder", "hip"])
    assert jtc.said(LogLevel.DEBUG)[-1] == "It ends with shoulder: -0.5, hip: 0.1"


def test_a_stamp_says_when_it_starts(jtc):
    command(jtc, point(0.1, 1.0, 1.0), stamp_s=1.2)
    jtc.stage.run(0.2)
    assert jtc.positions() == [0.0, 0.0]
    jtc.stage.run(0.05)
    assert jtc.positions() == pytest.approx([0.5, 0.5], abs=1e-12)


def test_a_new_command_begins_where_the_old_one_would_be(jtc):
    command(jtc, point(1.0, 1.0, 0.0))
    jtc.stage.run(0.501)
    command(jtc, point(0.5, 0.0, 0.0))
    found = follow(jtc, 3)
    assert found == pytest.approx([0.501, 0.501 * 0.998, 0.501 * 0.996], abs=1e-12)


def test_joints_that_turn_take_the_short_way(jtc):
    command(jtc, point(0.1, 0.25 * math.pi, 0.5 * math.pi))
    jtc.stage.run(0.2)
    command(jtc, point(0.5, 4.5 * math.pi, -1.75 * math.pi))
    jtc.stage.run(0.6)
    assert jtc.positions() == pytest.approx([0.5 * math.pi, 0.25 * math.pi], abs=1e-12)


def test_an_empty_command_holds(jtc):
    command(jtc, point(1.0, 1.0, 0.0))
    jtc.stage.run(0.3)
    here = jtc.positions()
    command(jtc)
    jtc.stage.run(0.5)
    assert jtc.positions() == here


def test_an_empty_command_comes_to_rest_on_a_ramp_if_it_shall(bench):
    bench.put(arm())
    assert bench.start("arm", JTC, joints=NAMES, stop_trajectory_duration=0.4)
    command(bench, point(1.0, 1.0, 0.0))
    bench.stage.run(0.5)
    command(bench)
    bench.stage.run(0.6)
    assert bench.joint("hip").position == pytest.approx(0.5 + 0.625 * 0.4, abs=1e-12)


def test_a_partial_command_moves_its_joints_if_that_is_allowed(bench):
    bench.put(arm())
    assert bench.start("arm", JTC, joints=NAMES, allow_partial_joints_goal=True)
    command(bench, point(1.0, 1.0, 2.0))
    bench.stage.run(0.501)
    command(bench, point(0.1, -1.0), names=["hip"])
    bench.stage.run(0.6)
    assert bench.positions() == [-1.0, 2.0]


@pytest.mark.parametrize(
    ("points", "names", "text", "hint"),
    [
        (
            [point(1.0, 0.1, 0.2), point(1.0, 0.3, 0.4)],
            NAMES,
            "Trajectory message contains waypoints that are not strictly increasing in time.",
            "points[1] comes at 1 s",
        ),
        (
            [point(1.0, 0.1)],
            ["hip"],
            "Cannot create trajectory from message. It does not contain the expected joints.",
            "lacks shoulder",
        ),
        (
            [point(1.0, 0.1)],
            NAMES,
            "Size mismatch in trajectory point position, velocity or acceleration data.",
            "points[0].positions has 1 number",
        ),
        (
            [point(1.0)],
            NAMES,
            "Quintic spline segment can't be constructed: Endpoint positions can't be empty.",
            "points[0] has no positions",
        ),
        (
            [point(0.0, 0.1, 0.2)],
            NAMES,
            "Dropping all 1 trajectory point(s), as they occur before the current time.\nLast point is "
            "0.000000s in the past.",
            "time_from_start is 0 s",
        ),
        ([point(1.0, math.nan, 0.2)], NAMES, "Trajectory message contains nan in points[0].positions, for hip.", ""),
    ],
)  # fmt: skip
def test_a_command_that_is_refused_changes_nothing_and_is_explained(jtc, points, names, text, hint):
    command(jtc, point(1.0, 1.0, 0.0))
    jtc.stage.run(0.501)
    command(jtc, *points, names=names)
    assert jtc.said()[-2] == text
    assert jtc.said()[-1].startswith("hint: ")
    assert hint in jtc.said()[-1]
    jtc.stage.run(1.0)
    assert jtc.positions() == [1.0, 0.0]


def test_the_start_of_a_late_command_is_dropped(jtc):
    command(jtc, point(0.4, 5.0, 5.0), point(1.0, 1.0, 1.0), stamp_s=0.501)
    assert jtc.said()[-1] == (
        "Dropping first 1 trajectory point(s) out of 2, as they occur before the current time.\n"
        "First valid point will be reached in 0.500s."
    )
    jtc.stage.run(0.501)
    assert jtc.positions() == [1.0, 1.0]


def test_one_that_does_not_run_takes_no_commands(jtc):
    jtc.switch(stop=["arm"])
    command(jtc, point(1.0, 1.0, 1.0))
    assert jtc.said()[-2] == "Can't accept new commands. Controller is not running."
    assert "controller_manager start arm" in jtc.said()[-1]


def test_the_state_is_published_at_its_rate(jtc):
    heard = jtc.stage.listen("/arm/state", STATE)
    command(jtc, point(1.0, 1.0, -1.0))
    jtc.stage.run(0.1)
    stamps = [one.header.stamp.to_sec() for one in heard]
    assert stamps == pytest.approx([1.001, 1.021, 1.041, 1.061, 1.081])
    last = heard[-1]
    assert list(last.joint_names) == NAMES
    assert list(last.desired.positions) == pytest.approx([0.08, -0.08])
    assert list(last.desired.velocities) == pytest.approx([1.0, -1.0])
    assert list(last.desired.accelerations) == [0.0, 0.0]
    assert list(last.actual.positions) == list(last.desired.positions)
    assert list(last.error.positions) == [0.0, 0.0]


def test_the_rate_of_the_state_is_a_parameter(bench):
    bench.put(arm())
    assert bench.start("arm", JTC, joints=NAMES, state_publish_rate=10)
    heard = bench.stage.listen("/arm/state", STATE)
    bench.stage.run(1.0)
    assert len(heard) == 9


def query(bench, time_s):
    kind = "control_msgs/QueryTrajectoryState"
    return bench.call("/arm/query_state", kind, time=Time.from_sec(time_s))


def test_it_can_be_asked_where_joints_will_be(jtc):
    command(jtc, point(1.0, 1.0, -2.0))
    answer = query(jtc, 1.501)
    assert list(answer.name) == NAMES
    assert list(answer.position) == pytest.approx([0.5, -1.0])
    assert list(answer.velocity) == pytest.approx([1.0, -2.0])
    assert list(query(jtc, 99.0).position) == [1.0, -2.0]


def test_it_does_not_know_of_a_time_before_its_trajectory_or_while_it_does_not_run(jtc):
    jtc.stage.run(0.1)
    command(jtc)
    with pytest.raises(ServiceFailed, match="before the beginning"):
        query(jtc, 0.5)
    jtc.switch(stop=["arm"])
    with pytest.raises(ServiceFailed, match="not running"):
        query(jtc, 2.0)
    assert jtc.said()[-1] == "Can't sample trajectory. Controller is not running."


@pytest.mark.parametrize(
    ("parameters", "text"),
    [
        ({}, "Could not find 'joints' parameter (namespace: /arm)."),
        ({"joints": "hip"}, "The 'joints' parameter is not an array (namespace: /arm)."),
        (
            {"joints": [1]},
            "The 'joints' parameter contains a non-string element (namespace: /arm).",
        ),
        ({"joints": ["hip", "knee"]}, "Could not find joint 'knee' in URDF model."),
        (
            {"joints": NAMES, "state_publish_rate": 0},
            "The parameter /arm/state_publish_rate must be a number above 0, not 0.",
        ),
    ],
)
def test_it_is_not_loaded_without_good_parameters(bench, parameters, text):
    bench.put(arm())
    assert not bench.start("arm", JTC, **parameters)
    assert text in bench.said()
    assert "Initializing controller 'arm' failed" in bench.said()


def test_it_is_not_loaded_without_a_robot(jtc):
    jtc.graph.params.delete("/robot_description")
    assert not jtc.start("other", JTC, joints=NAMES)
    assert "Failed to parse URDF contained in 'robot_description' parameter" in jtc.said()


def test_it_needs_joints_with_its_interface(bench):
    bench.put(arm("EffortJointInterface"))
    assert not bench.start("arm", JTC, joints=NAMES)
    assert bench.said()[-3:] == [
        "Could not find joint 'hip' in 'hardware_interface::PositionJointInterface'.",
        "Initializing controller 'arm' failed",
        "hint: the transmission of hip offers EffortJointInterface, and "
        "position_controllers/JointTrajectoryController needs PositionJointInterface: write "
        "hardware_interface/PositionJointInterface in the transmission, or type: "
        "effort_controllers/JointTrajectoryController in the YAML file",
    ]


GAINS = {"p": 100.0, "d": 5.0, "i": 50.0, "i_clamp": 20.0}


def test_with_efforts_gains_follow_the_trajectory(bench):
    bench.put(arm("EffortJointInterface"))
    kind = "effort_controllers/JointTrajectoryController"
    gains = {"hip": GAINS, "shoulder": GAINS}
    assert bench.start("arm", kind, joints=NAMES, gains=gains)
    rest = {"velocities": [0.0, 0.0]}
    command(bench, point(1.0, 0.3, -0.3, **rest))
    bench.stage.run(3.0)
    assert bench.positions() == pytest.approx([0.3, -0.3], abs=0.02)


def test_with_velocities_gains_follow_the_trajectory(bench):
    bench.put(arm("VelocityJointInterface"))
    kind = "velocity_controllers/JointTrajectoryController"
    gains = {name: {"p": 20.0} for name in NAMES}
    forward = dict.fromkeys(NAMES, 1.0)
    assert bench.start("arm", kind, joints=NAMES, gains=gains, velocity_ff=forward)
    command(bench, point(1.0, 0.3, -0.3))
    bench.stage.run(0.6)
    assert bench.positions() == pytest.approx([0.18, -0.18], abs=0.01)


def test_without_gains_it_hangs_and_that_is_explained(bench):
    bench.put(arm("EffortJointInterface"))
    kind = "effort_controllers/JointTrajectoryController"
    assert bench.start("arm", kind, joints=NAMES, gains={"hip": GAINS})
    assert bench.said(LogLevel.WARN)[-3:-1] == [
        "No p gain specified for pid.  Namespace: /arm/gains/shoulder",
        "Failed to initialize PID gains from ROS parameter server.",
    ]
    assert "shoulder has none: it gets no command" in bench.said()[-1]
    bench.stage.run(0.3)
    hip, shoulder = bench.positions()
    assert abs(hip) < abs(shoulder)


def test_positions_need_no_gains_and_nothing_red_is_said(jtc):
    assert jtc.said() == []


def test_a_start_anew_holds_where_the_joints_are(jtc):
    command(jtc, point(1.0, 1.0, 1.0))
    jtc.stage.run(0.501)
    jtc.switch(stop=["arm"])
    jtc.stage.run(0.2)
    jtc.switch(["arm"])
    jtc.stage.run(1.0)
    assert jtc.positions() == pytest.approx([0.5, 0.5], abs=1e-12)


def test_two_runs_give_the_same_bits(new_bench):
    def run():
        bench = new_bench()
        bench.put(arm("EffortJointInterface"))
        kind = "effort_controllers/JointTrajectoryController"
        assert bench.start("arm", kind, joints=NAMES, gains={"hip": GAINS, "shoulder": GAINS})
        heard = bench.stage.listen("/arm/state", STATE)
        command(bench, point(0.3, 0.3, -0.3), point(0.6, 0.1, 0.2))
        bench.stage.run(1.0)
        return [one.to_bytes() for one in heard]

    first = run()
    assert len(first) == 49
    assert run() == first
