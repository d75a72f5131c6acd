from __future__ import annotations

import pytest


def test_messages_come_ten_times_a_second_from_the_start_on(stage):
    stage.load(stage.turning("hip"), stage.turning("shoulder"))
    node = stage.start()
    begin = stage.sim.now
    stage.sim.run(1.0)
    heard = stage.states["/joint_states"]
    assert node.name == "/joint_state_publisher"
    assert [(time - begin).to_nsec() for time, _ in heard] == [n * 10**8 for n in range(11)]
    for time, message in heard:
        assert message.header.stamp == time
        assert message.header.frame_id == ""
        assert list(message.name) == ["hip", "shoulder"]
        assert list(message.position) == [0.0, 0.0]
        assert list(message.velocity) == list(message.effort) == []


def test_a_robot_without_joints_is_passed_over_in_silence(stage):
    stage.load('<joint name="f" type="fixed">{}</joint>')
    node = stage.start()
    stage.sim.run(1.0)
    assert node.alive
    assert stage.states["/joint_states"] == []


def test_a_node_that_is_shut_down_at_its_start_says_nothing(stage):
    stage.load(stage.turning("a"))
    stage.start().shutdown()
    stage.sim.run(1.0)
    assert stage.states["/joint_states"] == []


def mimic(joint, **numbers):
    words = " ".join(f'{name}="{value}"' for name, value in numbers.items())
    return f'<mimic joint="{joint}" {words}/>'


def test_those_who_mimic_follow_through_chains(stage):
    stage.load(
        stage.turning("c", mimic("b", multiplier=-1, offset=0.5)),
        stage.turning("b", mimic("a", multiplier=2, offset=0.25)),
        stage.turning("a"),
        zeros={"a": 0.5},
    )
    stage.start()
    assert stage.state() == {"c": -0.75, "b": 1.25, "a": 0.5}


def test_without_mimic_tags_all_are_free(stage):
    stage.load(stage.turning("b", mimic("a")), stage.turning("a"), use_mimic_tags=False)
    assert [joint.name for joint in stage.start(gui=True).program.joints] == ["b", "a"]


def test_parameters_make_joints_follow_too(stage):
    stage.load(
        stage.turning("a"),
        stage.turning("b"),
        dependent_joints={"b": {"parent": "a", "factor": 3.0, "offset": -1.0}},
        zeros={"a": 1.0},
    )
    stage.start()
    assert stage.state() == {"a": 1.0, "b": 2.0}


def test_a_follower_that_is_in_no_file_makes_the_message_invalid_as_in_ros(stage):
    stage.load(stage.turning("a"), dependent_joints={"ghost": {"parent": "a"}})
    stage.start()
    stage.sim.run(0.1)
    latest = stage.sim.latest("/joint_states")
    assert (list(latest.name), list(latest.position)) == (["a"], [0.0, 0.0])


@pytest.mark.parametrize(
    ("followed", "chain"),
    [({"a": "b", "b": "a"}, "a, b, a"), ({"a": "a", "b": "a"}, "a, a")],
)
def test_a_chain_without_an_end_is_told(stage, followed, chain):
    stage.load(*(stage.turning(name, mimic(master)) for name, master in followed.items()))
    node = stage.start()
    assert node.exit_code == 1
    assert stage.said("ERROR") == [f"Found an infinite recursive mimic chain: [{chain}]"]


def test_a_master_that_does_not_exist_is_told(stage):
    stage.load(stage.turning("a", mimic("hp")))
    node = stage.start()
    assert (node.exit_code, node.output) == (1, "KeyError: 'hp'\n")
    assert stage.said("ERROR") == ["joint a follows 'hp', but no joint of that name moves"]


def test_a_name_that_stands_twice_is_told(stage):
    stage.load(stage.turning("a"), stage.turning("a"))
    node = stage.start()
    stage.sim.run(0.1)
    assert node.output == "IndexError: list assignment index out of range\n"
    assert stage.said("ERROR")[0].startswith("two joints are named a")


def test_sources_move_free_joints_and_nothing_else(stage):
    stage.load(
        stage.turning("a"),
        stage.turning("b", mimic("a", multiplier=2)),
        stage.turning("c"),
        source_list=["moves"],
    )
    stage.start()
    stage.sim.rostopic_pub(
        "/moves",
        "sensor_msgs/JointState",
        {"name": ["a", "b", "x"], "position": [0.5, 9.0, 1.0], "velocity": [0.1, 0.0, 0.0]},
    )
    assert stage.state() == {"a": 0.5, "b": 1.0, "c": 0.0}
    assert list(stage.sim.latest("/joint_states").velocity) == [0.1, 0.2, 0.0]


def test_what_is_published_of_a_joint_that_nobody_moved(stage):
    stage.load(
        stage.turning("a"),
        publish_default_positions=False,
        publish_default_velocities=True,
        publish_default_efforts=True,
    )
    stage.start()
    stage.sim.run(0.1)
    latest = stage.sim.latest("/joint_states")
    assert [list(column) for column in (latest.position, latest.velocity, latest.effort)] == [
        [],
        [0.0],
        [0.0],
    ]


def test_a_sweep_goes_to_and_fro_and_round_and_round(stage):
    stage.load(stage.limited("a", 0, 1), stage.turning("b"), delta=0.4)
    stage.start()
    stage.sim.run(1.0)
    messages = [message for _, message in stage.states["/joint_states"]]
    assert [message.position[0] for message in messages[:8]] == pytest.approx(
        [0.4, 0.8, 1.0, 0.6, 0.2, 0.0, 0.4, 0.8]
    )
    assert [message.position[1] for message in messages[6:9]] == pytest.approx(
        [2.8, -3.14159265, -2.74159265]
    )


def test_a_long_chain_takes_no_long_time(stage):
    followers = [stage.turning(f"j{n}", mimic(f"j{n + 1}", offset=1)) for n in range(3000)]
    stage.load(*followers, stage.turning("j3000"), zeros={"j3000": 0.5})
    stage.start()
    assert stage.state()["j0"] == 3000.5
