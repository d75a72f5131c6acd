from __future__ import annotations

import math

import pytest

FIXED = '<joint name="f" type="fixed">{}</joint>'
FLOATING = '<joint name="g" type="floating">{}</joint>'
PLANAR = '<joint name="h" type="planar">{}</joint>'
ENDLESS = '<joint name="e" type="revolute">{}<limit effort="1" velocity="1"/></joint>'


def test_joints_that_move_are_named_in_the_order_of_the_file(stage):
    stage.load(stage.turning("b"), FIXED, stage.turning("a"), FLOATING, PLANAR)
    stage.start()
    assert list(stage.state()) == ["b", "a"]


def test_a_joint_begins_at_zero_or_in_the_middle_of_its_range_or_where_zeros_says(stage):
    stage.load(
        stage.limited("around", -1, 3),
        stage.limited("above", 1, 2),
        stage.limited("below", -3, -1),
        stage.limited("told", -1, 1),
        zeros={"told": 0.25, "nobody": 7},
    )
    stage.start()
    assert stage.state() == {"around": 0.0, "above": 1.5, "below": -2.0, "told": 0.25}


def test_soft_limits_narrow_the_range_unless_they_are_switched_off(stage):
    soft = '<safety_controller soft_lower_limit="0.5" soft_upper_limit="1.5" k_velocity="1"/>'
    stage.load(stage.limited("a", -1, 2, soft))
    assert stage.start(gui=True).program.joints[0].lower == 0.5
    stage.load(stage.limited("a", -1, 2, soft), use_smallest_joint_limits=False)
    (joint,) = stage.start(gui=True).program.joints
    assert (joint.lower, joint.upper) == (-1.0, 2.0)


def test_a_continuous_joint_has_half_a_turn_to_each_side(stage):
    stage.load(stage.turning("a", '<limit effort="1" velocity="1"/>'))
    (joint,) = stage.start(gui=True).program.joints
    assert (joint.lower, joint.upper, joint.unit) == (-math.pi, math.pi, "rad")


def test_a_joint_without_a_range_ends_the_node_as_in_ros(stage):
    stage.load(stage.turning("a"), ENDLESS)
    node = stage.start()
    stage.sim.run(0.1)
    warning = "e is not fixed, nor continuous, but limits are not specified!"
    assert stage.said("WARN") == [warning]
    assert node.exit_code == 1
    assert node.output == "TypeError: argument of type 'NoneType' is not iterable\n"
    assert stage.said("ERROR")[0].startswith("joint e has no range: <limit lower=")
    assert stage.states["/joint_states"] == []


def test_a_joint_without_a_range_and_nothing_else_to_say_is_only_named(stage):
    stage.load(ENDLESS)
    node = stage.start()
    stage.sim.run(0.1)
    latest = stage.sim.latest("/joint_states")
    assert node.alive
    assert (list(latest.name), list(latest.position)) == (["e"], [])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "<robot name='r'>\n<link name='a'></lnk></robot>",
            "xml.parsers.expat.ExpatError: mismatched tag: line 2, column 17",
        ),
        ("", "xml.parsers.expat.ExpatError: no element found: line 1, column 0"),
        (
            "<robot name='r'><xacro:a/></robot>",
            "xml.parsers.expat.ExpatError: unbound prefix: line 1, column 16",
        ),
        ("<launch/>", "IndexError: list index out of range"),
    ],
)
def test_what_is_not_a_robot_ends_the_node_with_the_words_of_python(stage, text, said):
    stage.sim.params.set("/robot_description", text)
    node = stage.start()
    assert (node.alive, node.exit_code, node.output) == (False, 1, f"{said}\n")
    assert stage.said("ERROR")[0].startswith("robot_description ")


def test_entities_are_refused_before_they_grow(stage):
    bombs = "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 9))
    text = f'<!DOCTYPE r [<!ENTITY e0 "x">{bombs}]><robot name="r">&e8;</robot>'
    stage.sim.params.set("/robot_description", text)
    node = stage.start()
    assert node.exit_code == 1
    assert "defines an entity, 'e0'" in stage.said("ERROR")[0]


@pytest.mark.parametrize(
    ("inside", "said"),
    [
        (
            '<mimic joint="a" multiplier="two"/>',
            "ValueError: could not convert string to float: 'two'",
        ),
        (
            '<safety_controller soft_lower_limit="x"/>',
            "ValueError: could not convert string to float: 'x'",
        ),
    ],
)
def test_a_number_that_is_none_ends_the_node(stage, inside, said):
    stage.load(stage.turning("a"), stage.limited("b", -1, 1, inside))
    node = stage.start()
    assert (node.exit_code, node.output) == (1, f"{said}\n")
    assert stage.said("ERROR")[0].startswith("joint b: ")
