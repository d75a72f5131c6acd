"""The plugin: it waits for the robot, and moves joints by position, velocity, effort, with gains and without."""

from __future__ import annotations

import math

import pytest

from simkit.graph import LogLevel
from simkit.msgs import message_class
from tests.simkit.plugins.control.conftest import PLUGIN, arm, transmission
from tests.simkit.plugins.samples import MANAGER, MANAGER_MSGS, PENDULUM, TRANSMISSION, Sample

SAMPLE = Sample(
    robot=PENDULUM + TRANSMISSION,
    parameters={
        "/robot_description": "{urdf}",
        "/states": {
            "type": "joint_state_controller/JointStateController",
            "publish_rate": "{rate}",
        },
        "/push": {"type": "effort_controllers/JointEffortController", "joint": "swing"},
    },
    calls=(
        *(
            (f"{MANAGER}/load_controller", f"{MANAGER_MSGS}/LoadController", {"name": name})
            for name in ("states", "push")
        ),
        (
            f"{MANAGER}/switch_controller",
            f"{MANAGER_MSGS}/SwitchController",
            {"start_controllers": ["states", "push"], "strictness": 2},
        ),
    ),
    commands={"/push/command": message_class("std_msgs/Float64")(0.5)},
    begins_anew=False,
)

FORWARD = {
    "PositionJointInterface": "position_controllers/JointGroupPositionController",
    "VelocityJointInterface": "velocity_controllers/JointGroupVelocityController",
    "EffortJointInterface": "effort_controllers/JointGroupEffortController",
}
STRONG = '<limit effort="1000" velocity="100" lower="-1" upper="2"/>'
SERVICES = {
    "list_controllers",
    "list_controller_types",
    "load_controller",
    "unload_controller",
    "switch_controller",
    "reload_controller_libraries",
}


def go(bench, interface, *targets, **options):
    """An arm whose joints are told something, from the beginning."""
    bench.put(arm(interface, **options))
    assert bench.start("c", FORWARD[interface], joints=["hip", "shoulder"])
    bench.tell("/c/command", "std_msgs/Float64MultiArray", data=list(targets))


def manager_services(bench, space=""):
    begin = f"{space}/controller_manager/"
    return {name.removeprefix(begin) for name in bench.graph.services if name.startswith(begin)}


def test_it_offers_a_controller_manager(bench):
    bench.put(arm())
    assert manager_services(bench) == SERVICES
    assert bench.said(LogLevel.INFO)[-4:] == [
        "Loading gazebo_ros_control plugin",
        "Starting gazebo_ros_control plugin in namespace: /",
        "gazebo_ros_control plugin is waiting for model URDF in parameter [/robot_description] on the "
        "ROS param server.",
        "Loaded gazebo_ros_control.",
    ]


def test_it_waits_for_the_robot_description(bench):
    bench.spawned = bench.stage.spawn(arm(), namespace="/")
    bench.stage.run(0.5)
    assert manager_services(bench) == set()
    bench.graph.params.set("/robot_description", f'<robot name="r">{arm()}</robot>')
    bench.stage.run(0.11)
    assert manager_services(bench) == SERVICES


def test_after_a_while_it_says_what_it_waits_for(bench):
    bench.spawned = bench.stage.spawn(arm(), namespace="/")
    bench.stage.run(20.0)
    (hint,) = bench.said()
    assert "nobody has set the parameter robot_description" in hint


def test_it_lives_in_the_namespace_of_its_tag(bench):
    bench.put(arm(tags="<robotNamespace>/left/</robotNamespace>"))
    assert manager_services(bench, "/left") == SERVICES
    assert manager_services(bench) == set()


def test_it_reads_the_parameter_that_its_tag_names(bench):
    bench.graph.params.set("/my_arm", f'<robot name="r">{arm()}</robot>')
    bench.spawned = bench.stage.spawn(arm(tags="<robotParam>my_arm</robotParam>"), namespace="/")
    assert manager_services(bench) == SERVICES


def test_before_any_controller_runs_positions_are_held_at_0(bench):
    bench.put(arm())
    bench.stage.run(0.5)
    assert bench.positions() == [0.0, 0.0]


def test_before_any_controller_runs_joints_with_efforts_fall(bench):
    bench.put(arm("EffortJointInterface"))
    bench.stage.run(0.2)
    assert bench.joint("hip").velocity > 0.5


