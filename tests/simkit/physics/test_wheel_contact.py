"""Wheels touch with the middle of their tread."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from simkit.geometry import Transform
from simkit.physics import JointKind, JointPlan, ShapePlan, World, plan_robot
from simkit.physics.shapes import WIDTH, contact_solid
from simkit.urdf import Box, Cylinder, load_robot

LYING = Transform.from_rpy((0.0, 0.0, 0.0), (math.pi / 2, 0.0, 0.0))
JOINT = JointPlan(
    name="axle", kind=JointKind.REVOLUTE, parent="base", child="wheel", axis=(0.0, 1.0, 0.0)
)
WHEEL = ShapePlan(name="wheel", link="wheel", solid=Cylinder(radius=0.1, length=0.04), frame=LYING)
NARROW = Cylinder(radius=0.1, length=WIDTH)


def test_a_wheel_is_narrow_where_it_touches():
    assert contact_solid(WHEEL, JOINT) == NARROW
    back = replace(JOINT, axis=(0.0, -1.0, 0.0))
    assert contact_solid(WHEEL, back) == NARROW
    rounded = replace(WHEEL, frame=Transform.from_rpy((0.0, 0.03, 0.001), (1.57, 0.0, 0.0)))
    assert contact_solid(rounded, JOINT) == NARROW
    thin = replace(WHEEL, solid=Cylinder(radius=0.1, length=0.001))
    assert contact_solid(thin, JOINT) == thin.solid


@pytest.mark.parametrize(
    ("shape", "joint"),
    [
        (replace(WHEEL, frame=Transform()), JOINT),  # it stands
        (
            replace(WHEEL, frame=Transform.from_rpy((0.0, 0.0, 0.0), (1.5, 0.0, 0.0))),
            JOINT,
        ),  # askew
        (
            replace(WHEEL, frame=Transform.from_rpy((0.02, 0.0, 0.0), (math.pi / 2, 0.0, 0.0))),
            JOINT,
        ),  # a cam
        (replace(WHEEL, solid=Cylinder(radius=0.1, length=0.3)), JOINT),  # a roller
        (replace(WHEEL, solid=Box(size=(0.2, 0.2, 0.04))), JOINT),
        (WHEEL, replace(JOINT, lower=-1.0, upper=1.0)),  # it cannot turn round
        (WHEEL, replace(JOINT, kind=JointKind.FIXED)),
        (WHEEL, replace(JOINT, kind=JointKind.FREE)),
    ],
)
def test_what_is_no_wheel_touches_as_it_is(shape, joint):
    assert contact_solid(shape, joint) is shape.solid


CART = """<robot name="cart">
  <link name="base"><inertial><mass value="4"/>
    <inertia ixx="0.03" iyy="0.06" izz="0.08" ixy="0" ixz="0" iyz="0"/></inertial></link>
  {left}{right}
  <link name="ball"><inertial><mass value="0.5"/><inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><sphere radius="0.05"/></geometry></collision></link>
  <joint name="ball_joint" type="fixed"><parent link="base"/><child link="ball"/><origin xyz="0.2 0 -0.05"/></joint>
  <gazebo reference="ball"><mu1>0</mu1><mu2>0</mu2></gazebo>
</robot>"""
SIDE = """<link name="{side}">
    <inertial><mass value="0.2"/><origin rpy="1.5708 0 0"/>
      <inertia ixx="0.0005" iyy="0.0005" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin rpy="1.5708 0 0"/>
      <geometry><cylinder radius="0.1" length="{width}"/></geometry></collision></link>
  <joint name="{side}_joint" type="continuous"><parent link="base"/><child link="{side}"/>
    <origin xyz="-0.05 {y} 0"/><axis xyz="0 1 0"/></joint>"""


def cart(width):
    """A cart with wheels of a width [m], 0.4 m apart, in a world."""
    left, right = (
        SIDE.format(side=s, width=width, y=y) for s, y in (("left", 0.2), ("right", -0.2))
    )
    world = World()
    plan = plan_robot(load_robot(CART.format(left=left, right=right), file="cart"))
    return world, world.add(plan, pose=Transform((0.0, 0.0, 0.1), (0.0, 0.0, 0.0, 1.0)))


@pytest.mark.parametrize("width", [0.01, 0.04, 0.08])
def test_a_robot_turns_as_its_wheels_say_however_wide_they_are(width):
    world, model = cart(width)
    for side, speed in (("left", -1.0), ("right", 1.0)):
        model.joint(f"{side}_joint").command_velocity(speed, effort=5.0)
    world.run(500_000_000)
    start = model.pose.rotation
    world.run(1_000_000_000)
    x, y, z, w = model.pose.rotation
    turned = 2 * (math.atan2(z, w) - math.atan2(start[2], start[3]))
    assert turned == pytest.approx(2 * 1.0 * 0.1 / 0.4, rel=0.01)
    assert abs(x) + abs(y) < 1e-3


def test_a_laser_sees_the_whole_wheel():
    world, _ = cart(0.08)
    beside = world.cast_rays(np.array([[-0.05, 0.235, 1.0]]), np.array([[0.0, 0.0, -1.0]]))
    assert beside.distances[0] == pytest.approx(1.0 - 0.2, abs=1e-6)
