"""What is wrong with the robots of the book is not wrong with these; what holds for any robot asks for `urdf`."""

from __future__ import annotations

import math

import pytest

from simkit.geometry import matrix_from_rpy
from simkit.urdf import Box, Cylinder, load_robot
from simkit.urdf.inertia import body_of_shapes, turned
from simkit.urdf.kinematics import forward_kinematics
from simkit.urdf.placed_shape import PlacedShape
from tests.laws import broken_laws

ROUNDED = 0.02
"""The book writes moments of inertia with two digits or more."""
NEARLY = 0.002
"""An angle that is no farther from a right one is meant to be one [rad]."""
WHEELS = {
    "m2wr": ("joint_left_wheel", "joint_right_wheel"),
    "practice_car": ("left_wheel_joint", "right_wheel_joint"),
}


def robot_of(path):
    return load_robot(path.read_bytes(), file=path.name)


def car(robots, name):
    (path,) = robots.glob(f"*/urdf/{name}.urdf")
    return robot_of(path)


def drive(robot):
    """The parameters of its plugin."""
    for gazebo in robot.document.root.all("gazebo"):
        plugin = gazebo.child("plugin")
        if plugin is not None and plugin.get("filename") == "libgazebo_ros_diff_drive.so":
            return {child.name: child.text for child in plugin.children}
    raise AssertionError("no libgazebo_ros_diff_drive.so")


def test_an_inertia_is_that_of_the_shape_filled_evenly(book_urdf):
    for link in robot_of(book_urdf).links.values():
        if link.inertial is None:
            continue
        inertial = link.inertial
        # The ball of m2wr weighs nothing: the book counts it to the body.
        shape = link.collisions[0]
        body = body_of_shapes(
            [PlacedShape(shape.geometry, shape.origin.transform)], mass=inertial.mass
        )
        assert inertial.origin.xyz == pytest.approx(body.centre)
        written = (
            (inertial.ixx, inertial.ixy, inertial.ixz),
            (inertial.ixy, inertial.iyy, inertial.iyz),
            (inertial.ixz, inertial.iyz, inertial.izz),
        )
        tensor = turned(written, matrix_from_rpy(inertial.origin.rpy))
        for ours, theirs in zip(tensor, body.tensor, strict=True):
            assert ours == pytest.approx(theirs, rel=ROUNDED, abs=1e-6)


def test_what_is_touched_is_where_it_is_seen(book_urdf):
    for link in robot_of(book_urdf).links.values():
        if link.collisions:
            seen = [(visual.geometry, visual.origin) for visual in link.visuals]
            assert seen == [(touched.geometry, touched.origin) for touched in link.collisions]


def test_an_angle_near_a_right_one_is_one(urdf):
    robot = robot_of(urdf)
    poses = [joint.origin for joint in robot.joints.values()]
    for link in robot.links.values():
        parts = [*link.visuals, *link.collisions, *([link.inertial] if link.inertial else [])]
        poses += [part.origin for part in parts]
    off = {angle: math.remainder(angle, math.pi / 2) for pose in poses for angle in pose.rpy}
    broken_laws(
        [f"rpy {angle}" for angle, error in off.items() if 5e-6 < abs(error) < NEARLY],
        f"write pi/2 as 1.570796 in {urdf.name}, as all robots here do",
    )


@pytest.mark.parametrize("name", WHEELS)
def test_each_wheel_is_on_its_side_beside_the_body_and_the_plugin_knows_where(robots, name):
    robot = car(robots, name)
    tags = drive(robot)
    left, right = (robot.joints[joint] for joint in WHEELS[name])
    assert (tags["leftJoint"], tags["rightJoint"]) == WHEELS[name]
    y_left, y_right = left.origin.xyz[1], right.origin.xyz[1]
    assert y_left == -y_right
    assert float(tags["wheelSeparation"]) == pytest.approx(y_left - y_right)
    assert left.axis == right.axis == (0.0, 1.0, 0.0)
    wheel = robot.links[left.child].collisions[0].geometry
    body = robot.links[left.parent].collisions[0].geometry
    assert isinstance(wheel, Cylinder)
    assert isinstance(body, Box)
    assert float(tags["wheelDiameter"]) == pytest.approx(2 * wheel.radius)
    assert y_left - wheel.length / 2 > body.size[1] / 2 + 0.001


@pytest.mark.parametrize(
    ("name", "link", "height"),
    [("m2wr", "link_chassis", -0.1), ("practice_car", "front_wheel", 0.0)],
)
def test_the_ball_touches_the_ground_as_the_wheels_do_and_slides(robots, name, link, height):
    robot = car(robots, name)
    places = forward_kinematics(robot, {})
    ball = robot.links[link].collisions[-1]
    bottom = places[link].translation[2] + ball.origin.xyz[2] - ball.geometry.radius
    hub = robot.joints[WHEELS[name][0]].child
    radius = robot.links[hub].collisions[0].geometry.radius
    assert bottom == pytest.approx(height, abs=1e-9)
    assert places[hub].translation[2] - radius == pytest.approx(height, abs=1e-9)
    (block,) = [one for one in robot.document.root.all("gazebo") if one.get("reference") == link]
    assert [block.child(tag).text for tag in ("mu1", "mu2")] == ["0.0", "0.0"]


def test_the_laser_has_a_link_and_looks_past_its_own_housing(robots):
    robot = car(robots, "m2wr")
    laser = robot.links["sensor_laser"]
    blocks = robot.document.root.all("gazebo")
    (sensor,) = [one for block in blocks for one in block.all("sensor")]
    assert sensor.parent.get("reference") == "sensor_laser"
    assert robot.joint_above("sensor_laser").parent == robot.root
    nearest = float(sensor.child("ray").child("range").child("min").text)
    assert laser.collisions[0].geometry.radius < nearest
