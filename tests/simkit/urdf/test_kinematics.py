"""Forward kinematics: laws, known numbers, and an independent library on random trees."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pytransform3d.urdf import UrdfTransformManager

from simkit.errors import SimkitError, UnknownNameError
from simkit.tf.transformations import quaternion_matrix
from simkit.urdf import Pose, UrdfError, load_robot
from simkit.urdf.kinematics import forward_kinematics, joint_positions, joint_transform

SETTINGS = settings(max_examples=25, derandomize=True, database=None)
TYPES = ("fixed", "revolute", "continuous", "prismatic")


def matrix(placement):
    found = quaternion_matrix(placement.rotation)
    found[:3, 3] = placement.translation
    return found


def numbers(values):
    return " ".join(repr(value) for value in values)


def joint_xml(name, type_, inner="", ends=("a", "b")):
    return (
        f'<joint name="{name}" type="{type_}"><parent link="{ends[0]}"/><child link="{ends[1]}"/>'
        f'<limit lower="-9" upper="9" effort="1" velocity="1"/>{inner}</joint>'
    )


def one_joint(robot, type_, inner=""):
    return robot('<link name="a"/><link name="b"/>' + joint_xml("j", type_, inner)).joints["j"]


def random_tree(rng):
    """The text of a robot, and positions of its moving joints."""
    text, positions = '<link name="l0"/>', {}
    for number in range(1, rng.randint(2, 12)):
        type_ = rng.choice(TYPES)
        xyz = numbers(rng.uniform(-2, 2) for _ in range(3))
        rpy = numbers(rng.uniform(-4, 4) for _ in range(3))
        axis = numbers(rng.uniform(-1, 1) for _ in range(3))
        inner = f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>'
        if type_ != "fixed":
            positions[f"j{number}"] = rng.uniform(-5, 5)
        parent = f"l{rng.randrange(number)}"
        text += f'<link name="l{number}"/>'
        text += joint_xml(f"j{number}", type_, inner, (parent, f"l{number}"))
    return f'<robot name="r">{text}</robot>', positions


@SETTINGS
@given(st.integers(0, 10**6))
def test_an_independent_library_agrees_on_random_trees(seed):
    rng = random.Random(seed)
    text, positions = random_tree(rng)
    peer = UrdfTransformManager()
    peer.load_urdf(text)
    for name, position in positions.items():
        peer.set_joint(name, position)
    robot = load_robot(text, file="r.urdf")
    frame = rng.choice(list(robot.links))
    for link, placement in forward_kinematics(robot, positions, frame=frame).items():
        assert np.allclose(matrix(placement), peer.get_transform(link, frame), atol=1e-9)


@SETTINGS
@given(st.integers(0, 10**6))
def test_composition_and_inverse(seed):
    rng = random.Random(seed)
    a, b, c = (
        Pose(*[tuple(rng.uniform(-4, 4) for _ in range(3)) for _ in range(2)]).transform
        for _ in range(3)
    )
    identity = matrix(a @ a.inverse())
    assert np.allclose(identity, np.eye(4), atol=1e-12)
    assert np.allclose(matrix(a @ b), matrix(a) @ matrix(b), atol=1e-12)
    left, right = a @ b @ c, a @ (b @ c)
    assert np.allclose(matrix(left), matrix(right), atol=1e-12)


def test_every_frame_sees_the_same_robot(robots):
    text = (robots / "hello_ros_robot_3.urdf").read_text(encoding="utf-8")
    robot = load_robot(text, file="r.urdf")
    positions = {"hip": 0.3, "shoulder": -0.5}
    from_root = forward_kinematics(robot, positions)
    for frame in robot.links:
        seen = forward_kinematics(robot, positions, frame=frame)
        assert list(seen) == ["world", "base_link", "torso", "upper_arm"]
        for link in robot.links:
            there = from_root[frame] @ seen[link]
            assert np.allclose(matrix(there), matrix(from_root[link]), atol=1e-12)


def test_the_shoulder_has_the_numbers_of_robot_state_publisher(robots):
    text = (robots / "hello_ros_robot_3.urdf").read_text(encoding="utf-8")
    robot = load_robot(text, file="r.urdf")
    placement = joint_transform(robot.joints["shoulder"], 0.0)
    assert placement.translation == (0.0, -0.1, 0.45)
    assert placement.rotation == pytest.approx((0.0, 0.70710808, 0.0, 0.70710548), abs=1e-8)


def test_the_tip_of_the_upper_arm(robots):
    """By hand: the arm of 0.4 m lies in the plane that the hip turns, 0.1 m beside the torso."""
    text = (robots / "hello_ros_robot_3.urdf").read_text(encoding="utf-8")
    robot = load_robot(text, file="r.urdf")
    hip, shoulder = 0.7, -0.4
    arm = matrix(forward_kinematics(robot, {"hip": hip, "shoulder": shoulder})["upper_arm"])
    pitch = shoulder + 1.5708
    reach, height = 0.4 * math.sin(pitch), 0.05 + 0.45 + 0.4 * math.cos(pitch)
    x = math.cos(hip) * reach + math.sin(hip) * 0.1
    y = math.sin(hip) * reach - math.cos(hip) * 0.1
    assert (arm @ [0, 0, 0.4, 1])[:3] == pytest.approx((x, y, height), abs=1e-9)


def test_an_axis_counts_by_its_direction_only(robot):
    short = one_joint(robot, "revolute", '<axis xyz="0 0.001 0"/>')
    long = one_joint(robot, "revolute", '<axis xyz="0 1000 0"/>')
    assert joint_transform(short, 0.6).rotation == pytest.approx(
        joint_transform(long, 0.6).rotation
    )
    slide = one_joint(robot, "prismatic", '<axis xyz="0 0 -2"/>')
    assert joint_transform(slide, 0.6).translation == pytest.approx((0.0, 0.0, -0.6))


def test_without_an_axis_it_is_x_and_an_axis_of_zeros_moves_nothing(robot):
    half = math.sqrt(0.5)
    quarter = joint_transform(one_joint(robot, "continuous"), math.pi / 2)
    assert quarter.rotation == pytest.approx((half, 0.0, 0.0, half))
    for inner in ('<axis xyz="0 0 0"/>', "<axis/>"):
        for type_ in ("continuous", "prismatic"):
            still = joint_transform(one_joint(robot, type_, inner), 1.0)
            assert still == ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


@pytest.mark.parametrize("type_", ["fixed", "floating", "planar"])
def test_joints_without_one_number_stand_at_their_origin(robot, type_):
    joint = one_joint(robot, type_, '<origin xyz="1 2 3" rpy="0 0 1"/>')
    assert joint_transform(joint, 0.8) == joint.origin.transform


def test_signs_are_those_of_a_rotation_matrix(robot):
    joint = one_joint(robot, "continuous", '<axis xyz="0 0 1"/>')
    for turns in range(-3, 4):
        rotation = joint_transform(joint, 0.4 + 2 * math.pi * turns).rotation
        assert rotation == pytest.approx((0.0, 0.0, math.sin(0.2), math.cos(0.2)))


def test_a_position_that_is_no_number_gives_none(robot):
    joint = one_joint(robot, "continuous")
    assert all(math.isnan(value) for value in joint_transform(joint, math.inf).rotation)


def mimics(robot, *tags):
    """Joints a, b, c, ... one below the other, each with a mimic tag or none."""
    names = "abcdef"[: len(tags)]
    text = '<link name="l0"/>'
    for number, (name, tag) in enumerate(zip(names, tags, strict=True), 1):
        ends = (f"l{number - 1}", f"l{number}")
        text += f'<link name="l{number}"/>' + joint_xml(name, "continuous", tag, ends)
    return robot(text)


def test_mimic_joints_follow_over_any_chain(robot):
    found = mimics(
        robot,
        '<mimic joint="b" multiplier="2"/>',
        '<mimic joint="c" offset="0.5"/>',
        "",
        '<mimic joint="a" multiplier="-1" offset="1"/>',
    )
    assert joint_positions(found, {"c": 0.25}) == {"a": 1.5, "b": 0.75, "c": 0.25, "d": -0.5}
    assert joint_positions(found, {}) == {"a": 1.0, "b": 0.5, "c": 0.0, "d": 0.0}
    assert joint_positions(found, {"b": 3.0})["a"] == 6.0


def test_mimic_of_an_unknown_joint_takes_it_for_zero(robot):
    assert joint_positions(mimics(robot, '<mimic joint="zz" offset="0.5"/>'), {}) == {"a": 0.5}


def test_mimic_in_a_circle_is_named(robot):
    found = mimics(robot, '<mimic joint="b"/>', '<mimic joint="a"/>')
    with pytest.raises(UrdfError, match="mimic each other in a circle: a -> b -> a"):
        forward_kinematics(found, {})
    assert joint_positions(found, {"a": 1.0}) == {"a": 1.0, "b": 1.0}


def test_unknown_names_are_refused_with_near_ones(robots):
    text = (robots / "hello_ros_robot_3.urdf").read_text(encoding="utf-8")
    robot = load_robot(text, file="r.urdf")
    with pytest.raises(UnknownNameError, match="no joint 'sholder'; did you mean 'shoulder'"):
        forward_kinematics(robot, {"sholder": 1.0})
    with pytest.raises(SimkitError, match="no link 'upperarm'; did you mean 'upper_arm'"):
        forward_kinematics(robot, {}, frame="upperarm")


def test_of_two_joints_above_a_link_the_last_one_by_name_counts(robot):
    found = robot(
        '<link name="a"/><link name="b"/>'
        '<joint name="k" type="fixed"><parent link="a"/><child link="b"/><origin xyz="2 0 0"/></joint>'
        '<joint name="j" type="fixed"><parent link="a"/><child link="b"/><origin xyz="1 0 0"/></joint>'
    )
    assert forward_kinematics(found, {})["b"].translation == (2.0, 0.0, 0.0)
    joint = found.joint_above("b")
    assert joint is not None
    assert joint.name == "k"


def test_links_in_a_circle_beside_the_tree_are_left_out(robot):
    found = robot(
        '<link name="a"/><link name="b"/><link name="c"/>'
        '<joint name="j" type="fixed"><parent link="b"/><child link="c"/></joint>'
        '<joint name="k" type="fixed"><parent link="c"/><child link="b"/></joint>'
    )
    assert list(forward_kinematics(found, {})) == ["a"]


def test_a_long_chain_stays_exact(robot):
    count = 500
    step = '<origin xyz="0 0 1" rpy="0 0 0.1"/>'
    text = "".join(f'<link name="l{number}"/>' for number in range(count + 1))
    for number in range(count):
        ends = (f"l{number}", f"l{number + 1}")
        text += joint_xml(f"j{number}", "fixed", step, ends)
    last = forward_kinematics(robot(text), {})[f"l{count}"]
    assert last.translation == pytest.approx((0, 0, count))
    half = 0.1 * count / 2
    _, _, z, w = last.rotation
    assert abs(z * math.sin(half) + w * math.cos(half)) == pytest.approx(1.0)
