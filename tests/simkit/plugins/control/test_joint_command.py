"""Controllers that follow the newest command: forwarded, or by gains; for one joint, and for several."""

from __future__ import annotations

import math

import pytest

from tests.simkit.plugins.control.conftest import arm

STATE = "control_msgs/JointControllerState"
PID = {"p": 100.0, "i": 50.0, "d": 10.0, "i_clamp": 30.0}
FLAT = {"axis": "0 0 1"}
"""Without gravity about the axes."""


def tell(bench, value):
    bench.tell("/c/command", "std_msgs/Float64", data=value)


def tell_all(bench, *values):
    bench.tell("/c/command", "std_msgs/Float64MultiArray", data=list(values))


def test_a_position_is_handed_on(bench):
    bench.put(arm())
    assert bench.start("c", "position_controllers/JointPositionController", joint="shoulder")
    tell(bench, 0.05)
    bench.stage.run(0.01)
    assert bench.positions() == [0.0, 0.05]


def test_a_velocity_is_handed_on(bench):
    bench.put(arm("VelocityJointInterface"))
    assert bench.start("c", "velocity_controllers/JointVelocityController", joint="hip")
    tell(bench, 0.4)
    bench.stage.run(0.5)
    assert bench.joint("hip").velocity == pytest.approx(0.4, abs=1e-3)


def test_an_effort_is_handed_on(bench):
    bench.put(arm("EffortJointInterface"))
    assert bench.start("c", "effort_controllers/JointEffortController", joint="hip")
    tell(bench, -2.5)
    bench.stage.run(0.01)
    assert bench.joint("hip").effort == -2.5


def test_positions_begin_where_the_joints_are_and_efforts_at_0(bench):
    bench.put(arm())
    kind = "position_controllers/JointPositionController"
    assert bench.start("c", kind, joint="hip")
    tell(bench, 0.07)
    bench.stage.run(0.01)
    bench.switch(stop=["c"])
    bench.switch(["c"])
    bench.stage.run(0.1)
    assert bench.positions() == [0.07, 0.0]


@pytest.mark.parametrize(
    ("interface", "kind"),
    [
        ("PositionJointInterface", "position_controllers/JointGroupPositionController"),
        ("VelocityJointInterface", "velocity_controllers/JointGroupVelocityController"),
        ("EffortJointInterface", "effort_controllers/JointGroupEffortController"),
    ],
)
def test_a_group_hands_on_one_number_for_each_joint_in_its_order(bench, interface, kind):
    bench.put(arm(interface))
    assert bench.start("c", kind, joints=["shoulder", "hip"])
    tell_all(bench, 0.01, -0.02)
    bench.stage.run(0.002)
    drives = bench.plugin.manager.hardware.drives
    assert drives["shoulder"].handle.command == 0.01
    assert drives["hip"].handle.command == -0.02


def test_a_group_refuses_too_many_numbers(bench):
    bench.put(arm())
    kind = "position_controllers/JointGroupPositionController"
    assert bench.start("c", kind, joints=["hip", "shoulder"])
    tell_all(bench, 0.1, 0.2, 0.3)
    bench.stage.run(0.01)
    assert bench.said() == [
        "Dimension of command (3) does not match number of joints (2)! Not executing!",
        "hint: data must have one number for each of hip, shoulder",
    ]
    assert bench.positions() == [0.0, 0.0]


@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_what_is_no_number_is_refused(bench, value):
    bench.put(arm())
    assert bench.start("c", "position_controllers/JointPositionController", joint="hip")
    tell(bench, value)
    bench.stage.run(0.01)
    assert "which is no number" in bench.said()[-1]
    assert bench.positions() == [0.0, 0.0]


def test_no_number_is_too_large(bench):
    bench.put(arm())
    assert bench.start("c", "position_controllers/JointPositionController", joint="hip")
    tell(bench, 1e300)
    bench.stage.run(0.01)
    assert math.isfinite(bench.joint("hip").position)


@pytest.mark.parametrize(
    ("kind", "parameters", "text"),
    [
        ("JointPositionController", {}, "No joint given (namespace: /c)"),
        ("JointGroupPositionController", {}, "Failed to getParam 'joints' (namespace: /c)."),
        ("JointPositionController", {"joint": "knee"}, "Could not find resource 'knee'"),
        ("JointGroupPositionController", {"joints": ["knee"]}, "Could not find resource 'knee'"),
        ("JointGroupPositionController", {"joints": ["hip", "hip"]}, "names 'hip' twice"),
        ("JointGroupPositionController", {"joints": []}, "is empty"),
    ],
)
def test_it_is_not_loaded_without_good_joints(bench, kind, parameters, text):
    bench.put(arm())
    assert not bench.start("c", f"position_controllers/{kind}", **parameters)
    assert any(text in one for one in bench.said())
    assert "Initializing controller 'c' failed" in bench.said()


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
