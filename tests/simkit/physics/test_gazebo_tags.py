"""Tags in `<gazebo>` blocks change how a robot moves."""

from __future__ import annotations

import pytest

LINK = """<link name="{0}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><sphere radius="0.1"/></geometry></collision></link>"""
ROBOT = (
    LINK.format("a")
    + LINK.format("b")
    + """<joint name="j" type="{}"><parent link="a"/><child link="b"/></joint>"""
)


def about(name: str, inside: str) -> str:
    return f'<gazebo reference="{name}">{inside}</gazebo>'


def test_without_tags_there_is_friction_gravity_and_no_self_collision(plan_text):
    body = plan_text(LINK.format("a")).bodies["a"]
    assert (body.shapes[0].friction, body.gravity, body.self_collide, body.decay) == (
        1,
        True,
        False,
        0,
    )


def test_tags_of_a_link(plan_text):
    tags = (
        "<mu1>0.2</mu1><mu2>0.2</mu2><turnGravityOff>yes</turnGravityOff><selfCollide>1</selfCollide>"
        "<dampingFactor>0.01</dampingFactor><laserRetro>5</laserRetro>"
    )
    plan = plan_text(LINK.format("a") + about("a", tags))
    body = plan.bodies["a"]
    assert (body.shapes[0].friction, body.shapes[0].retro) == (0.2, 5.0)
    assert (body.gravity, body.self_collide, body.decay) == (False, True, 0.01)
    assert not plan.notes


def test_the_last_word_counts(plan_text):
    text = LINK.format("a") + about("a", "<mu1>0.2</mu1>") + about("a", "<mu1>0.3</mu1>")
    assert plan_text(text).bodies["a"].shapes[0].friction == 0.3


def test_a_lumped_link_keeps_its_friction_and_gives_away_the_rest(plan_text):
    tags = about("b", "<mu1>0</mu1><turnGravityOff>true</turnGravityOff>")
    body = plan_text(ROBOT.format("fixed") + tags).bodies["a"]
    assert [shape.friction for shape in body.shapes] == [1.0, 0.0]
    assert not body.gravity


def test_friction_in_one_direction_only_is_said(plan_text):
    plan = plan_text(LINK.format("a") + about("a", "<mu1>0.2</mu1><mu2>0.9</mu2>"))
    assert plan.bodies["a"].shapes[0].friction == 0.2
    assert "mu2 = 0.9 has no effect" in plan.notes[0]


@pytest.mark.parametrize("tag", ["kp", "kd", "maxVel", "minDepth", "fdir1"])
def test_soft_contacts_are_said_to_be_rigid(plan_text, tag):
    plan = plan_text(LINK.format("a") + about("a", f"<{tag}>1000</{tag}>"))
    assert f"<{tag}> of a has no effect" in plan.notes[0]


@pytest.mark.parametrize("value", ["", "much", "nan", "-0.1"])
def test_friction_that_is_no_number_is_left_out(plan_text, value):
    plan = plan_text(LINK.format("a") + about("a", f"<mu1>{value}</mu1>"))
    assert plan.bodies["a"].shapes[0].friction == 1.0
    assert "<mu1> of a is left out" in plan.notes[0]


def test_a_spring(plan_text):
    tags = about("j", "<springStiffness>3</springStiffness><springReference>-1</springReference>")
    joint = plan_text(ROBOT.format("continuous") + tags).joints["j"]
    assert (joint.stiffness, joint.rest) == (3.0, -1.0)


def test_a_reference_to_nothing_is_dropped(plan_text):
    assert not plan_text(LINK.format("a") + about("nobody", "<kp>1</kp>")).notes


def test_a_static_robot_stays(plan_text, new_world, at):
    plan = plan_text(LINK.format("a") + "<gazebo><static>true</static></gazebo>")
    world = new_world()
    model = world.add(plan, pose=at(z=1.0))
    world.run(1_000_000_000)
    assert model.pose.translation == (0.0, 0.0, 1.0)
    assert not model.is_free
