"""Controllers that hand on commands: for one joint, and for several."""

from __future__ import annotations

import math

import pytest

from tests.simkit.plugins.control.conftest import arm


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
