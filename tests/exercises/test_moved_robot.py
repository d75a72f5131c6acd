"""A robot that is moved and measured, against pytransform3d."""

import math

import numpy as np
import pytest
from pytransform3d.urdf import UrdfTransformManager

from grader.errors import CheckFailed
from oracles.moved_robot import MovedRobot, SeenRobot, expect_to_follow, require_joint
from simkit import Simulation
from simkit.urdf import read_robot

ARM = """<robot name="machine">
  <link name="world"/>
  <link name="torso">
    <visual><origin xyz="0 0 0.25"/><geometry><cylinder length="0.5" radius="0.05"/></geometry></visual>
  </link>
  <link name="arm">
    <visual>
      <origin xyz="0.1 0 0.2" rpy="0.3 0.2 0.1"/>
      <geometry><cylinder length="0.4" radius="0.05"/></geometry>
    </visual>
  </link>
  <joint name="hip" type="continuous">
    <parent link="world"/><child link="torso"/><axis xyz="0 0 1"/><origin xyz="0 0 0.05"/>
  </joint>
  <joint name="shoulder" type="continuous">
    <parent link="torso"/><child link="arm"/><axis xyz="0 1 0"/>
    <origin xyz="0 -0.1 0.45" rpy="0 1.5708 0"/>
  </joint>
</robot>"""


@pytest.fixture
def moved():
    robot = read_robot(ARM, file="arm.urdf").robot
    assert robot is not None
    with Simulation(screen=None) as sim:
        yield MovedRobot(sim, robot, ARM)


def test_poses_and_ends_agree_with_another_program(moved):
    oracle = UrdfTransformManager()
    oracle.load_urdf(ARM)
    for hip, shoulder in ((0.0, 0.0), (0.7, -1.1), (-2.5, 3.0)):
        moved.move(hip=hip, shoulder=shoulder)
        oracle.set_joint("hip", hip)
        oracle.set_joint("shoulder", shoulder)
        pose = oracle.get_transform("arm", "world")
        place, turn = moved.pose("arm")
        assert place == pytest.approx(tuple(pose[:3, 3]), abs=1e-9)
        assert np.array(turn) == pytest.approx(pose[:3, :3], abs=1e-9)
        shape = oracle.get_transform("visual:arm/0", "world")
        lower, upper = (shape @ (0, 0, side, 1) for side in (-0.2, 0.2))
        for end, expected in zip(moved.ends("arm"), (lower, upper), strict=True):
            assert end == pytest.approx(tuple(expected[:3]), abs=1e-9)


def test_a_joint_that_is_not_named_keeps_its_angle(moved):
    moved.move(hip=0.5, shoulder=0.25)
    before = moved.pose("arm", seen_from="torso")
    moved.move(hip=-0.5)
    assert moved.pose("arm", seen_from="torso") == before


def test_what_cannot_be_measured_is_said(moved):
    with pytest.raises(CheckFailed, match="no joint elbow can be moved"):
        moved.move(elbow=math.pi)
    with pytest.raises(CheckFailed, match="tf does not know where hand is"):
        moved.pose("hand")
    with pytest.raises(CheckFailed, match="world is invisible"):
        moved.ends("world")


def test_a_fixed_joint_cannot_be_moved():
    robot = read_robot(ARM.replace("continuous", "fixed"), file="arm.urdf").robot
    assert robot is not None
    with pytest.raises(CheckFailed, match="no joint hip"):
        require_joint(robot, "hip")


def test_frames_that_follow_a_file_and_frames_that_do_not(moved):
    moved.move(hip=0.4, shoulder=-0.3)
    expect_to_follow(moved, ARM, "arm", hip=0.4, shoulder=-0.3)
    with pytest.raises(CheckFailed, match="elsewhere than your file puts it"):
        expect_to_follow(moved, ARM, "arm", hip=0.5, shoulder=-0.3)
    other = ARM.replace('<axis xyz="0 1 0"/>', '<axis xyz="1 0 0"/>')
    robot = read_robot(other, file="arm.urdf").robot
    assert robot is not None
    seen = SeenRobot(moved.sim, robot)
    with pytest.raises(CheckFailed, match="rad away"):
        expect_to_follow(seen, other, "arm", hip=0.4, shoulder=-0.3)
