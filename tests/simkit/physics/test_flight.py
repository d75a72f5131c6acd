"""What flies keeps its momentum."""

from __future__ import annotations

import math

import numpy as np
import pytest

SECOND = 1_000_000_000


def momenta(model) -> tuple[np.ndarray, np.ndarray]:
    """Linear momentum, and angular momentum about the centre of mass, of all bodies together."""
    centre = np.array(model.centre_of_mass)
    linear, angular = np.zeros(3), np.zeros(3)
    for name, plan in model.plan.bodies.items():
        pose = model.link_pose(name)
        turn = np.array(pose.matrix)
        arm = turn @ np.array(plan.body.centre)
        origin_velocity, spin = map(np.array, model.link_twist(name))
        velocity = origin_velocity + np.cross(spin, arm)
        linear += plan.body.mass * velocity
        offset = np.array(pose.translation) + arm - centre
        angular += turn @ np.array(plan.body.tensor) @ turn.T @ spin
        angular += plan.body.mass * np.cross(offset, velocity)
    return linear, angular


def test_a_thrown_box_tumbles_with_its_momentum(new_world, solid, at):
    world = new_world(gravity=(0.0, 0.0, 0.0), ground=False)
    box = world.add(solid("box", 0.2, 0.3, 0.1), pose=at(angle=0.7, axis=(1, 2, 3)))
    box.set_twist((1.0, 0.5, 0.2), (3.0, 5.0, 7.0))
    linear, angular = momenta(box)
    energy = box.kinetic_energy
    world.run(2 * SECOND)
    assert momenta(box)[0] == pytest.approx(linear, abs=1e-9)
    assert momenta(box)[1] == pytest.approx(angular, rel=1e-4)
    assert box.kinetic_energy == pytest.approx(energy, rel=1e-5)


def test_its_centre_keeps_to_the_parabola(new_world, plan_text, at):
    world = new_world(ground=False)
    club = world.add(
        plan_text("""<link name="a"><inertial><mass value="2"/><origin xyz="0.3 0 0.1"/>
        <inertia ixx="0.02" iyy="0.05" izz="0.04" ixy="0" ixz="0" iyz="0"/></inertial></link>""")
    )
    club.set_twist((0.0, 0.0, 5.0), (4.0, 3.0, 8.0))
    start = np.array(club.centre_of_mass)
    velocity = momenta(club)[0] / 2.0
    world.run(SECOND)
    assert club.centre_of_mass == pytest.approx(start + velocity + np.array([0, 0, -4.9]), abs=2e-4)


def test_the_parts_of_a_flying_robot_turn_against_each_other(new_world, plan_text):
    world = new_world(gravity=(0.0, 0.0, 0.0), ground=False)
    inertial = """<inertial><mass value="{}"/><origin xyz="{} 0 0"/>
      <inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0" ixz="0" iyz="0"/></inertial>"""
    robot = world.add(
        plan_text(
            f"""<link name="a">{inertial.format(3, 0)}</link><link name="b">{inertial.format(1, 0.3)}</link>
        <joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
        <origin xyz="0.2 0 0.1"/></joint>"""
        )
    )
    robot.joint("j").command_effort(0.05)
    world.run(SECOND)
    linear, angular = momenta(robot)
    assert linear == pytest.approx(np.zeros(3), abs=1e-6)
    assert angular == pytest.approx(np.zeros(3), abs=1e-4)
    assert abs(robot.joint("j").velocity) > 0.3
    assert robot.link_twist("a")[1][2] * robot.joint("j").velocity < 0.0


def test_what_brakes_loses_its_share_of_velocity(new_world, plan_text):
    world = new_world(gravity=(0.0, 0.0, 0.0), ground=False)
    body = """<link name="a"><inertial><mass value="2"/><origin xyz="0.1 0 0"/>
      <inertia ixx="0.02" iyy="0.05" izz="0.04" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <gazebo reference="a"><dampingFactor>0.001</dampingFactor></gazebo>"""
    slow = world.add(plan_text(body))
    slow.set_twist((1.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    world.run(SECOND)
    assert slow.twist[1][2] == pytest.approx(math.exp(-1.0), rel=2e-3)
    assert np.linalg.norm(momenta(slow)[0]) == pytest.approx(
        2 * math.hypot(1.0, 0.1) * math.exp(-1.0), rel=2e-3
    )


def test_what_has_no_gravity_floats(new_world, plan_text, at):
    world = new_world()
    balloon = world.add(
        plan_text("""<link name="a"><inertial><mass value="2"/>
      <inertia ixx="0.02" iyy="0.05" izz="0.04" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <gazebo reference="a"><turnGravityOff>true</turnGravityOff></gazebo>"""),
        pose=at(z=1.0),
    )
    world.run(SECOND)
    assert balloon.pose.translation == (0.0, 0.0, 1.0)
