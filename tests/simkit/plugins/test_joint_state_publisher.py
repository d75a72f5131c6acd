"""The plugin that tells where joints stand."""

from __future__ import annotations

import itertools
import math

import pytest

from simkit.graph import LogLevel
from tests.simkit.plugins.samples import PENDULUM, Sample

SAMPLE = Sample(robot=PENDULUM, tags={"jointName": "swing"}, rate_tag="updateRate")

STATES = "sensor_msgs/JointState"
FILENAME = "libgazebo_ros_joint_state_publisher.so"


@pytest.fixture
def arm(stage, link):
    """Spawns an arm of two joints that turn, with one that is fixed, and a plugin that says these tags."""

    def make(joints="hip, shoulder", more="", **options):
        jointed = "".join(
            f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
            f'<axis xyz="0 0 1"/></joint>'
            for name, kind, parent, child in [
                ("weld", "fixed", "world", "base"),
                ("hip", "continuous", "base", "torso"),
                ("shoulder", "continuous", "torso", "hand"),
            ]
        )
        named = "" if joints is None else f"<jointName>{joints}</jointName>"
        return stage.spawn(
            f'<link name="world"/>{link("base")}{link("torso", "")}{link("hand", "")}{jointed}\n'
            f'<gazebo><plugin name="states" filename="{FILENAME}">\n{named}\n{more}</plugin></gazebo>',
            name="arm",
            **options,
        )

    return make


def test_it_tells_positions_and_velocities_in_the_order_of_the_list(stage, arm):
    model = arm("shoulder, hip").model
    heard = stage.listen("/joint_states", STATES)
    model.joint("hip").command_velocity(2.0)
    stage.run(0.1)
    last = heard[-1]
    assert last.name == ["shoulder", "hip"]
    assert last.position[1] > 0.1
    assert last.velocity == pytest.approx([-2.0, 2.0], abs=1e-6)  # the hand does not turn
    assert list(last.effort) == []
    assert last.header.frame_id == ""


def test_it_tells_what_is_so_at_the_time_of_the_stamp(stage, arm):
    model = arm("hip", "<updateRate>50</updateRate>").model
    truth = {}
    hip, executor = model.joint("hip"), stage.graph.executor
    stage.gazebo.world.after_step.append(
        lambda: truth.update({executor.now_ns: (hip.position, hip.velocity)})
    )
    hip.command_effort(0.1)
    heard = stage.listen("/joint_states", STATES)
    stage.run(0.07)
    assert [message.header.stamp.to_nsec() for message in heard] == [
        21_000_000,
        41_000_000,
        61_000_000,
    ]
    for message in heard:
        told = (message.position[0], message.velocity[0])
        assert told == truth[message.header.stamp.to_nsec()]


def test_positions_are_counted_on_through_whole_turns(stage, arm):
    arm("hip").model.joint("hip").command_velocity(-20.0)
    heard = stage.listen("/joint_states", STATES)
    stage.run(0.5)
    assert heard[-1].position[0] < -2.0 * math.pi
    assert all(
        after.position[0] < before.position[0] for before, after in itertools.pairwise(heard)
    )


@pytest.mark.parametrize("joints", ["hip,shoulder", " hip , shoulder ", "\n  hip, shoul der\n"])
def test_spaces_do_not_count(stage, arm, joints):
    arm(joints)
    heard = stage.listen("/joint_states", STATES)
    stage.run(0.02)
    assert heard[0].name == ["hip", "shoulder"]


def test_a_line_break_in_the_list_spoils_a_name_as_in_gazebo(stage, arm):
    spawned = arm("hip,\nshoulder")
    (complaint,) = stage.said(LogLevel.ERROR)
    assert "Joint shoulder does not exist!" in complaint
    assert "write it in one line" in complaint
    assert spawned.plugins == ()


@pytest.mark.parametrize(
    ("joint", "remedy"),
    [("hipp", "Did you mean hip?"), ("weld", "that move"), ("", "a comma too many")],
)
def test_a_joint_that_is_not_there_or_does_not_move_keeps_the_plugin_away(
    stage, arm, joint, remedy
):
    spawned = arm(f"shoulder,{joint}")
    (complaint,) = stage.said(LogLevel.ERROR)
    assert complaint.startswith("arm.urdf:3:")
    assert f"Joint {joint or repr('')} does not exist!" in complaint
    assert remedy in complaint
    assert "hip, shoulder" in complaint
    assert spawned.plugins == ()


def test_without_a_list_there_is_no_plugin(stage, arm):
    spawned = arm(None)
    assert "<jointName>" in stage.said(LogLevel.ERROR)[0]
    assert spawned.plugins == ()


def test_a_rate_that_is_missing_is_told(stage, arm):
    arm()
    assert (
        "GazeboRosJointStatePublisher Plugin (ns = //): missing <updateRate> default is 100"
        in stage.said()
    )
    heard = stage.listen("/joint_states", STATES)
    stage.run(0.1)
    assert [message.header.stamp.to_nsec() // 1_000_000 for message in heard][:3] == [11, 21, 31]


def test_it_says_which_joints_it_will_tell_of(stage, arm):
    arm()
    said = stage.said(LogLevel.INFO)
    assert [
        f"is going to publish joint: {name}" in text
        for name, text in zip(
            ("hip", "shoulder"), [text for text in said if "going to" in text], strict=True
        )
    ] == [True, True]


@pytest.mark.parametrize(
    ("namespace", "topic"),
    [("/", "/joint_states"), ("/one", "/one/joint_states"), (None, "/arm/joint_states")],
)
def test_its_topic_is_in_the_namespace_of_the_robot(stage, arm, namespace, topic):
    arm(namespace=namespace)
    heard = stage.listen(topic, STATES)
    stage.run(0.02)
    assert len(heard) == 1
