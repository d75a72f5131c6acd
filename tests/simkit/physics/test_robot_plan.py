"""A URDF becomes the model that Gazebo makes of it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.physics import JointKind, ModelError

MASS = '<inertial><mass value="{}"/><inertia ixx="{}" iyy="{}" izz="{}" ixy="0" ixz="0" iyz="0"/></inertial>'
HEAVY = MASS.format(1, 0.1, 0.1, 0.1)


def link(name: str, inside: str = HEAVY) -> str:
    return f'<link name="{name}">{inside}</link>'


def joint(name: str, parent: str, child: str, kind: str = "fixed", inside: str = "") -> str:
    return f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{inside}</joint>'


LIMIT = '<limit lower="{}" upper="{}" effort="{}" velocity="{}"/>'


def test_the_car_is_lumped_as_gazebo_does(robot_plan):
    plan = robot_plan("car")
    assert list(plan.bodies) == ["base_link", "left_wheel", "right_wheel"]
    base = plan.bodies["base_link"].body
    assert base.mass == pytest.approx(1.5)
    assert base.centre == pytest.approx((0.0666667, 0.0, 0.1666667), abs=1e-7)
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = base.tensor
    assert (xx, yy, zz) == pytest.approx((0.0223333, 0.0516667, 0.0583333), abs=1e-7)
    assert (xy, xz, yz) == pytest.approx((0.0, 0.0066667, 0.0), abs=1e-7)
    assert [shape.name for shape in plan.bodies["base_link"].shapes] == [
        "base_link_fixed_joint_lump__chaiss_collision",
        "base_link_fixed_joint_lump__front_wheel_collision",
    ]
    assert [shape.link for shape in plan.bodies["base_link"].shapes] == ["chaiss", "front_wheel"]
    assert plan.bodies["left_wheel"].shapes[0].name == "left_wheel_collision"


def test_the_lumped_car_balances_as_its_parts_do(robot_plan):
    plan = robot_plan("car")
    total = sum(body.body.mass for body in plan.bodies.values())
    x = 0.0
    for body in plan.bodies.values():
        offset = next(
            (j.frame.translation[0] for j in plan.joints.values() if j.child == body.name), 0.0
        )
        x += body.body.mass * (body.body.centre[0] + offset)
    assert total == pytest.approx(2.5)
    assert x / total == pytest.approx(-0.020, abs=1e-6)


def test_links_that_were_lumped_keep_their_frames(robot_plan):
    mounts = robot_plan("car").mounts
    assert set(mounts) == {"base_link", "chaiss", "front_wheel", "left_wheel", "right_wheel"}
    assert mounts["front_wheel"].body == "base_link"
    assert mounts["front_wheel"].frame.translation == pytest.approx((0.2, 0.0, 0.1))


def test_collisions_with_names_keep_them(robot_plan):
    shapes = [s.name for body in robot_plan("m2wr").bodies.values() for s in body.shapes]
    assert shapes[0] == "link_chassis_fixed_joint_lump__collision_chassis_collision"
    assert "link_left_wheel_collision_collision" in shapes


def test_several_collisions_without_names_are_numbered(plan_text):
    ball = '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
    shapes = plan_text(link("a", HEAVY + 3 * ball)).bodies["a"].shapes
    assert [s.name for s in shapes] == ["a_collision", "a_collision_1", "a_collision_2"]


def test_a_root_link_world_is_the_world(plan_text):
    plan = plan_text(link("world", "") + link("a") + joint("j", "world", "a"))
    assert list(plan.bodies) == ["a"]
    assert plan.joints["j"].parent is None
    assert plan.joints["j"].kind is JointKind.FIXED


def test_a_robot_may_hang_on_the_world_by_a_moving_joint(plan_text):
    moving = joint("j", "world", "a", "continuous", '<origin xyz="0 0 1"/><axis xyz="0 2 0"/>')
    plan = plan_text(link("world", "") + link("a") + moving)
    assert plan.joints["j"].parent is None
    assert plan.joints["j"].axis == (0.0, 1.0, 0.0)
    assert plan.joints["j"].frame.translation == (0.0, 0.0, 1.0)


def test_the_joints_of_a_lumped_link_hang_on_the_body_that_took_it_in(plan_text):
    plan = plan_text(
        link("a")
        + link("b", "")
        + link("c")
        + joint("ab", "a", "b", inside='<origin xyz="1 0 0" rpy="0 0 1.5707963267948966"/>')
        + joint("bc", "b", "c", "continuous", '<origin xyz="1 0 0"/>')
    )
    assert plan.joints["bc"].parent == "a"
    assert plan.joints["bc"].frame.translation == pytest.approx((1.0, 1.0, 0.0))


def test_what_has_no_mass_is_left_out_with_all_below_it(plan_text):
    plan = plan_text(
        link("a")
        + link("b", "")
        + link("c")
        + joint("ab", "a", "b", "continuous")
        + joint("bc", "b", "c", "continuous")
    )
    assert list(plan.bodies) == ["a"]
    assert "c" not in plan.mounts
    assert list(plan.joints) == ["a (free)"]
    (note,) = plan.notes
    assert "link b has no mass" in note
    assert "and with it c" in note


def test_a_robot_without_any_mass_is_an_empty_model(plan_text):
    plan = plan_text(link("a", "") + link("b") + joint("ab", "a", "b", "continuous"))
    assert not plan.bodies
    assert "and with it b" in plan.notes[0]


def test_a_root_without_mass_takes_that_of_what_is_fixed_to_it(plan_text):
    plan = plan_text(link("a", "") + link("b") + joint("ab", "a", "b"))
    assert plan.bodies["a"].body.mass == 1.0
    assert not plan.notes


def test_a_fixed_joint_can_be_kept(plan_text):
    kept = '<gazebo reference="ab"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'
    plan = plan_text(link("a") + link("b") + joint("ab", "a", "b") + kept)
    assert list(plan.bodies) == ["a", "b"]
    assert plan.joints["ab"].kind is JointKind.FIXED


def test_limits_the_wrong_way_round_are_swapped_and_it_is_said(plan_text):
    plan = plan_text(
        link("a") + link("b") + joint("j", "a", "b", "revolute", LIMIT.format(1, -1, 10, 2))
    )
    hip = plan.joints["j"]
    assert (hip.lower, hip.upper, hip.effort, hip.velocity) == (-1.0, 1.0, 10.0, 2.0)
    assert "swapped" in plan.notes[0]


def test_a_continuous_joint_has_no_stops(plan_text):
    plan = plan_text(
        link("a") + link("b") + joint("j", "a", "b", "continuous", LIMIT.format(-1, 1, -1, -1))
    )
    turner = plan.joints["j"]
    assert (turner.lower, turner.upper) == (-math.inf, math.inf)
    assert (turner.effort, turner.velocity) == (math.inf, math.inf)


@pytest.mark.parametrize("kind", ["floating", "planar"])
def test_what_floats_is_free(plan_text, kind):
    below = joint("j", "a", "b", kind, '<origin xyz="0 0 2"/>')
    plan = plan_text(link("a") + link("b") + below)
    free = plan.joints["b (free)"]
    assert free.kind is JointKind.FREE
    assert free.parent is None
    assert free.frame.translation == (0.0, 0.0, 2.0)
    assert "floats free" in plan.notes[0]


def test_an_axis_that_points_nowhere_is_refused(plan_text):
    text = link("a") + link("b") + joint("j", "a", "b", "continuous", '<axis xyz="0 0 0"/>')
    with pytest.raises(ModelError, match="axis of joint j"):
        plan_text(text)


@pytest.mark.parametrize(
    ("inertial", "words"),
    [
        (MASS.format(-1, 1, 1, 1), "mass of -1 kg"),
        (MASS.format("1e300", 1, 1, 1), "inertial of link a"),
        (MASS.format("1e12", 1, 1, 1), "inertial of link a"),
    ],
)
def test_a_mass_that_cannot_be_is_refused(plan_text, inertial, words):
    with pytest.raises(ModelError, match=words):
        plan_text(link("a", inertial))


@pytest.mark.parametrize("moments", [(0, 0, 0), (-1, 1, 1), (1e-12, 1, 1)])
def test_an_inertia_that_cannot_be_is_mended_and_it_is_said(plan_text, new_world, moments):
    plan = plan_text(link("a", MASS.format(2, *moments)))
    assert np.linalg.eigvalsh(np.array(plan.bodies["a"].body.tensor)).min() >= 2e-7 * (1 - 1e-9)
    assert "inertia of link a is impossible" in plan.notes[0]
    world = new_world(ground=False)
    model = world.add(plan)
    model.set_twist((0.0, 0.0, 0.0), (1.0, 0.1, 0.1))
    world.run(1_000_000_000)
    assert model.pose.translation[2] == pytest.approx(-4.9, abs=0.01)


def test_a_possible_inertia_is_left_alone(plan_text):
    plan = plan_text(link("a", MASS.format(2, 1, 1, 5)))  # no solid has it, but it turns
    assert plan.bodies["a"].body.tensor[2][2] == 5.0
    assert not plan.notes


def test_mimic_joints_do_not_follow_and_it_is_said(plan_text):
    plan = plan_text(
        link("a")
        + link("b")
        + link("c")
        + joint("j", "a", "b", "continuous")
        + joint("k", "a", "c", "continuous", '<mimic joint="j"/>')
    )
    assert "k does not follow j" in plan.notes[0]


@pytest.mark.parametrize("shape", ['<box size="1 0 1"/>', '<sphere radius="-1"/>'])
def test_a_shape_without_an_inside_is_left_out(plan_text, shape):
    plan = plan_text(link("a", f"{HEAVY}<collision><geometry>{shape}</geometry></collision>"))
    assert not plan.bodies["a"].shapes
    assert "left out" in plan.notes[0]


def test_a_mesh_that_is_not_there_is_a_box(plan_text):
    mesh = '<collision><geometry><mesh filename="package://nowhere/a.stl"/></geometry></collision>'
    plan = plan_text(link("a", HEAVY + mesh))
    assert plan.bodies["a"].shapes[0].solid.size == (0.1, 0.1, 0.1)
    assert "stood in for by a box" in plan.notes[0]


def test_two_parents_of_a_link_are_one(plan_text):
    plan = plan_text(
        link("a") + link("b") + link("c")
        + joint("ab", "a", "b", "continuous")
        + joint("ac", "a", "c", "continuous")
        + joint("bc", "b", "c", "continuous")
    )  # fmt: skip
    assert plan.joints["bc"].child == "c"
    assert "ac" not in plan.joints


def test_a_long_chain_is_planned(plan_text):
    count = 1000
    text = "".join(link(f"l{i}") for i in range(count))
    text += "".join(joint(f"j{i}", f"l{i}", f"l{i + 1}") for i in range(count - 1))
    plan = plan_text(text)
    assert plan.bodies["l0"].body.mass == pytest.approx(count)
