from __future__ import annotations

import math

import pytest

from simkit import SimkitError, Simulation, UnknownNameError
from simkit.nodes.joint_state_publisher import JointStatePublisherGui
from simkit.nodes.joint_state_publisher.gui import STEPS


@pytest.fixture
def gui(stage):
    prismatic = '<joint name="lift" type="prismatic">{}<limit lower="0" upper="0.5"/></joint>'
    stage.load(
        stage.turning("hip"),
        stage.limited("elbow", -1, 2),
        stage.limited("locked", 0.5, 0.5),
        stage.turning("twin", '<mimic joint="hip"/>'),
        prismatic,
    )
    return stage.start(gui=True).program


def test_each_free_joint_with_room_to_move_has_a_slider(gui):
    assert [(joint.name, joint.unit) for joint in gui.joints] == [
        ("hip", "rad"),
        ("elbow", "rad"),
        ("lift", "m"),
    ]
    assert gui.title == "Node: /joint_state_publisher_gui"


def test_a_position_is_told_exactly_with_the_next_message(stage, gui):
    gui.set_position("hip", 0.123456789)
    assert stage.state() == {
        "hip": 0.123456789,
        "elbow": pytest.approx(0.0, abs=3e-4),
        "locked": 0.5,
        "twin": 0.123456789,
        "lift": 0.0,
    }


@pytest.mark.parametrize("value", [2.1, -1.1, math.nan, math.inf])
def test_a_position_beyond_the_slider_is_refused(gui, value):
    with pytest.raises(SimkitError, match=r"its slider goes from -1 to 2 rad"):
        gui.set_position("elbow", value)


def test_a_joint_that_has_no_slider_is_named(gui):
    with pytest.raises(UnknownNameError, match=r"'hipp'; did you mean 'hip'\?"):
        gui.set_position("hipp", 0.0)
    with pytest.raises(UnknownNameError):
        gui.set_position("twin", 0.0)


def test_center_puts_each_slider_on_the_step_at_or_below_its_zero(stage, gui):
    gui.set_position("elbow", 1.0)
    gui.center()
    elbow = gui.joints[1].position
    assert elbow == -1 + 3 * 3333 / STEPS
    assert gui.joints[0].position == 0.0
    assert stage.said("INFO") == ["Centering", "Centering"]


def test_random_positions_are_steps_in_the_range_and_come_from_the_seed():
    def draw(seed, name):
        with Simulation(seed, screen=None) as sim:
            sim.params.set("/robot_description", ROBOT)
            words = ("joint_state_publisher_gui", "joint_state_publisher_gui", f"__name:={name}")
            gui = sim.rosrun(*words).program
            gui.randomize()
            first = [joint.position for joint in gui.joints]
            gui.randomize()
            for joint in gui.joints:
                step = (joint.position - joint.lower) * STEPS / (joint.upper - joint.lower)
                assert 0 <= step <= STEPS
                assert step == pytest.approx(round(step), abs=1e-6)
            return [*first, *(joint.position for joint in gui.joints)]

    assert draw(1, "a") == draw(1, "a")
    draws = [tuple(draw(seed, name)) for seed, name in ((1, "a"), (2, "a"), (1, "b"))]
    assert len(set(draws)) == 3
    assert len(set(draws[0])) == 4


ROBOT = """<robot name="r"><link name="a"/><link name="b"/><link name="c"/>
<joint name="hip" type="continuous"><parent link="a"/><child link="b"/></joint>
<joint name="knee" type="continuous"><parent link="b"/><child link="c"/></joint></robot>"""


def test_sources_move_the_sliders_too(stage):
    stage.load(stage.turning("hip"), source_list=["moves"])
    gui = stage.start(gui=True).program
    stage.sim.rostopic_pub("/moves", "sensor_msgs/JointState", "{name: [hip], position: [0.7]}")
    stage.sim.run(0.1)
    assert gui.joints[0].position == 0.7


def test_in_a_terminal_a_topic_moves_the_joints(stage, gui):
    gui.listen()
    first, line = stage.said("WARN")[-1].splitlines()
    assert first == (
        "hint: there is no window with sliders here, as there is in a notebook; "
        "to move hip, elbow, lift, in another terminal:"
    )
    assert line == (
        "  simkit rostopic pub -1 /joint_state_publisher_gui/move sensor_msgs/JointState "
        '"{name: [hip], position: [0.5]}"'
    )
    stage.sim.rostopic_pub(*line.split()[4:6], line.split('"')[1])
    assert stage.state()["hip"] == 0.5
    stage.sim.rostopic_pub(
        "/joint_state_publisher_gui/move",
        "sensor_msgs/JointState",
        "{name: [elbow, hip, tail], position: [9.0, 1.0, 0.0]}",
    )
    assert stage.state()["hip"] == 1.0
    assert [text.split()[0] for text in stage.said("ERROR")] == ["elbow", "no"]


def test_nobody_listens_where_nothing_can_be_moved(stage):
    stage.load('<joint name="f" type="fixed">{}</joint>')
    gui = stage.start(gui=True).program
    gui.listen()
    assert (gui.joints, stage.said("WARN")) == ((), [])
    broken = stage.start("_robot_description:=x", "__name:=b", gui=True).program
    broken.listen()
    assert (broken.joints, broken.alive) == ((), False)


@pytest.mark.parametrize("words", [["_use_gui:=true"], []])
def test_use_gui_brings_the_sliders_and_a_word_on_what_is_modern(stage, words):
    stage.load(stage.turning("hip"), **({} if words else {"use_gui": True}))
    node = stage.start(*words)
    assert isinstance(node.program, JointStatePublisherGui)
    assert node.program.title == "Node: /joint_state_publisher"
    (warning,) = stage.said("WARN")
    assert warning.startswith("The 'use_gui' parameter was specified, which is deprecated.")
    assert "joint_state_publisher_gui of the package joint_state_publisher_gui" in warning


def test_without_use_gui_there_are_no_sliders_and_no_word(stage):
    stage.load(stage.turning("hip"), use_gui=False)
    node = stage.start()
    assert not isinstance(node.program, JointStatePublisherGui)
    assert stage.said("WARN") == []
