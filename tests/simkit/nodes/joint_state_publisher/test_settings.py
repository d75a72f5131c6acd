from __future__ import annotations

import pytest


def test_without_a_robot_it_ends_with_the_words_of_python(stage):
    node = stage.start()
    assert (node.alive, node.exit_code) == (False, 1)
    assert node.output == "RuntimeError: The robot_description parameter is required and not set.\n"
    assert "textfile='$(find my_package)/urdf/my_robot.urdf'" in stage.said("ERROR")[0]


def test_a_private_parameter_comes_before_one_of_the_namespace(stage):
    stage.load(stage.turning("a"), rate=1)
    stage.start("_rate:=50")
    stage.sim.run(1.0)
    assert len(stage.states["/joint_states"]) == 51


def test_the_namespace_is_not_searched_further_out(stage):
    stage.load(stage.turning("a"))
    node = stage.start("__ns:=/lab")
    assert node.exit_code == 1
    stage.sim.params.set("/lab/robot_description", stage.robot(stage.turning("b")))
    stage.start("__ns:=/lab")
    stage.sim.run(0.1)
    assert list(stage.sim.latest("/lab/joint_states").name) == ["b"]


@pytest.mark.parametrize(
    ("parameters", "text"),
    [
        ({"rate": 0}, "the parameter rate must be greater than 0, not 0"),
        ({"rate": "fast"}, "the parameter rate must be a number, not 'fast'"),
        ({"delta": True}, "the parameter delta must be a number, not True"),
        ({"zeros": {"a": "pi/2"}}, "the parameter zeros/a must be a number, not 'pi/2'"),
        ({"zeros": [1.0]}, "the parameter zeros must be a table: {a: 1.0, b: 2.0}, not [1.0]"),
        ({"source_list": "moves"}, "the parameter source_list must be a list: [a, b], not 'moves'"),
        (
            {"dependent_joints": {"a": {"factor": 2}}},
            "the parameter dependent_joints/a must name the joint that is followed: "
            "{parent: other_joint, factor: 1.0, offset: 0.0}",
        ),
        ({"robot_description": {"a": 1}}, "the parameter robot_description must be the text of"),
    ],
)
def test_a_value_of_no_use_ends_the_node_with_a_sentence(stage, parameters, text):
    stage.load(stage.turning("a"), **parameters)
    node = stage.start()
    assert node.exit_code == 1
    assert stage.said("ERROR")[0].startswith(text)
