from __future__ import annotations

import math
import random

import pytest
import yaml
from pytransform3d.urdf import UrdfTransformManager

from simkit import Simulation
from simkit.msgs import Duration, Time
from simkit.urdf import load_robot, reading
from simkit.urdf.kinematics import forward_kinematics


def names(transforms):
    return [(one.header.frame_id, one.child_frame_id) for one in transforms]


def test_fixed_joints_come_once_and_stay(stage):
    stage.load()
    stage.start()
    begin = stage.sim.now
    stage.sim.run(5.0)
    ((time, message),) = stage.messages["/tf_static"]
    assert (time - begin).to_sec() == 0.02
    assert names(message.transforms) == [("world", "base")]
    assert message.transforms[0].header.stamp == time
    late = stage.sim.wait_for_message("/tf_static", timeout=0.1)
    assert names(late.transforms) == [("world", "base")]


def test_fixed_joints_on_tf_are_repeated_and_dated_ahead(stage):
    stage.load()
    stage.start("_use_tf_static:=false", "_publish_frequency:=10")
    stage.sim.run(1.0)
    heard = stage.messages["/tf"]
    assert len(heard) == 10
    for time, message in heard:
        assert names(message.transforms) == [("world", "base")]
        assert message.transforms[0].header.stamp - time == Duration(0, 500_000_000)
    assert stage.heard("/tf_static") == []


def test_the_book_shoulder_at_zero_is_that_of_the_original(stage):
    stage.load()
    stage.start()
    stage.tell(hip=0.0, shoulder=0.0)
    ((hip, shoulder),) = stage.heard()
    assert names([hip, shoulder]) == [("base", "torso"), ("torso", "hand")]
    t, q = shoulder.transform.translation, shoulder.transform.rotation
    assert (t.x, t.y, t.z) == (0.0, -0.1, 0.45)
    assert (q.x, q.y, q.z, q.w) == pytest.approx((0.0, 0.70710808, 0.0, 0.70710548), abs=5e-9)
    assert shoulder.header.stamp == stage.sim.now


def test_only_joints_that_a_message_names_are_sent_in_the_order_of_their_names(stage):
    stage.load()
    stage.start()
    stage.tell(shoulder=0.1, hip=0.2)
    stage.tell(shoulder=0.1)
    stage.sim.run(0.02)
    stage.tell(shoulder=0.1)
    assert [names(one) for one in stage.heard()] == [
        [("base", "torso"), ("torso", "hand")],
        [("torso", "hand")],
    ]


@pytest.mark.parametrize(
    ("period", "words", "rate"),
    [
        (1 / 30, [], 30),
        (1 / 60, [], 30),
        (0.01, [], 50),
        (0.01, ["_publish_frequency:=10"], 10),
        (0.01, ["_publish_frequency:=1000"], 100),
        (0.01, ["_publish_frequency:=0.1"], 1),
        (0.01, ["_ignore_timestamp:=true"], 100),
        (0.01, ["_publish_frequency:=often"], 50),
    ],
)
def test_the_pace_of_tf(stage, period, words, rate):
    stage.load()
    stage.start(*words)
    assert stage.pace(period, 2.0) == pytest.approx(2 * rate, abs=1)


def test_stamps_that_jitter_slow_it_down_as_in_ros(stage):
    stage.load()
    stage.start()
    rng = random.Random(1)
    sent = stage.pace(0.01, 10.0, jitter=lambda: -rng.uniform(0.0, 1e-4))
    assert 370 <= sent <= 420


def test_messages_that_are_passed_over(stage):
    stage.load()
    stage.start()
    stage.tell_raw(["hip", "shoulder"], [1.0])
    stage.tell_raw(["hip"], [])
    stage.tell_raw(["hip"], [])
    stage.tell_raw(["hip"], [1.0], Time(0))
    stage.tell_raw([], [])
    assert stage.heard() == []
    assert stage.said("ERROR") == ["Robot state publisher ignored an invalid JointState message"]
    assert stage.said("WARN") == [
        'Robot state publisher ignored a JointState message about joint(s) "hip"(,...) '
        "whose position member was empty. This message will not reappear for 300 seconds.",
        "Received JointState is 1600088400.000000 seconds old.",
    ]


def test_an_unknown_joint_is_told_every_ten_seconds_and_sends_an_empty_message(stage):
    stage.load()
    stage.start()
    for _ in range(12):
        stage.tell(wrist=1.0)
        stage.sim.run(1.0)
    assert stage.heard() == [[]] * 12
    text = 'Joint state with name: "wrist" was received but not found in URDF'
    assert [one for one in stage.said("WARN") if one.startswith("Joint")] == [text, text]


