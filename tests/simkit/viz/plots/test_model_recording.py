from __future__ import annotations

import math

import pytest

from simkit import SimkitError, Simulation, UnknownNameError

PENDULUM = """<robot name="pendulum">
  <link name="world"/>
  <link name="bob">
    <inertial><origin xyz="0 0 -0.5"/><mass value="2"/>
      <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin xyz="0 0 -0.5"/><geometry><sphere radius="0.05"/></geometry></collision>
  </link>
  <joint name="hinge" type="continuous"><axis xyz="0 1 0"/>
    <parent link="world"/><child link="bob"/><origin xyz="0 0 2"/></joint>
</robot>"""
BALL = """<robot name="ball"><link name="ball">
  <inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><sphere radius="0.1"/></geometry></collision>
</link></robot>"""


@pytest.fixture
def sim():
    with Simulation(screen=None) as sim:
        yield sim


def test_the_effort_that_holds_a_pendulum_is_recorded(sim):
    pendulum = sim.spawn(PENDULUM, name="pendulum")
    hinge = pendulum.model.joint("hinge")
    hinge.command_position(math.pi / 2)
    sim.run(0.2)
    recording = sim.record_model("pendulum", rate=50)
    sim.run(0.5)
    series = sim.joint_plot(recording).series
    assert series.topic == "/pendulum/joint_states"
    assert len(series.effort["hinge"]) == 26
    assert series.position["hinge"][-1][1] == pytest.approx(math.pi / 2, abs=1e-6)
    # Two kilograms half a metre beside the hinge.
    assert abs(series.effort["hinge"][-1][1]) == pytest.approx(2 * 9.8 * 0.5, rel=1e-3)


def test_the_true_pose_of_a_falling_ball_is_recorded(sim):
    sim.spawn(BALL, name="ball", xyz=(1.0, 2.0, 5.0))
    recording = sim.record_model("ball", rate=100)
    sim.run(0.5)
    assert recording.types() == {
        "/ball/joint_states": "sensor_msgs/JointState",
        "/ball/pose": "nav_msgs/Odometry",
    }
    begin, (time, pose) = recording["/ball/pose"][0][0], recording["/ball/pose"][-1]
    t = (time - begin).to_sec()
    assert t == pytest.approx(0.5)
    p = pose.pose.pose.position
    assert (p.x, p.y, p.z) == pytest.approx((1, 2, 5 - 9.8 * t * t / 2), abs=0.01)
    assert pose.header.frame_id == "world"


def test_a_recording_that_is_stopped_has_what_it_had(sim):
    sim.spawn(BALL, name="ball")
    recording = sim.record_model("ball", rate=10)
    sim.run(0.35)
    recording.stop()
    sim.run(0.5)
    assert len(recording["/ball/pose"]) == 4


def test_a_model_that_is_gone_is_sampled_no_more_also_if_a_namesake_comes(sim):
    sim.spawn(BALL, name="ball")
    recording = sim.record_model("ball", rate=10)
    sim.run(0.15)
    sim.gazebo.delete("ball")
    sim.spawn(BALL, name="ball")
    sim.run(0.5)
    assert len(recording["/ball/pose"]) == 2


@pytest.mark.parametrize("rate", [0.0, -1.0, 1001.0, math.nan])
def test_a_rate_has_a_range(sim, rate):
    sim.spawn(BALL, name="ball")
    with pytest.raises(SimkitError, match="a rate is above 0 and at most 1000 Hz"):
        sim.record_model("ball", rate=rate)


def test_what_is_not_there_is_told(sim):
    sim.spawn(BALL, name="ball")
    with pytest.raises(UnknownNameError, match="ball"):
        sim.record_model("bal")
    with pytest.raises(UnknownNameError, match="/ball/pose"):
        sim.record_model("ball")["/pose"]
