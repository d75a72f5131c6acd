"""Motors of wheels, and the ear of a drive."""

from __future__ import annotations

import math

import pytest

from simkit.physics import Mode
from simkit.plugins import PluginError
from simkit.plugins.site import Site
from simkit.plugins.wheels import FASTEST, MotorWheel, SpeedRamp, TwistListener
from simkit.xml import parse_xml
from tests.simkit.plugins.samples import CAR, driven, tell


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

    def make(torque: float = 5.0, diameter: float = 0.2, joint: str = "left_joint") -> MotorWheel:
        return MotorWheel(
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
    ear = TwistListener(site, "/cmd_vel")
    tell(stage, 1.0, 2.0)
    tell(stage, 0.5, -1.0)
    stage.run(0.001)
    assert (ear.linear, ear.angular) == (0.5, -1.0)
    assert ear.rim_speeds(0.4) == pytest.approx((0.7, 0.3))
    ear.forget()
    assert ear.rim_speeds(0.4) == (0.0, 0.0)


def test_the_ear_hears_no_more_when_it_is_closed(stage, site):
    ear = TwistListener(site, "/cmd_vel")
    ear.close()
    tell(stage, 1.0)
    stage.run(0.001)
    assert ear.linear == 0.0
    assert site.node.subscriptions == [
        one for one in site.node.subscriptions if one.topic != "/cmd_vel"
    ]


@pytest.mark.parametrize("numbers", [(math.nan, 0.0), (0.0, -math.inf)])
def test_what_is_no_number_is_not_obeyed_and_told(stage, site, numbers):
    ear = TwistListener(site, "/cmd_vel")
    tell(stage, 0.5)
    tell(stage, *numbers)
    stage.run(0.001)
    assert ear.linear in (0.0, 0.5)
    assert math.isfinite(ear.angular)
    assert any("NaN or infinity" in said for said in stage.said())


STILL = (0.0, 0.0)


def test_without_a_limit_the_targets_are_told_at_once():
    assert SpeedRamp(0.0).next_speeds((5.0, -3.0), STILL, 0.05) == (5.0, -3.0)


def test_no_wheel_is_told_to_accelerate_more_than_the_limit():
    assert SpeedRamp(2.0).next_speeds((1.0, -1.0), STILL, 0.05) == pytest.approx((0.1, -0.1))


def test_it_goes_on_from_what_it_told_and_not_from_what_the_wheels_do():
    ramp = SpeedRamp(2.0)
    ramp.next_speeds((1.0, 1.0), STILL, 0.05)
    assert ramp.next_speeds((1.0, 1.0), STILL, 0.05) == pytest.approx((0.2, 0.2))


def test_the_last_bit_of_the_way_is_as_long_as_what_is_missing():
    assert SpeedRamp(2.0).next_speeds((1.0, 1.0), (0.98, 0.5), 0.05) == pytest.approx((0.02, 0.1))


@pytest.mark.parametrize("measured", [(0.991, 0.0), (0.0, 1.009)])
def test_as_soon_as_one_wheel_is_near_its_target_both_get_theirs(measured):
    assert SpeedRamp(0.1).next_speeds((1.0, 1.0), measured, 0.05) == (1.0, 1.0)


def test_a_wheel_that_has_nothing_to_change_lets_the_other_one_jump():
    assert SpeedRamp(0.1).next_speeds((0.0, 1.0), STILL, 0.05) == (0.0, 1.0)


def test_after_a_jump_the_next_ramp_goes_on_from_the_one_before():
    ramp = SpeedRamp(2.0)
    ramp.next_speeds((1.0, 1.0), STILL, 0.05)
    ramp.next_speeds((1.0, 1.0), (1.0, 1.0), 0.05)
    assert ramp.next_speeds((0.0, 0.0), (1.0, 1.0), 0.05) == pytest.approx((0.0, 0.0))


def test_reset_is_the_beginning():
    ramp = SpeedRamp(2.0)
    ramp.next_speeds((1.0, 1.0), STILL, 0.05)
    ramp.reset()
    assert ramp.next_speeds((1.0, 1.0), STILL, 0.05) == pytest.approx((0.1, 0.1))


TF = "tf2_msgs/TFMessage"


def wheels(heard) -> list[tuple[str, str, tuple[float, float, float]]]:
    """Parent, child and place of each wheel that was told."""
    return [
        (one.header.frame_id, one.child_frame_id, (t.x, t.y, t.z))
        for message in heard
        for one in message.transforms
        for t in (one.transform.translation,)
    ]


def test_each_wheel_is_on_the_link_that_carries_it(stage):
    stage.spawn(driven(publishWheelTF="true", publishTf="false"), pose=stage.at(3.0, 1.0, 0.1))
    heard = stage.listen("/tf", TF)
    stage.run(0.06)
    assert [(parent, child) for parent, child, _ in wheels(heard)] == [
        ("base", "right"),
        ("base", "left"),
    ]
    assert [place for *_, place in wheels(heard)] == [
        pytest.approx((0.0, -0.2, 0.0), abs=1e-6),
        pytest.approx((0.0, 0.2, 0.0), abs=1e-6),
    ]


def test_a_wheel_turns_on_tf_as_its_joint_does(stage):
    model = stage.spawn(
        driven(publishWheelTF="true", publishTf="false"), pose=stage.at(z=0.1)
    ).model
    heard = stage.listen("/tf", TF)
    tell(stage, 0.5)
    stage.run(0.152)
    angle = heard[-1].transforms[0].transform.rotation
    turned = 2.0 * math.atan2(angle.y, angle.w)
    assert turned == pytest.approx(model.joint("left_joint").position, abs=0.01)
    assert turned > 0.2


def test_a_wheel_that_does_not_hang_on_the_root_is_put_in_the_wrong_place_as_in_gazebo(stage, link):
    mast = (
        f'{link("mast")}<joint name="lift" type="prismatic"><parent link="foot"/><child link="base"/>'
        '<origin xyz="1 0 0"/><axis xyz="0 0 1"/><limit lower="0" upper="0" effort="1" velocity="1"/></joint>'
    ).replace('name="mast"', 'name="foot"')
    stage.spawn(
        driven(robot=CAR + mast, publishWheelTF="true", publishTf="false"), pose=stage.at(z=0.3)
    )
    heard = stage.listen("/tf", TF)
    stage.run(0.052)
    parent, child, (x, _, _) = wheels(heard)[0]
    assert (parent, child) == ("base", "right")
    assert x == pytest.approx(1.0, abs=0.01)


def test_a_namespace_is_a_prefix_of_frames(stage):
    stage.spawn(
        driven(publishWheelTF="true", publishTf="false"),
        pose=stage.at(z=0.1),
        namespace="/one",
    )
    heard = stage.listen("/tf", TF)
    stage.run(0.06)
    assert wheels(heard)[0][:2] == ("one/base", "one/right")
