"""What a drive tells of its wheels on /tf and on joint_states."""

from __future__ import annotations

import math

import pytest

from tests.simkit.plugins.samples import CAR, driven, tell

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
