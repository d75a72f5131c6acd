"""The wheels of a model, as its plugin believes them, and as they are."""

from __future__ import annotations

import pytest

from simkit.gazebo.watchers.motion import drive_of
from tests.simkit.plugins.samples import PENDULUM, ROVER


def test_the_sizes_of_a_car(watched):
    drive = drive_of(watched.car(separation=0.5, diameter=0.3))
    assert (drive.separation, drive.diameter) == (0.5, 0.3)
    assert drive.real_separation() == pytest.approx(0.4)
    assert drive.real_diameter() == pytest.approx(0.2)
    assert [joint.name for joint in drive.joints] == ["left_joint", "right_joint"]


def test_what_the_motors_are_told(watched):
    drive = drive_of(watched.car())
    watched.tell(0.3, -0.4)
    watched.run(0.2)
    assert drive.command() == pytest.approx((0.3, -0.4))
    watched.run(0.5)
    assert drive.rolled() == pytest.approx((0.3, -0.4), abs=0.02)


def test_four_wheels(watched):
    plugin = '<gazebo><plugin name="d" filename="libgazebo_ros_skid_steer_drive.so"/></gazebo>'
    drive = drive_of(watched.spawn(ROVER + plugin, pose=watched.at(z=0.1)))
    assert len(drive.left) == len(drive.right) == 2
    assert drive.real_separation() == pytest.approx(0.4)
    assert drive.torque_tag == "torque"


def test_what_has_no_wheels_has_no_drive(watched):
    assert drive_of(watched.spawn(PENDULUM)) is None
