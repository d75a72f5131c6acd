"""The controller manager: loading, switching, lists, and what it says when it refuses."""

from __future__ import annotations

import pytest

from simkit.plugins.control.registry import CONTROLLER_TYPES
from tests.simkit.plugins.control.conftest import arm

GROUP = "position_controllers/JointGroupPositionController"
BEST_EFFORT, STRICT = 1, 2
HIP = {"type": GROUP, "joints": ["hip"]}
BOTH = {"type": GROUP, "joints": ["hip", "shoulder"]}


@pytest.fixture
def arm_bench(bench):
    bench.put(arm(), a=HIP, b={"type": GROUP, "joints": ["shoulder"]}, both=BOTH)
    return bench


def test_a_controller_is_loaded_started_stopped_and_unloaded(arm_bench):
    assert arm_bench.load("a")
    assert arm_bench.states() == {"a": "initialized"}
    assert arm_bench.switch(["a"])
    assert arm_bench.states() == {"a": "running"}
    assert arm_bench.switch(stop=["a"])
    assert arm_bench.states() == {"a": "stopped"}
    assert arm_bench.unload("a")
    assert arm_bench.states() == {}


def test_the_list_says_type_interface_and_joints(arm_bench):
    arm_bench.load("both")
    kind = "controller_manager_msgs/ListControllers"
    (one,) = arm_bench.call("/controller_manager/list_controllers", kind).controller
    (claim,) = one.claimed_resources
    assert one.type == GROUP
    assert claim.hardware_interface == "hardware_interface::PositionJointInterface"
    assert list(claim.resources) == ["hip", "shoulder"]


def test_a_controller_is_loaded_once(arm_bench):
    arm_bench.load("a")
    assert not arm_bench.load("a")
    assert arm_bench.said()[-1] == (
        "A controller named 'a' was already loaded inside the controller manager"
    )


def test_a_controller_without_parameters_is_refused_with_the_near_name(arm_bench):
    arm_bench.graph.params.set("/arm_controller", HIP)
    assert not arm_bench.load("arm_controler")
    assert arm_bench.said()[-2] == (
        "Could not load controller 'arm_controler' because the type was not specified. Did you load the "
        "controller configuration on the parameter server (namespace: '/arm_controler')?"
    )
    assert arm_bench.said()[-1].startswith("hint: there are parameters for arm_controller")


def test_a_type_that_there_is_not_is_refused_with_the_near_one(arm_bench):
    arm_bench.graph.params.set("/c", {"type": "position_controller/JointTrajectoryController"})
    assert not arm_bench.load("c")
    assert arm_bench.said()[-3:] == [
        "Could not load controller 'c' because controller type "
        "'position_controller/JointTrajectoryController' does not exist.",
        "Use 'rosservice call controller_manager/list_controller_types' to get the available types",
        "hint: did you mean position_controllers/JointTrajectoryController?",
    ]


@pytest.mark.parametrize(
    ("type_name", "joints", "hint"),
    [
        ("effort_controllers/JointTrajectoryController", ["hip"], "the transmission of hip offers PositionJointInterface"),
        ("position_controllers/JointTrajectoryController", ["hipp"], "did you mean hip?"),
    ],
)  # fmt: skip
def test_three_places_must_agree(arm_bench, type_name, joints, hint):
    arm_bench.graph.params.set("/c", {"type": type_name, "joints": joints})
    assert not arm_bench.load("c")
    assert arm_bench.said()[-2] == "Initializing controller 'c' failed"
    assert hint in arm_bench.said()[-1]


def test_a_joint_without_transmission_is_named(bench):
    bench.put(arm().replace('<joint name="shoulder"><hardware', '<joint name="nobody"><hardware'))
    bench.graph.params.set("/c", {"type": GROUP, "joints": ["shoulder"]})
    assert not bench.load("c")
    text = "Could not find resource 'shoulder' in 'hardware_interface::PositionJointInterface'."
    assert text in bench.said()[-3]
    assert "no transmission is for shoulder: add a <transmission>" in bench.said()[-1]


@pytest.mark.parametrize("family", ["pos_vel", "pos_vel_acc"])
def test_gazebo_has_no_joints_for_positions_with_velocities(arm_bench, family):
    interface = {"pos_vel": "PosVel", "pos_vel_acc": "PosVelAcc"}[family]
    kind = f"{family}_controllers/JointTrajectoryController"
    assert not arm_bench.start("c", kind, joints=["hip"])
    assert arm_bench.said()[-3:-1] == [
        "This controller requires a hardware interface of type "
        f"'hardware_interface::{interface}JointInterface'. Make sure this is registered in the "
        "hardware_interface::RobotHW class.",
        "Initializing controller 'c' failed",
    ]
    assert "position_controllers/JointTrajectoryController" in arm_bench.said()[-1]


