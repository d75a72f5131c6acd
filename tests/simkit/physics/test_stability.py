"""What could be built is told from what could not."""

from __future__ import annotations

import math

import pytest

from simkit.physics import LostModelError
from simkit.physics.stability import is_realistic


@pytest.mark.parametrize("name", ["arm", "car", "m2wr"])
def test_the_robots_of_the_book_could_be_built(robot_plan, name):
    assert is_realistic(robot_plan(name))


def test_the_ground_could_be_built():
    from simkit.physics import ground_plan

    assert is_realistic(ground_plan())


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
    assert is_realistic(plan_text(BODY.format("a", *numbers))) is expected


def test_grams_beside_tons(plan_text):
    text = BODY.format("a", 1000, 0, 1, 1, 1, 0.1) + BODY.format(
        "b", 0.01, 0, 1e-5, 1e-5, 1e-5, 0.1
    )
    joint = '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    assert not is_realistic(plan_text(text + joint))


SECOND = 1_000_000_000

# Hundreds of metres, grams beside tons, and a motor that nothing can hold.
WILD = """<link name="a"><inertial><mass value="0.1"/><inertia ixx="0.24" iyy="1.3" izz="0.27" ixy="0" ixz="0" iyz="0"/>
  </inertial><collision><origin xyz="0.2 0 -1"/><geometry><cylinder radius="0.01" length="600"/></geometry></collision></link>
  <link name="b"><inertial><mass value="11000"/><inertia ixx="0.2" iyy="0.5" izz="0.4" ixy="0" ixz="0" iyz="0"/>
  </inertial><collision><origin xyz="0 0 16"/><geometry><cylinder radius="42" length="0.0001"/></geometry></collision></link>
  <joint name="j" type="continuous"><parent link="a"/><child link="b"/><origin xyz="-1 -0.7 0"/></joint>"""


def test_a_model_that_flies_apart_is_taken_out_and_the_rest_goes_on(
    new_world, plan_text, solid, at
):
    world = new_world()
    box = world.add(solid("box", 0.2, 0.2, 0.2), pose=at(x=100.0, z=0.1))
    wild = world.add(plan_text(WILD), name="wild")
    wild.joint("j").command_effort(1e9)
    with pytest.raises(LostModelError, match="wild flew apart at 0") as caught:
        world.run(SECOND)
    assert caught.value.model == "wild"
    assert caught.value.time_ns == world.time_ns > 0
    assert list(world.models) == ["ground_plane", "box"]
    world.run(SECOND)
    assert math.isfinite(box.pose.translation[2])


def test_what_falls_for_ever_is_taken_out_in_the_end(new_world, solid, at):
    world = new_world(ground=False, gravity=(0.0, 0.0, -1e6))
    world.add(solid("sphere", 0.1))
    with pytest.raises(LostModelError, match="sphere"):
        world.run(60 * SECOND)


def is_quiet(world):
    """Whether the engine makes the next steps in one go."""
    return world._stepper._burst(8) == 8


def test_a_calm_world_is_left_to_the_engine(new_world, robot_plan):
    world = new_world()
    car = world.add(robot_plan("car"))
    world.run(SECOND)
    assert is_quiet(world)
    car.joint("left_wheel_joint").command_effort(0.1)
    assert not is_quiet(world)
    world.run(SECOND)
    assert is_quiet(world)
    world.after_step.append(lambda: None)
    assert not is_quiet(world)
