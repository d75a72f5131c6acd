"""Motors that give all they have."""

from __future__ import annotations

import pytest

from tests.simkit.plugins.samples import link

WALL = link("wall", '<box size="0.2 4 2"/>') + "<gazebo><static>true</static></gazebo>"


def test_a_car_that_pushes_a_wall(watched):
    watched.spawn(WALL, name="wall", pose=watched.at(0.6, 0, 1))
    watched.car(torque=0.5)
    watched.run(0.2)
    watched.tell(0.5)
    watched.run(4)
    (text,) = watched.found()
    assert text.startswith(
        "[GZ-W04] the joint 'left_joint' of car has given all it has for half a second, 0.5 N m"
    )
    assert "instead of 5 rad/s" in text
    assert "<wheelTorque>" in text


def test_a_car_that_gets_there(watched):
    watched.car(torque=0.5)
    watched.run(0.2)
    watched.tell(0.5)
    watched.run(2)
    assert watched.found() == []


def test_motors_too_weak_for_a_model_of_sdf(watched):
    watched.sdf_car(torque=0.02)
    watched.tell(0.5)
    watched.run(2)
    (text,) = watched.found()
    assert "0.02 N m, and moves at" in text


@pytest.mark.parametrize(("friction", "count"), [(5.0, 1), (0.0, 0)])
def test_an_effort_that_moves_nothing(watched, friction, count):
    slider = f"""<link name="world"/><joint name="hold" type="fixed"><parent link="world"/><child link="base"/>
      <origin xyz="0 0 1"/></joint>{link("base", '<box size="0.1 0.1 0.1"/>')}
      {link("cart", '<box size="0.1 0.1 0.1"/>')}
      <joint name="slide" type="prismatic"><parent link="base"/><child link="cart"/><axis xyz="1 0 0"/>
        <limit lower="-50" upper="50" effort="1" velocity="100"/><dynamics friction="{friction}"/></joint>
      <gazebo><plugin name="p" filename="libgazebo_ros_joint_state_publisher.so"><jointName>slide</jointName>
      </plugin></gazebo>"""
    spawned = watched.spawn(slider, name="slider")
    spawned.model.joint("slide").command_effort(3.0)
    watched.run(1.5)
    found = watched.found("GZ-W04")
    assert len(found) == count
    assert all("1 N, and moves at" in text and '<limit effort="...">' in text for text in found)
