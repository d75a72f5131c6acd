"""What could be built is told from what could not."""

from __future__ import annotations

import pytest

from simkit.physics.tameness import is_tame


@pytest.mark.parametrize("name", ["arm", "car", "m2wr"])
def test_the_robots_of_the_book_could_be_built(robot_plan, name):
    assert is_tame(robot_plan(name))


def test_the_ground_could_be_built():
    from simkit.physics import ground_plan

    assert is_tame(ground_plan())


BODY = """<link name="{0}"><inertial><mass value="{1}"/><origin xyz="{2} 0 0"/>
  <inertia ixx="{3}" iyy="{4}" izz="{5}" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><sphere radius="{6}"/></geometry></collision></link>"""


@pytest.mark.parametrize(
    ("numbers", "expected"),
    [
        ((1, 0, 1, 1, 1, 0.1), True),
        ((1, 0, 1, 1, 2.5, 0.1), True),  # impossible, but not by much
        ((1, 0, 1, 1, 9, 0.1), False),
        ((1, 0, 1e-6, 1, 1, 0.1), False),
        ((1, 0, 1e4, 1e4, 1e4, 0.1), False),
        ((1, 60, 1, 1, 1, 0.1), False),
        ((1, 0, 1, 1, 1, 100), False),
    ],
)
def test_one_body(plan_text, numbers, expected):
    assert is_tame(plan_text(BODY.format("a", *numbers))) is expected


def test_grams_beside_tons(plan_text):
    text = BODY.format("a", 1000, 0, 1, 1, 1, 0.1) + BODY.format(
        "b", 0.01, 0, 1e-5, 1e-5, 1e-5, 0.1
    )
    joint = '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    assert not is_tame(plan_text(text + joint))