def test_old_states_count_but_are_told(stage):
    stage.load()
    stage.start()
    stage.tell(stage.sim.now - Duration(31), hip=1.0)
    stage.tell(stage.sim.now - Duration(29), hip=1.0)
    assert len(stage.heard()) == 2
    assert stage.said("WARN") == ["Received JointState is 31.000000 seconds old."]


def test_a_clock_that_was_set_back_is_told_and_does_not_stop_it(stage, monkeypatch):
    stage.load()
    node = stage.start()
    stage.tell(hip=1.0)
    earlier = stage.sim.now - Duration(100)
    monkeypatch.setattr(stage.sim.graph, "now", lambda: earlier)
    stage.tell(earlier, hip=1.0)
    stage.tell(earlier, hip=1.0)
    assert node.alive
    assert len(stage.heard()) == 2
    text = (
        "Moved backwards in time (probably because ROS clock was reset), "
        "re-publishing joint transforms!"
    )
    assert stage.said("WARN").count(text) == 1


def test_joints_that_mimic_move_with_their_master_only(stage):
    follower = '<mimic joint="hip" multiplier="-2" offset="0.5"/></joint>\n  <joint name="hip"'
    stage.load(stage.arm.replace('</joint>\n  <joint name="hip"', follower))
    stage.start()
    stage.tell(hip=0.25)
    stage.sim.run(0.1)
    stage.tell(hip=0.25, shoulder=1.0)
    followed, told = stage.heard()
    assert names(followed) == [("base", "torso"), ("torso", "hand")]
    half = [one[1].transform.rotation for one in (followed, told)]
    about_y = [2 * math.atan2(q.y, q.w) - 1.5708 for q in half]
    assert about_y == pytest.approx([0.0, 1.0])


@pytest.mark.parametrize("where", ["/tf_prefix", "/robot_state_publisher/tf_prefix"])
def test_a_prefix_is_put_before_all_frames(stage, where):
    stage.load()
    stage.sim.params.set(where, "left")
    stage.start()
    stage.sim.run(0.1)
    stage.tell(hip=0.0)
    assert names(stage.heard("/tf_static")[0]) == [("left/world", "left/base")]
    assert names(stage.heard()[0]) == [("left/base", "left/torso")]


def test_after_two_seconds_without_positions_a_hint_comes_once(stage):
    stage.load()
    stage.start()
    stage.sim.run(1.9)
    assert stage.said("WARN") == []
    stage.sim.run(20.0)
    assert stage.said("WARN") == [
        "hint: nobody publishes /joint_states, so hip, shoulder have no position, and no "
        "transform: start joint_state_publisher, or joint_state_publisher_gui for sliders"
    ]


def test_a_robot_that_does_not_move_needs_no_hint(stage):
    stage.load('<robot name="r"><link name="a"/></robot>')
    stage.start()
    stage.sim.run(5.0)
    assert stage.said("WARN") == []
    assert stage.heard("/tf_static") == [[]]


def test_the_old_name_of_the_program_is_deprecated(stage):
    stage.load()
    node = stage.sim.rosrun("robot_state_publisher", "state_publisher")
    assert (node.name, node.alive) == ("/robot_state_publisher", True)
    assert stage.said("WARN") == [
        "The 'state_publisher' executable is deprecated. Please use 'robot_state_publisher' instead"
    ]


# -- laws


def random_robot(rng: random.Random, joints: int) -> str:
    """A tree of links with joints of all kinds that have a position, and some that are fixed."""
    parts = ['<link name="l0"/>']
    for number in range(joints):
        kind = rng.choice(["fixed", "revolute", "continuous", "prismatic"])
        xyz, rpy, axis = (" ".join(f"{rng.uniform(-2, 2):.6f}" for _ in range(3)) for _ in "abc")
        parts.append(
            f'<link name="l{number + 1}"/><joint name="j{number}" type="{kind}">'
            f'<parent link="l{rng.randrange(number + 1)}"/><child link="l{number + 1}"/>'
            f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>'
            '<limit lower="-9" upper="9" effort="1" velocity="1"/></joint>'
        )
    return f'<robot name="r">{"".join(parts)}</robot>'