def test_a_position_is_there_after_one_step_and_nothing_bends_it(bench):
    go(bench, "PositionJointInterface", 0.05, -0.02)
    bench.stage.run(0.001)
    assert bench.positions() == [0.05, -0.02]
    bench.stage.run(0.5)
    assert bench.positions() == [0.05, -0.02]


def test_a_position_is_kept_within_the_limits_and_their_speed(bench):
    limit = '<limit effort="1" velocity="0.5" lower="-0.1" upper="0.2"/>'
    go(bench, "PositionJointInterface", 1.0, -1.0, kind="revolute", limit=limit)
    bench.stage.run(0.1)
    assert bench.positions() == pytest.approx([0.05, -0.05])
    bench.stage.run(0.5)
    assert bench.positions() == pytest.approx([0.2, -0.1])


def test_a_velocity_is_held_against_gravity(bench):
    go(bench, "VelocityJointInterface", 0.3, -0.2)
    bench.stage.run(1.0)
    assert bench.positions() == pytest.approx([0.3, -0.2], abs=1e-2)


def test_a_velocity_gives_way_to_what_is_stronger_than_the_motor(bench):
    limit = '<limit effort="1" velocity="100"/>'
    go(bench, "VelocityJointInterface", -0.3, 0.0, limit=limit)
    bench.stage.run(0.3)
    assert bench.joint("hip").velocity > 0.1  # it falls


def test_an_effort_is_a_torque(bench):
    go(bench, "EffortJointInterface", 3.0, 0.0, axis="0 0 1")
    bench.stage.run(0.001)
    alone = bench.joint("hip").velocity
    go_again = bench.joint("hip")
    bench.stage.run(0.001)
    assert alone > 0.0
    assert go_again.effort == 3.0


def test_gains_make_an_effort_of_a_position(bench):
    gains = {"p": 200.0, "d": 10.0}
    pids = {"hip": gains, "shoulder": gains}
    bench.put(arm(limit=STRONG, kind="revolute"), gazebo_ros_control__pid_gains=pids)
    assert bench.start("c", FORWARD["PositionJointInterface"], joints=["hip", "shoulder"])
    bench.tell("/c/command", "std_msgs/Float64MultiArray", data=[0.4, -0.3])
    bench.stage.run(2.0)
    hip, shoulder = bench.positions()
    sag = [abs(hip - 0.4), abs(shoulder + 0.3)]
    assert all(0.0 < one < 0.1 for one in sag), "a spring gives way to gravity, a little"


def test_gains_that_are_too_weak_for_their_limit_are_cut(bench):
    weak = '<limit effort="0.5" velocity="100" lower="-2" upper="2"/>'
    pids = {"hip": {"p": 1000.0}, "shoulder": {"p": 1000.0}}
    bench.put(arm(limit=weak, kind="revolute"), gazebo_ros_control__pid_gains=pids)
    bench.stage.run(0.3)
    assert bench.joint("hip").position > 0.05
    assert abs(bench.joint("hip").effort) <= 0.5


def test_gains_make_an_effort_of_a_velocity(bench):
    pids = {"hip": {"p": 5.0}, "shoulder": {"p": 5.0}}
    bench.put(arm("VelocityJointInterface", axis="0 0 1"), gazebo_ros_control__pid_gains=pids)
    assert bench.start("c", FORWARD["VelocityJointInterface"], joints=["hip", "shoulder"])
    bench.tell("/c/command", "std_msgs/Float64MultiArray", data=[0.5, 0.0])
    bench.stage.run(0.5)
    assert bench.joint("hip").velocity == pytest.approx(0.5, rel=0.02)


def test_parameters_limit_joints_too(bench):
    limits = {"hip": {"has_position_limits": True, "min_position": -0.1, "max_position": 0.1}}
    bench.put(arm(), joint_limits=limits)
    assert bench.start("c", FORWARD["PositionJointInterface"], joints=["hip", "shoulder"])
    bench.tell("/c/command", "std_msgs/Float64MultiArray", data=[1.0, 1.0])
    bench.stage.run(0.01)
    assert bench.positions() == [0.1, 1.0]


