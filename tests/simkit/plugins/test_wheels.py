"""Motors of wheels, and the ear of a drive."""

from __future__ import annotations

import math

import pytest

from simkit.physics import Mode
from simkit.plugins import PluginError
from simkit.plugins.site import Site
from simkit.plugins.wheels import FASTEST, TwistEar, Wheel
from simkit.xml import parse_xml
from tests.simkit.plugins.samples import CAR, tell


@pytest.fixture
def site(stage):
    """The site of a plugin of a car that stands."""
    root = parse_xml("<plugin>\n<leftJoint>left_wheel</leftJoint></plugin>", file="car.urdf").root
    assert root is not None
    return Site(
        node=stage.gazebo.node,
        world=stage.gazebo.world,
        model=stage.spawn(CAR, name="car", pose=stage.at(z=0.1)).model,
        element=root,
        file="car.urdf",
        namespace="/",
    )


@pytest.fixture
def wheel(site):
    """Makes the left wheel."""

    def make(torque: float = 5.0, diameter: float = 0.2, joint: str = "left_joint") -> Wheel:
        return Wheel(
            site, "leftJoint", joint, torque=torque, diameter=diameter, speaker="DiffDrive"
        )

    return make


def test_a_motor_holds_a_speed_of_the_rim(stage, wheel):
    left = wheel(diameter=0.4)
    left.drive(1.0)
    stage.run(0.2)
    assert left.joint.velocity == pytest.approx(5.0)
    assert left.rim_speed == pytest.approx(1.0)
    assert left.rolled == pytest.approx(left.joint.position * 0.2)


def test_a_motor_gives_no_more_than_its_torque(stage, wheel):
    left = wheel(torque=0.01)
    left.drive(100.0)
    stage.run(0.01)
    assert left.joint.is_saturated
    assert left.joint.effort == pytest.approx(0.01)


@pytest.mark.parametrize("speed", [1e300, -1e300])
def test_no_motor_is_asked_for_what_no_motor_can(wheel, speed):
    left = wheel()
    left.drive(speed)
    assert left.joint.command == math.copysign(FASTEST, speed)


def test_a_wheel_that_is_let_go_rolls(wheel):
    left = wheel()
    left.drive(1.0)
    left.release()
    assert left.joint.mode is Mode.FREE


def test_a_joint_that_is_not_there_is_named_with_those_that_are(wheel):
    with pytest.raises(PluginError, match=r"^car\.urdf:2:2: DiffDrive: couldn't get") as caught:
        wheel(joint="left_wheel_joint")
    assert "named left_wheel_joint; did you mean left_joint?" in str(caught.value)
    assert str(caught.value).endswith("left_joint, right_joint.")


def test_the_ear_keeps_the_last_command(stage, site):
    ear = TwistEar(site, "/cmd_vel")
    tell(stage, 1.0, 2.0)
    tell(stage, 0.5, -1.0)
    stage.run(0.001)
    assert (ear.linear, ear.angular) == (0.5, -1.0)
    assert ear.rim_speeds(0.4) == pytest.approx((0.7, 0.3))
    ear.forget()
    assert ear.rim_speeds(0.4) == (0.0, 0.0)


def test_the_ear_hears_no_more_when_it_is_closed(stage, site):
    ear = TwistEar(site, "/cmd_vel")
    ear.close()
    tell(stage, 1.0)
    stage.run(0.001)
    assert ear.linear == 0.0
    assert site.node.subscriptions == [
        one for one in site.node.subscriptions if one.topic != "/cmd_vel"
    ]


@pytest.mark.parametrize("numbers", [(math.nan, 0.0), (0.0, -math.inf)])
def test_what_is_no_number_is_not_obeyed_and_told(stage, site, numbers):
    ear = TwistEar(site, "/cmd_vel")
    tell(stage, 0.5)
    tell(stage, *numbers)
    stage.run(0.001)
    assert ear.linear in (0.0, 0.5)
    assert math.isfinite(ear.angular)
    assert any("what is no number" in said for said in stage.said())