@pytest.mark.parametrize("seed", range(12))
def test_frames_agree_with_two_other_ways_to_compute_them(stage, seed):
    rng = random.Random(seed)
    text = random_robot(rng, joints=rng.randrange(1, 12))
    robot = load_robot(text, file="r.urdf")
    values = {n: rng.uniform(-3, 3) for n, joint in robot.joints.items() if joint.moves}
    stage.load(text)
    stage.start()
    stage.sim.run(0.1)
    stage.tell(**values)
    ours = forward_kinematics(robot, values)
    theirs = UrdfTransformManager()
    theirs.load_urdf(text)
    for name, value in values.items():
        theirs.set_joint(name, value)
    for link in robot.links:
        message = stage.sim.tf.lookup_transform("l0", link).transform
        t, q = message.translation, message.rotation
        found, turned = (t.x, t.y, t.z), (q.x, q.y, q.z, q.w)
        assert found == pytest.approx(ours[link].translation, abs=1e-9)
        assert abs(sum(a * b for a, b in zip(turned, ours[link].rotation, strict=True))) > 1 - 1e-12
        matrix = theirs.get_transform(link, "l0")
        assert found == pytest.approx(tuple(matrix[:3, 3]), abs=1e-9)
        assert columns(turned) == pytest.approx([*matrix[:3, :3].ravel()], abs=1e-9)


def columns(q):
    """The rotation matrix of a unit quaternion, row by row."""
    x, y, z, w = q
    return [
        *(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        *(2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        *(2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    ]


def world(text):
    """Bytes of all that is said in two seconds."""
    with Simulation(seed=4, screen=None) as sim:
        record = sim.record(
            {
                "/tf": "tf2_msgs/TFMessage",
                "/tf_static": "tf2_msgs/TFMessage",
                "/joint_states": "sensor_msgs/JointState",
            }
        )
        sim.params.set("/robot_description", text)
        gui = sim.rosrun("joint_state_publisher_gui", "joint_state_publisher_gui").program
        sim.rosrun("robot_state_publisher", "robot_state_publisher")
        for _ in range(4):
            sim.run(0.5)
            gui.randomize()
        return [record.raw(topic) for topic in record.topics()], [str(line) for line in sim.log]


def test_same_seed_same_bytes(stage):
    text = random_robot(random.Random(3), joints=6)
    assert world(text) == world(text)


def test_both_publishers_make_the_tree_with_its_broadcasters(stage):
    stage.load()
    stage.start()
    stage.sim.rosrun("joint_state_publisher", "joint_state_publisher")
    stage.sim.run(5.0)
    frames = yaml.safe_load(stage.sim.view_frames().to_yaml())
    assert {name: (edge["parent"], edge["broadcaster"]) for name, edge in frames.items()} == {
        "base": ("world", "/robot_state_publisher"),
        "torso": ("base", "/robot_state_publisher"),
        "hand": ("torso", "/robot_state_publisher"),
    }


def test_without_a_robot_it_says_so_and_leaves(stage):
    node = stage.start()
    assert (node.alive, node.exit_code) == (False, 1)
    assert stage.said("ERROR") == ["Could not find parameter robot_description on parameter server"]


def test_a_namespace_is_no_robot(stage):
    stage.load({"arm": "x"})
    assert stage.start().exit_code == 1
    assert stage.said("ERROR") == ["Could not read parameter robot_description on parameter server"]


def test_the_parameter_is_searched_from_the_namespace_outwards(stage):
    stage.load()
    assert stage.start("__ns:=/lab/left").alive


def test_the_parameter_can_be_remapped(stage):
    stage.sim.params.set("/other/robot", stage.arm)
    assert stage.start("robot_description:=/other/robot").alive
    assert stage.start("robot_description:=/other/none").exit_code == 1


def test_a_robot_that_is_refused_is_told_with_its_place(stage):
    stage.load(stage.arm.replace('<link name="hand"/>', '<link name="hand">'))
    node = stage.start()
    assert (node.alive, node.exit_code) == (False, 1)
    assert "not well-formed XML: line 6, column 4" in node.output
    (error,) = stage.said("ERROR")
    assert error.startswith("robot_description:6:")


def test_a_robot_that_is_refused_is_read_once_too(stage, monkeypatch):
    read = []
    original = reading.parse_xml
    monkeypatch.setattr(
        reading, "parse_xml", lambda *args, **more: read.append(1) or original(*args, **more)
    )
    stage.load(stage.arm.replace('<link name="hand"/>', '<link name="torso"/>'))
    assert stage.start().exit_code == 1
    assert len(read) == 1


def test_what_urdfdom_loses_is_told_and_the_rest_is_published(stage):
    broken = '<link name="hand"><visual><geometry/></visual></link>'
    stage.load(stage.arm.replace('<link name="hand"/>', broken))
    node = stage.start()
    assert node.alive
    assert "Could not parse visual element for Link [hand]" in node.output


def test_the_robot_is_read_once(stage):
    stage.load()
    stage.start()
    stage.sim.params.delete("/robot_description")
    stage.tell(hip=0.1)
    assert len(stage.heard()) == 1