def test_the_emergency_stop_holds_positions(bench):
    go(bench, "PositionJointInterface", 0.05, 0.0, tags="<eStopTopic>stop</eStopTopic>")
    bench.stage.run(0.01)
    bench.tell("/stop", "std_msgs/Bool", data=True)
    bench.tell("/c/command", "std_msgs/Float64MultiArray", data=[0.3, 0.0])
    bench.stage.run(0.1)
    assert bench.positions() == [0.05, 0.0]
    bench.tell("/stop", "std_msgs/Bool", data=False)
    bench.stage.run(0.01)
    assert bench.positions() == [0.05, 0.0], "controllers start anew from where the joints are"


def test_the_emergency_stop_brings_velocities_to_rest(bench):
    go(bench, "VelocityJointInterface", 0.5, 0.0, tags="<eStopTopic>stop</eStopTopic>")
    bench.stage.run(0.1)
    bench.tell("/stop", "std_msgs/Bool", data=True)
    bench.stage.run(0.1)
    assert bench.joint("hip").velocity == pytest.approx(0.0, abs=1e-6)


def test_a_slower_period_is_said_and_kept(bench):
    go(bench, "PositionJointInterface", 0.0, 0.0, tags="<controlPeriod>0.01</controlPeriod>")
    assert bench.said()[0] == (
        "Desired controller update period (0.010000000 s) is slower than the gazebo simulation period "
        "(0.001000000 s)."
    )
    bench.stage.run(0.012)
    bench.tell("/c/command", "std_msgs/Float64MultiArray", data=[0.05, 0.0])
    moved = []
    for _ in range(12):
        bench.stage.run(0.001)
        moved.append(bench.joint("hip").position != 0.0)
    assert moved.index(True) == 8, "at the next update, not in the next step"


def test_a_faster_period_is_an_error_and_each_step_counts(bench):
    go(bench, "PositionJointInterface", 0.05, 0.0, tags="<controlPeriod>0.0001</controlPeriod>")
    assert "is faster than the gazebo simulation period" in bench.said()[0]
    bench.stage.run(0.001)
    assert bench.joint("hip").position == 0.05


def test_a_joint_that_is_not_in_the_model_is_left_out(bench):
    bench.put(arm() + transmission("sholder", "PositionJointInterface"))
    said = bench.said()
    assert 'This robot has a joint named "sholder" which is not in the gazebo model.' in said
    assert "hint: no controller can move it; did you mean shoulder?" in said
    assert bench.start("c", FORWARD["PositionJointInterface"], joints=["hip", "shoulder"])


def test_a_speed_limit_of_0_is_explained(bench):
    bench.put(arm(kind="revolute", limit='<limit effort="1" velocity="0" lower="-1" upper="1"/>'))
    assert any('says velocity="0": it cannot be moved' in one for one in bench.said())


def test_a_joint_that_was_turned_far_is_read_within_half_a_turn(bench):
    go(bench, "PositionJointInterface", 10.0, 0.0)
    bench.stage.run(0.01)
    handle = bench.plugin.manager.hardware.drives["hip"].handle
    assert handle.position == pytest.approx(10.0 - 4.0 * math.pi)


def test_a_reset_of_the_world_leaves_the_controllers_at_work(bench):
    go(bench, "PositionJointInterface", 0.05, 0.0)
    bench.stage.run(0.1)
    bench.stage.gazebo.reset_world()
    bench.stage.run(0.01)
    assert bench.states() == {"c": "running"}
    assert bench.positions() == [0.05, 0.0]


def test_with_the_robot_go_its_topics_services_and_timers(bench):
    bench.put(arm())
    before = bench.graph.topic_types().keys()
    assert bench.start(
        "c", "position_controllers/JointTrajectoryController", joints=["hip", "shoulder"]
    )
    bench.stage.gazebo.delete("r")
    bench.stage.run(0.5)
    assert manager_services(bench) == set()
    assert bench.graph.topic_types().keys() <= before


def test_a_robot_whose_plugin_waits_can_be_deleted(bench):
    bench.spawned = bench.stage.spawn(arm(), namespace="/")
    bench.stage.gazebo.delete("r")
    bench.graph.params.set("/robot_description", f'<robot name="r">{arm()}</robot>')
    bench.stage.run(0.5)
    assert manager_services(bench) == set()


def test_a_description_that_is_no_xml_is_an_error(bench):
    bench.graph.params.set("/robot_description", "this is no robot")
    bench.spawned = bench.stage.spawn(arm(), namespace="/")
    assert "Can't parse transmissions. Invalid robot description." in bench.said()
    assert PLUGIN.format(tags="") in arm()
