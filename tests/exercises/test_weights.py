"""What physics must know of a link."""

import pytest

from grader.errors import CheckFailed
from oracles.weights import expect_collision_as_visual, expect_cylinder_weight
from simkit.urdf import load_robot

GOOD_INERTIAL = (
    '<inertial><mass value="1"/><origin xyz="0 0 0.2"/>'
    '<inertia ixx="0.01396" iyy="0.01396" izz="0.00125" ixy="0" ixz="0" iyz="0"/></inertial>'
)
SHAPE = '<geometry><cylinder length="0.4" radius="0.05"/></geometry><origin xyz="0 0 0.2"/>'


def robot(inertial=GOOD_INERTIAL, collision=f"<collision>{SHAPE}</collision>"):
    text = f"<robot name='r'><link name='arm'><visual>{SHAPE}</visual>{collision}{inertial}</link></robot>"
    return load_robot(text, file="r.urdf")


def weigh(inertial):
    expect_cylinder_weight(robot(inertial), "arm", mass=1.0, length=0.4, radius=0.05)


def test_the_right_weight_is_taken_also_in_turned_axes():
    weigh(GOOD_INERTIAL)
    weigh(
        '<inertial><mass value="1"/><origin xyz="0 0 0.2" rpy="0 1.570796327 0"/>'
        '<inertia ixx="0.00125" iyy="0.01396" izz="0.01396" ixy="0" ixz="0" iyz="0"/></inertial>'
    )


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (GOOD_INERTIAL, "", "arm has no mass"),
        ('value="1"', 'value="2"', "mass of arm"),
        ('xyz="0 0 0.2"', 'xyz="0 0 0"', "centre of mass of arm"),
        ('ixx="0.01396"', 'ixx="0.0145"', "Ixx of arm"),
        ('iyy="0.01396"', 'iyy="0.0134"', "Iyy of arm"),
        ('izz="0.00125"', 'izz="0.0025"', "Izz of arm"),
        ('ixy="0"', 'ixy="0.001"', "Ixy of arm"),
        ('iyz="0"', 'iyz="-0.001"', "Iyz of arm"),
    ],
)
def test_each_wrong_number_is_named(old, new, says):
    with pytest.raises(CheckFailed, match=says) as caught:
        weigh(GOOD_INERTIAL.replace(old, new))
    assert caught.value.hint


@pytest.mark.parametrize(
    ("collision", "says"),
    [
        ("", "0 collision shapes"),
        (f"<collision>{SHAPE}</collision>" * 2, "2 collision shapes"),
        (f"<collision>{SHAPE}</collision>".replace("0.05", "0.06"), "Length and radius"),
        (f"<collision>{SHAPE}</collision>".replace("0 0 0.2", "0 0 0"), "iddle of the collision"),
        ('<collision><geometry><box size="1 1 1"/></geometry></collision>', "is not a cylinder"),
    ],
)
def test_a_collision_shape_that_is_not_the_visual_is_named(collision, says):
    expect_collision_as_visual(robot(), "arm")
    with pytest.raises(CheckFailed, match=says):
        expect_collision_as_visual(robot(collision=collision), "arm")
