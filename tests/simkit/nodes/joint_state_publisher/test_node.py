from __future__ import annotations


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
