"""Sensors: values that make no sense, lasers inside of the robot."""

from __future__ import annotations

import pytest

from simkit.diagnostics import Severity

MASS = '<inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
ROBOT = f"""<link name="base">{MASS}<collision><geometry><box size="0.4 0.4 0.2"/></geometry></collision></link><link name="eye"/>
<joint name="j" type="fixed"><origin xyz="{{}}" rpy="{{}}"/><parent link="base"/><child link="eye"/></joint>
"""
LASER = """<gazebo reference="eye"><sensor type="ray" name="laser">
<update_rate>20</update_rate>
<ray>
<scan><horizontal>
<samples>720</samples>
<min_angle>-1.57</min_angle>
<max_angle>1.57</max_angle>
</horizontal></scan>
<range><min>0.1</min><max>10.0</max></range>
<noise><type>gaussian</type><stddev>0.01</stddev></noise>
</ray>
<plugin name="p" filename="libgazebo_ros_laser.so"><topicName>scan</topicName><frameName>eye</frameName></plugin>
</sensor></gazebo>"""


def robot(laser=LASER, xyz="0 0 0.2", rpy="0 0 0"):
    return ROBOT.format(xyz, rpy) + laser


def test_a_laser_with_sense(told):
    assert told(robot(), "GZ-W14") == []
    assert told(robot(), "LAS-W01") == []


@pytest.mark.parametrize(
    ("right", "wrong", "line", "what", "remedy"),
    [
        ("720", "0", 8, "<samples> is '0'", "at least 1"),
        ("720", "many", 8, "<samples> is 'many'", "at least 1"),
        (
            "<min_angle>-1.57",
            "<min_angle>-90",
            9,
            "<min_angle> is -90, which is -14.32 turns",
            "-90° = -1.571",
        ),
        (
            "<min_angle>-1.57",
            "<min_angle>2",
            9,
            "<min_angle> is 2, and <max_angle> is 1.57",
            "<min_angle>",
        ),
        ("<min>0.1", "<min>20", 12, "<min> is 20, and <max> is 10", "<min>"),
        ("<max>10.0", "<max>far", 12, "<max> is not a number: 'far'", "a number"),
        (">gaussian<", ">gausian<", 13, "no noise of type 'gausian'", "gaussian"),
        (">0.01<", ">-1<", 13, "<stddev> is '-1'", "0 or more"),
        (">20<", ">-5<", 5, "<update_rate> is '-5'", "[Hz]"),
        ('type="ray"', 'type="laser"', 4, "no sensor of type 'laser'", "ray"),
        ('type="ray" ', "", 4, "has no type", 'type="ray"'),
        ("<horizontal>", "<horizontl>", 4, "one beam", "<samples>"),
    ],
)
def test_values_without_sense(told, right, wrong, line, what, remedy):
    assert right in LASER
    changed = LASER.replace(right, wrong)
    if wrong == "<horizontl>":
        changed = changed.replace("</horizontal>", "</horizontl>")
    one, *more = told(robot(changed), "GZ-W14")
    assert (one.severity, one.span.line) == (Severity.WARNING, line)
    assert what in one.what
    assert remedy in one.remedy
    assert len(more) <= 1


def test_a_sensor_of_no_link(told):
    (one,) = told(robot(LASER.replace(' reference="eye"', "")), "GZ-W14")
    assert one.severity is Severity.ERROR
    assert "belongs to no link" in one.what


def test_sensors_that_say_nothing_and_sensors_that_are_not_simulated(told):
    silent = LASER[: LASER.index("<plugin")] + LASER[LASER.index("</plugin>") + 9 :]
    (one,) = told(robot(silent), "GZ-W14")
    assert one.severity is Severity.NOTE
    assert "libgazebo_ros_laser.so" in one.remedy
    camera = (
        '<gazebo reference="eye"><sensor type="camera" name="c">'
        '<plugin name="p" filename="libgazebo_ros_camera.so"/></sensor></gazebo>'
    )
    (one,) = told(robot(camera), "GZ-W14")
    assert one.severity is Severity.NOTE


@pytest.mark.parametrize(
    ("laser", "xyz", "depth"),
    [
        (LASER, "0 0 0", "0.1 m deep"),
        (LASER, "0.15 0 0.05", "0.05 m deep"),
        (
            LASER.replace("<update_rate>", "<pose>0 0 -0.15 0 0 0</pose><update_rate>"),
            "0 0 0.2",
            "0.05 m deep",
        ),
    ],
)
def test_a_laser_inside_of_the_body(told, laser, xyz, depth):
    (one,) = told(robot(laser, xyz), "LAS-W01")
    assert (one.severity, one.span.line) == (Severity.WARNING, 4)
    assert "of the collision shape of 'base'" in one.what
    assert depth in one.what


def test_beams_that_begin_outside_of_the_body(told):
    assert told(robot(LASER.replace("<min>0.1", "<min>0.5"), "0 0 0"), "LAS-W01") == []
    upright = robot(LASER.replace("<min>0.1", "<min>0.15"), "0 0 0", "0 1.570796 0")
    assert (
        len(told(upright, "LAS-W01")) == 1
    )  # its plane stands upright: to the sides it is still inside
    assert told(robot(LASER.replace("0.1</min>", "0.1</min>"), "0 0 0.11"), "LAS-W01") == []
