"""Controllers with gains: they push joints to positions and velocities, and say how it goes."""

from __future__ import annotations

import pytest

from tests.simkit.plugins.control.conftest import arm

STATE = "control_msgs/JointControllerState"
PID = {"p": 100.0, "i": 50.0, "d": 10.0, "i_clamp": 30.0}
FLAT = {"axis": "0 0 1"}
"""Without gravity about the axes."""


def tell(bench, value):
    bench.tell("/c/command", "std_msgs/Float64", data=value)


def test_an_effort_brings_a_joint_to_a_position(bench):
    bench.put(arm("EffortJointInterface"))
    assert bench.start("c", "effort_controllers/JointPositionController", joint="hip", pid=PID)
    tell(bench, 0.4)
    bench.stage.run(3.0)
    assert bench.joint("hip").position == pytest.approx(0.4, abs=0.05)


def test_it_holds_a_joint_where_it_is_when_it_starts(bench):
    bench.put(arm("EffortJointInterface", **FLAT))
    bench.joint("hip").set_position(0.3)
    assert bench.start("c", "effort_controllers/JointPositionController", joint="hip", pid=PID)
    bench.stage.run(0.2)
    assert bench.joint("hip").position == pytest.approx(0.3, abs=1e-6)


def test_a_joint_that_turns_takes_the_short_way(bench):
    bench.put(arm("EffortJointInterface", **FLAT))
    gains = {"p": 20.0, "d": 5.0}
    assert bench.start("c", "effort_controllers/JointPositionController", joint="hip", pid=gains)
    tell(bench, 6.0)
    bench.stage.run(0.2)
    assert bench.joint("hip").position < 0.0


def test_a_joint_with_limits_is_told_nothing_beyond_them(bench):
    limit = '<limit effort="1000" velocity="100" lower="-0.2" upper="0.2"/>'
    bench.put(arm("EffortJointInterface", kind="revolute", limit=limit, **FLAT))
    heard = bench.stage.listen("/c/state", STATE)
    assert bench.start("c", "effort_controllers/JointPositionController", joint="hip", pid=PID)
    tell(bench, 5.0)
    bench.stage.run(0.05)
    assert heard[-1].set_point == 0.2


def test_an_effort_brings_a_joint_to_a_velocity(bench):
    bench.put(arm("EffortJointInterface", **FLAT))
    kind = "effort_controllers/JointVelocityController"
    assert bench.start("c", kind, joint="hip", pid={"p": 5.0})
    tell(bench, 0.5)
    bench.stage.run(0.5)
    assert bench.joint("hip").velocity == pytest.approx(0.5, rel=0.05)


def test_a_velocity_brings_a_joint_to_a_position(bench):
    bench.put(arm("VelocityJointInterface"))
    kind = "velocity_controllers/JointPositionController"
    assert bench.start("c", kind, joint="hip", pid={"p": 10.0})
    tell(bench, 0.5)
    bench.stage.run(1.0)
    assert bench.joint("hip").position == pytest.approx(0.5, abs=0.01)


def test_a_group_brings_each_joint_to_its_position(bench):
    bench.put(arm("EffortJointInterface"))
    kind = "effort_controllers/JointGroupPositionController"
    gains = {"pid": {"p": 100.0, "d": 5.0, "i": 50.0, "i_clamp": 30.0}}
    names = ["hip", "shoulder"]
    assert bench.start("c", kind, joints=names, hip=gains, shoulder=gains)
    bench.tell("/c/command", "std_msgs/Float64MultiArray", data=[0.3, -0.2])
    bench.stage.run(3.0)
    assert bench.positions() == pytest.approx([0.3, -0.2], abs=0.05)


def test_it_says_every_ten_steps_what_is_wanted_and_what_is(bench):
    bench.put(arm("EffortJointInterface", **FLAT))
    heard = bench.stage.listen("/c/state", STATE)
    pid = {**PID, "antiwindup": True}
    assert bench.start("c", "effort_controllers/JointPositionController", joint="hip", pid=pid)
    tell(bench, 0.1)
    bench.stage.run(0.031)
    assert [one.header.stamp.to_nsec() // 10**6 for one in heard] == [1, 11, 21, 31]
    last = heard[-1]
    assert last.set_point == 0.1
    assert last.process_value == bench.joint("hip").position
    assert last.process_value_dot == bench.joint("hip").velocity
    assert last.time_step == pytest.approx(0.001)
    assert last.command == pytest.approx(bench.joint("hip").effort)
    assert (last.p, last.i, last.d, last.i_clamp, last.antiwindup) == (
        100.0,
        50.0,
        10.0,
        30.0,
        True,
    )


@pytest.mark.parametrize(
    ("kind", "parameters", "text"),
    [
        (
            "JointPositionController",
            {"joint": "hip"},
            "No p gain specified for pid.  Namespace: /c/pid",
        ),
        (
            "JointVelocityController",
            {"joint": "hip"},
            "No p gain specified for pid.  Namespace: /c/pid",
        ),
        (
            "JointGroupPositionController",
            {"joints": ["hip"]},
            "No p gain specified for pid.  Namespace: /c/hip/pid",
        ),
        ("JointPositionController", {"pid": PID}, "No joint given (namespace: /c)"),
    ],
)
def test_it_is_not_loaded_without_joint_and_gains(bench, kind, parameters, text):
    bench.put(arm("EffortJointInterface"))
    assert not bench.start("c", f"effort_controllers/{kind}", **parameters)
    assert text in bench.said()
    assert bench.said()[-1].startswith("hint: ")
