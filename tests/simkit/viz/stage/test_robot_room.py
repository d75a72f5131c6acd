from __future__ import annotations

import math

import pytest

from simkit.urdf import load_robot
from simkit.viz.stage.robot import robot_shapes
from simkit.viz.stage.robot_room import robot_room


def room(joint, more=""):
    text = f"""<robot name="r"><link name="a"/>
    <link name="b"><visual>
      <origin xyz="0 0 1"/><geometry><box size="0.2 0.2 2"/></geometry>
    </visual></link>
    <joint name="j" {joint}<parent link="a"/><child link="b"/></joint>{more}</robot>"""
    shapes = robot_shapes(load_robot(text, file="r.urdf"))
    return robot_room(shapes.models[0], shapes.solids)


def bounds(points):
    return [(min(p[axis] for p in points), max(p[axis] for p in points)) for axis in range(3)]


def test_a_link_that_turns_takes_a_whole_circle():
    x, y, z = bounds(room('type="continuous"><axis xyz="1 0 0"/>'))
    assert x == pytest.approx((-0.1, 0.1))
    reach = math.hypot(2, 0.1)
    assert (*y, *z) == pytest.approx((-reach, reach, -reach, reach), rel=0.02)


def test_limits_count():
    limit = '<limit lower="0" upper="1.5708" effort="1" velocity="1"/>'
    _, y, z = bounds(room(f'type="revolute"><axis xyz="1 0 0"/>{limit}'))
    assert y[0] == pytest.approx(-2.0, rel=0.05)
    assert y[1] == pytest.approx(0.1, rel=0.05)
    assert z[0] == pytest.approx(-0.1, rel=0.3)


def test_a_robot_that_does_not_move_takes_its_own_room():
    assert bounds(room('type="fixed">')) == [(-0.1, 0.1), (-0.1, 0.1), (0.0, 2.0)]


def test_there_are_few_points_and_always_the_same(arm):
    points = robot_room(arm.models[0], arm.solids)
    assert points == robot_room(arm.models[0], arm.solids)
    assert 8 <= len(points) <= 26


def test_nothing_to_see_takes_no_room(arm):
    assert robot_room(arm.models[0], ()) == ()
