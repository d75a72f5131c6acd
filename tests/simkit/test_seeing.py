from __future__ import annotations

import math

import pytest

from simkit import Simulation
from simkit.errors import UnknownNameError
from simkit.msgs import Time, message_class
from simkit.tf import TransformBroadcaster
from simkit.viz import LiveRviz, RvizReplay, RvizView

ROBOT = """<robot name="r"><link name="turtle1">
<visual><geometry><box size="1 1 0.2"/></geometry></visual>
<collision><geometry><sphere radius="0.6"/></geometry></collision>
</link></robot>"""


@pytest.fixture
def sim():
    with Simulation(screen=None) as sim:
        yield sim


@pytest.fixture
def drive(sim):
    """Lets turtle1 go round in the world for some time."""
    broadcaster = TransformBroadcaster(sim.graph.create_node("/driver"))

    def drive(seconds):
        for _ in range(round(50 * seconds)):
            message = message_class("geometry_msgs/TransformStamped")()
            message.header.frame_id, message.child_frame_id = "world", "turtle1"
            message.header.stamp = sim.now
            angle = sim.now.to_nsec() % 10**11 / 1e9
            message.transform.translation.x = math.cos(angle)
            message.transform.translation.y = math.sin(angle)
            message.transform.rotation.w = 1.0
            broadcaster.send_transform(message)
            sim.run(0.02)

    return drive


def test_rviz_shows_the_frames_and_the_robot_that_is_described(sim, drive):
    drive(0.1)
    view = sim.rviz()
    assert isinstance(view, RvizView)
    assert [pose.name for pose in view.scene.tf.poses] == ["world", "turtle1"]
    assert view.scene.solids == ()
    sim.params.set("/robot_description", ROBOT)
    found = sim.tf.core.lookup("world", "turtle1").translation
    assert {placed.pose()[0] for placed in sim.rviz().scene.solids} == {found}


def test_rviz_takes_what_a_person_sets(sim, drive):
    drive(0.1)
    early = Time.from_nsec(sim.now.to_nsec() - 50_000_000)
    drive(0.1)
    sim.params.set("/arm", ROBOT)
    view = sim.rviz(
        "turtle1",
        time=early,
        robot_model="collision",
        alpha=0.5,
        show_tf=False,
        show_grid=False,
        description="/arm",
    )
    assert view.scene.tf.fixed_frame == "turtle1"
    assert view.scene.tf != sim.rviz("turtle1").scene.tf
    assert not view.scene.displays.tf
    assert not view.scene.displays.grid
    assert max(placed.alpha for placed in view.scene.solids) == 0.5
    with pytest.raises(UnknownNameError, match="no robot model 'visible'"):
        sim.rviz(robot_model="visible")


def test_a_live_view_follows_each_run_and_ends_with_the_simulation(sim, drive):
    drive(0.1)
    view = sim.rviz(live=True)
    assert isinstance(view, LiveRviz)
    before = view._news.state
    drive(0.1)
    after = view._news.state
    assert after.number == before.number
    assert after.poses != before.poses
    assert view.alive
    sim.close()
    assert not view.alive


def test_a_live_view_changes_nothing_of_what_happens(drive, sim):
    def trace(live):
        with Simulation(seed=3, screen=None) as run:
            run.rosrun("turtlesim", "turtlesim_node")
            run.rostopic_pub("/turtle1/cmd_vel", "geometry_msgs/Twist", "{linear: {x: 1}}", rate=10)
            if live:
                run.rviz(live=True)
            recording = run.record(["/turtle1/pose"])
            run.run(0.5)
            return recording.raw("/turtle1/pose")

    assert trace(live=True) == trace(live=False) != []


def test_a_replay_of_a_recording(sim, drive):
    recording = sim.record(["/tf", "/tf_static"])
    drive(1.0)
    sim.params.set("/robot_description", ROBOT)
    replay = sim.rviz_replay(recording, robot_model="collision")
    assert isinstance(replay, RvizReplay)
    assert replay.tape.duration == pytest.approx(0.98)
    assert len(replay.tape.scene.solids) == 2


def test_the_window_of_rviz_and_of_other_nodes(sim, drive):
    drive(0.1)
    rviz = sim.rosrun("rviz", "rviz")
    assert rviz.name == "/rviz_1"
    assert sim.window_of(rviz).scene.tf.fixed_frame == "world"
    chosen = sim.rosrun("rviz", "rviz", "-f", "turtle1")
    assert sim.window_of(chosen).scene.tf.fixed_frame == "turtle1"
    turtles = sim.rosrun("turtlesim", "turtlesim_node")
    assert sim.window_of(turtles) is None
    assert sim.serve_window_of(turtles) is None


def test_a_served_window_is_there_until_its_node_ends(sim, drive):
    rviz = sim.rosrun("rviz", "rviz")
    view = sim.serve_window_of(rviz)
    assert view.url in rviz.output
    drive(0.1)  # the frame that is chosen appears later
    assert view._news.scene.tf.fixed_frame == "world"
    rviz.shutdown()
    drive(0.02)
    assert not view.alive
