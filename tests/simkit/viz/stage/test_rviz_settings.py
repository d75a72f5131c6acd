from __future__ import annotations

import pytest

from simkit.errors import SimkitError, UnknownNameError
from simkit.viz import RvizSettings, display_of, displays_of
from simkit.viz.stage.parts import Role
from simkit.viz.stage.rviz_settings import (
    SHOWN_TYPES,
    LaserScanDisplay,
    OdometryDisplay,
    PathDisplay,
    label,
)
from simkit.viz.stage.scene import Displays


def test_displays_follow_the_settings():
    assert RvizSettings().displays == Displays(grid=True, tf=True, robot=Role.VISUAL)
    shown = RvizSettings(robot_model="collision", show_tf=False, show_grid=False)
    assert shown.displays == Displays(grid=False, tf=False, robot=Role.COLLISION)
    assert RvizSettings(robot_model=None).displays.robot is None


def test_what_makes_no_sense_is_refused():
    with pytest.raises(UnknownNameError, match="no robot model 'visuel'; did you mean 'visual'"):
        RvizSettings(robot_model="visuel")
    for alpha in (-0.1, 1.5, float("nan")):
        with pytest.raises(SimkitError, match="alpha is an opacity from 0 to 1"):
            RvizSettings(alpha=alpha)


def test_the_type_of_a_topic_decides_on_its_display():
    assert display_of("/scan", "sensor_msgs/LaserScan") == LaserScanDisplay(topic="/scan")
    assert display_of("/plan", "nav_msgs/Path") == PathDisplay(topic="/plan")
    odometry = display_of("/odom", "nav_msgs/Odometry", keep=7)
    assert odometry == OdometryDisplay(topic="/odom", keep=7)
    assert label(odometry) == "Odometry /odom"


def test_a_type_without_a_display_is_refused_with_those_that_have_one():
    with pytest.raises(
        SimkitError, match="no display shows topic /imu, a sensor_msgs/Imu"
    ) as caught:
        display_of("/imu", "sensor_msgs/Imu")
    for type_name in SHOWN_TYPES:
        assert type_name in str(caught.value)


def test_of_a_recording_the_topics_are_taken_that_have_a_display():
    types = {
        "/odom": "nav_msgs/Odometry",
        "/tf": "tf2_msgs/TFMessage",
        "/scan": "sensor_msgs/LaserScan",
    }
    assert [one.topic for one in displays_of(types)] == ["/odom", "/scan"]


@pytest.mark.parametrize("keep", [0, -1, 10_001, True])
def test_keep_is_a_number_of_arrows(keep):
    with pytest.raises(SimkitError, match="keep is a number of arrows from 1 to 10000"):
        OdometryDisplay(topic="/odom", keep=keep)


@pytest.mark.parametrize("name", ["position_tolerance", "angle_tolerance", "length"])
@pytest.mark.parametrize("value", [-0.1, float("nan"), float("inf")])
def test_tolerances_and_lengths_are_numbers_from_zero(name, value):
    with pytest.raises(SimkitError, match="a tolerance or length"):
        OdometryDisplay(topic="/odom", **{name: value})