@pytest.mark.parametrize("name", ["my arm", "", "a-b", "a//b"])
def test_a_name_that_is_none_is_refused(arm_bench, name):
    arm_bench.graph.params.set(f"/{name or 'x'}", HIP)
    assert not arm_bench.load(name)
    assert "constructing nodehandle" in arm_bench.said()[-1]


def test_two_controllers_for_one_joint_are_a_conflict(arm_bench):
    for name in ("a", "both"):
        arm_bench.load(name)
    arm_bench.switch(["a"])
    assert not arm_bench.switch(["both"])
    assert arm_bench.said()[-3:-1] == [
        "Resource conflict on [hip].  Controllers = [a, both, ]",
        "Could not switch controllers, due to resource conflict",
    ]
    assert "a and both both command hip" in arm_bench.said()[-1]
    assert arm_bench.states() == {"a": "running", "both": "initialized"}
    assert arm_bench.switch(["both"], stop=["a"])
    assert arm_bench.states() == {"a": "stopped", "both": "running"}


def test_both_may_be_loaded_as_long_as_they_do_not_run_together(arm_bench):
    assert arm_bench.load("a")
    assert arm_bench.load("both")
    assert not arm_bench.switch(["a", "both"])
    assert set(arm_bench.states().values()) == {"initialized"}


def test_strict_switches_do_all_or_nothing(arm_bench):
    arm_bench.load("a")
    assert not arm_bench.switch(["a", "nobody"])
    assert arm_bench.said()[-2] == (
        "Could not start controller with name 'nobody' because no controller with this name exists"
    )
    assert arm_bench.states() == {"a": "initialized"}
    assert not arm_bench.switch(stop=["a"])
    assert arm_bench.said()[-1] == "Could not stop controller 'a' since it is not running"
    arm_bench.switch(["a"])
    assert not arm_bench.switch(["a"])
    assert arm_bench.said()[-1] == "Controller 'a' is already running"
    assert not arm_bench.switch(stop=["nobody"])
    assert "Could not stop controller with name 'nobody'" in arm_bench.said()[-2]


def test_best_effort_does_what_can_be_done(arm_bench):
    arm_bench.load("a")
    assert arm_bench.switch(["a", "nobody"], stop=["nowhere"], strictness=BEST_EFFORT)
    assert arm_bench.states() == {"a": "running"}
    assert arm_bench.switch(["a"], strictness=BEST_EFFORT)
    assert arm_bench.said() == []


def test_without_strictness_it_is_best_effort_and_said(arm_bench):
    arm_bench.load("a")
    assert arm_bench.switch(["a", "nobody"], strictness=0)
    assert "Defaulting to ::BEST_EFFORT." in arm_bench.said()[-1]


def test_a_controller_can_be_started_anew(arm_bench):
    arm_bench.load("a")
    arm_bench.switch(["a"])
    assert arm_bench.switch(["a"], stop=["a"])
    assert arm_bench.states() == {"a": "running"}


def test_one_that_runs_or_is_unknown_cannot_be_unloaded(arm_bench):
    arm_bench.load("a")
    arm_bench.switch(["a"])
    assert not arm_bench.unload("a")
    assert not arm_bench.unload("x")
    assert arm_bench.said() == [
        "Could not unload controller with name 'a' because it is still running",
        "Could not unload controller with name 'x' because no controller with this name exists",
    ]


def test_libraries_are_reloaded_when_nothing_is_loaded_or_by_force(arm_bench):
    service = "/controller_manager/reload_controller_libraries"
    kind = "controller_manager_msgs/ReloadControllerLibraries"
    arm_bench.load("a")
    arm_bench.switch(["a"])
    assert not arm_bench.call(service, kind, force_kill=False).ok
    assert arm_bench.states() == {"a": "running"}
    assert arm_bench.call(service, kind, force_kill=True).ok
    assert arm_bench.states() == {}


def test_a_controller_that_fails_leaves_no_topics(arm_bench):
    before = arm_bench.graph.topic_types()
    arm_bench.graph.params.set("/c", {"type": "effort_controllers/JointPositionController"})
    assert not arm_bench.load("c")
    assert arm_bench.graph.topic_types() == before


def test_all_types_are_listed_and_check_urdf_knows_them(arm_bench):
    kind = "controller_manager_msgs/ListControllerTypes"
    answer = arm_bench.call("/controller_manager/list_controller_types", kind)
    assert list(answer.types) == list(CONTROLLER_TYPES)
    assert set(answer.base_classes) == {"controller_interface"}


@pytest.mark.parametrize("type_name", list(CONTROLLER_TYPES))
def test_every_type_can_be_imported(type_name):
    assert CONTROLLER_TYPES[type_name].load().__name__ == CONTROLLER_TYPES[type_name].class_name
