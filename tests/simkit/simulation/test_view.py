from __future__ import annotations

import math

import pytest

from simkit import Simulation
from simkit.errors import SimkitError, UnknownNameError
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
    assert view.url  # somebody wants to look
    before = view._live.state
    drive(0.1)
    after = view._live.state
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
    mimic = sim.rosrun("turtlesim", "mimic")
    assert sim.serve_window_of(mimic) is None


def test_a_served_window_is_there_until_its_node_ends(sim, drive):
    rviz = sim.rosrun("rviz", "rviz")
    view = sim.serve_window_of(rviz)
    assert view.url in rviz.output
    drive(0.1)  # the frame that is chosen appears later
    assert view._live.scene.tf.fixed_frame == "world"
    rviz.shutdown()
    drive(0.02)
    assert not view.alive


@pytest.fixture
def laser(sim, drive):
    """The turtle sees a wall 1 m ahead, tells where it is, and has a plan."""
    node = sim.graph.create_node("/robot")
    scans = node.advertise("/scan", message_class("sensor_msgs/LaserScan"))
    odometry = node.advertise("/odom", message_class("nav_msgs/Odometry"))

    def look(seconds):
        for _ in range(round(seconds / 0.1)):
            drive(0.1)
            scan = message_class("sensor_msgs/LaserScan")(range_max=10.0, ranges=[1.0])
            scan.header.frame_id = "turtle1"
            scans.publish(scan)
            odom = message_class("nav_msgs/Odometry")()
            odom.header.frame_id = "world"
            odom.pose.pose.position.x = 2.0 * (sim.now.to_sec() % 1000)
            odom.pose.pose.orientation.w = 1.0
            odometry.publish(odom)
            sim.run(0.0)

    return look


def test_rviz_shows_topics(sim, laser):
    laser(0.3)
    first = sim.rviz(topics=["/scan", "odom"])
    scan, odom = first.scene.marks
    assert [scan.label, odom.label] == ["LaserScan /scan", "Odometry /odom"]
    turtle = sim.tf.lookup_transform("world", "turtle1").transform.translation
    assert scan.points == (pytest.approx((turtle.x + 1.0, turtle.y, 0.0)),)
    assert len(odom.lines) == 1
    laser(0.5)
    assert len(sim.rviz(topics=["/scan", "/odom"]).scene.marks[1].lines) == 6
    assert len(sim.rviz(topics=["/odom"], keep=2).scene.marks[0].lines) == 1
    assert first.scene.marks == (scan, odom)
    assert len(sim.rviz(topics="/scan").scene.marks) == 1
    assert sim.rviz(topics=["/odom"]).to_png() != sim.rviz().to_png()


def test_topics_that_rviz_cannot_show_are_refused(sim, drive):
    drive(0.1)
    with pytest.raises(UnknownNameError, match="/skan"):
        sim.rviz(topics=["/skan"])
    with pytest.raises(SimkitError, match="no display shows topic /tf, a tf2_msgs/TFMessage"):
        sim.rviz(topics=["/tf"])
    later = sim.rviz(topics={"/scan": "sensor_msgs/LaserScan"})
    assert later.problems == (
        "LaserScan /scan: No messages received. Nobody publishes this topic.",
    )


def test_a_live_view_hears_of_topics(sim, drive, laser):
    drive(0.1)
    live = sim.rviz(topics={"/scan": "sensor_msgs/LaserScan"}, live=True)
    assert "No messages received" in live.to_html()
    laser(0.2)
    page = live.to_html()
    assert "No messages received" not in page
    (marks,) = sim.rviz(topics=["/scan"]).scene.marks
    assert f'"points":{[round(value, 4) for value in marks.points[0]]}'.replace(", ", ",") in page


def test_a_replay_shows_the_recorded_topics(sim, drive, laser):
    laser(0.1)
    recording = sim.record(["/tf", "/scan", "/odom"])
    laser(1.0)
    replay = sim.rviz_replay(recording, keep=4)
    odom, scan = replay.tape.marks
    assert odom.keep == 4
    assert len(scan.moments) == 10


def test_rviz_as_a_node_shows_the_topics_of_its_configuration(sim, laser, tmp_path):
    laser(0.2)
    file = tmp_path / "view.rviz"
    file.write_text(
        "Visualization Manager:\n  Global Options: {Fixed Frame: world}\n"
        "  Displays: [{Class: rviz/LaserScan, Topic: /scan, Enabled: true}]\n"
    )
    view = sim.window_of(sim.rosrun("rviz", "rviz", "-d", str(file)))
    (marks,) = view.scene.marks
    assert len(marks.points) == 1
