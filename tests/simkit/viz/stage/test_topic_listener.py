from __future__ import annotations

import math

import pytest

from simkit.graph import Executor, Graph
from simkit.msgs import Time, message_class
from simkit.tf.transformations import quaternion_from_euler
from simkit.viz import RvizEars
from simkit.viz.stage.rviz_settings import LaserScanDisplay, OdometryDisplay, PathDisplay
from simkit.viz.stage.topic_listener import QUEUE, DisplayEar

START = 1_600_088_400


def stamped(type_name, frame, t=0.0):
    message = message_class(type_name)()
    message.header.frame_id = frame
    message.header.stamp = Time.from_nsec(round(t * 1e9))
    return message


def scan(frame="laser", t=START, ranges=(1.0,)):
    message = stamped("sensor_msgs/LaserScan", frame, t)
    message.range_min, message.range_max, message.angle_increment = 0.1, 10.0, 0.1
    message.ranges = list(ranges)
    return message


def odometry(x=0.0, y=0.0, yaw=0.0, frame="odom", t=START):
    message = stamped("nav_msgs/Odometry", frame, t)
    p, q = message.pose.pose.position, message.pose.pose.orientation
    p.x, p.y = x, y
    q.x, q.y, q.z, q.w = map(float, quaternion_from_euler(0, 0, yaw))
    return message


def path(*points, frame="odom"):
    message = stamped("nav_msgs/Path", frame)
    for x, y, z in points:
        pose = stamped("geometry_msgs/PoseStamped", "somewhere_else")
        pose.pose.position.x, pose.pose.position.y, pose.pose.position.z = x, y, z
        message.poses.append(pose)
    return message


@pytest.fixture
def make(buffer):
    def make(display, fixed_frame="odom"):
        return DisplayEar(display, buffer=buffer, fixed_frame=fixed_frame)

    return make


@pytest.fixture
def ear(make):
    return make(LaserScanDisplay(topic="/scan"))


def test_who_has_heard_nothing_says_so_in_rviz_words(ear):
    assert ear.look().points == ()
    assert ear.trouble() == "LaserScan /scan: No messages received."


def test_points_are_where_the_laser_was_when_it_measured(ear, buffer):
    buffer.put("odom", "laser", START, (0, 0, 0))
    buffer.put("odom", "laser", START + 1, (2, 1, 0.5), (0, 0, math.pi / 2))
    ear.hear(scan(t=START + 1, ranges=(3.0,)))
    ((x, y, z),) = ear.look().points
    assert (x, y, z) == pytest.approx((2, 4, 0.5))
    buffer.put("odom", "laser", START + 2, (9, 9, 9))
    assert ear.look().points == ((x, y, z),)  # they stay when the robot goes on
    assert ear.trouble() == ""


def test_a_scan_waits_until_tf_has_its_time(ear, buffer):
    buffer.put("odom", "laser", START, (1, 0, 0))
    ear.hear(scan(t=START))
    before = ear.look()
    ear.hear(scan(t=START + 0.1, ranges=(2.0,)))
    assert ear.look() is before
    assert ear.trouble() == ""
    buffer.put("odom", "laser", START + 0.2, (1, 0, 0))
    assert ear.look().points[0] == pytest.approx((3, 0, 0))


def test_what_tf_never_gets_the_time_for_is_told(ear, buffer):
    buffer.put("odom", "laser", START)
    ear.hear(scan(t=START))
    for number in range(QUEUE):
        assert ear.trouble() == ""
        ear.hear(scan(t=START + 5 + number))
    assert ear.trouble() == (
        "LaserScan /scan: No transform from [laser] to [odom]: tf has no data for the time of the message."
    )


def test_a_frame_that_is_not_there_is_told_with_a_near_one(ear, buffer):
    buffer.put("odom", "laser_link", START)
    ear.hear(scan("laser_lnk"))
    assert ear.trouble() == (
        "LaserScan /scan: No transform from [laser_lnk] to [odom]: "
        "Frame [laser_lnk] does not exist. Did you mean [laser_link]?"
    )


def test_a_fixed_frame_that_is_not_there_is_told(make, buffer):
    buffer.put("odom", "laser", START)
    ear = make(LaserScanDisplay(topic="/scan"), "map")
    ear.hear(scan())
    assert "No transform from [laser] to [map]: Fixed Frame [map] does not exist." in ear.trouble()


def test_two_trees_are_told(ear, buffer):
    buffer.put("odom", "base_link", START)
    buffer.put("robot", "laser", START)
    ear.hear(scan())
    assert ear.trouble().endswith("No transform from [laser] to [odom]: they are in two trees.")


def test_in_its_own_frame_a_message_needs_no_tf(make):
    ear = make(PathDisplay(topic="/plan"), "map")
    ear.hear(path((0, 0, 0), (1, 2, 3), frame="/map"))
    assert ear.look().lines == (((0, 0, 0), (1, 2, 3)),)
    assert ear.trouble() == ""


def test_of_a_path_only_the_last_message_is_shown_in_the_frame_of_its_header(make, buffer):
    buffer.put("map", "odom", START, (10, 0, 0))
    ear = make(PathDisplay(topic="/plan"), "map")
    ear.hear(path((0, 0, 0), (1, 1, 0)))
    ear.hear(path((5, 5, 0), (math.nan, 0, 0), (6, 5, 0)))
    assert ear.look().lines == (((15, 5, 0), (16, 5, 0)),)
    ear.hear(path())
    assert ear.look().lines == ()


def test_an_arrow_points_along_x_of_its_pose(make):
    ear = make(OdometryDisplay(topic="/odom", length=0.5))
    ear.hear(odometry(1, 2, math.pi / 2))
    (line,) = ear.look().lines
    assert line[0] == pytest.approx((1, 2, 0))
    assert line[1] == line[4] == pytest.approx((1, 2.5, 0))


def test_a_new_arrow_needs_a_step_or_a_turn(make):
    ear = make(OdometryDisplay(topic="/odom", position_tolerance=0.1, angle_tolerance=0.2))
    ear.hear(odometry(0))
    for x in (0.04, 0.08):
        ear.hear(odometry(x))
    assert ear.look().count == 1
    ear.hear(odometry(0.11))
    assert ear.look().count == 2
    ear.hear(odometry(0.11, yaw=0.19))
    assert ear.look().count == 2
    ear.hear(odometry(0.11, yaw=0.21))
    assert ear.look().count == 3


def test_only_the_newest_arrows_are_kept(make):
    ear = make(OdometryDisplay(topic="/odom", keep=3))
    for x in range(10):
        ear.hear(odometry(x))
    shown = ear.look()
    assert [line[0][0] for line in shown.lines] == [7, 8, 9]
    assert shown.count == 10


def test_arrows_stay_where_they_were_put_when_the_map_moves(make, buffer):
    buffer.put("map", "odom", START, (1, 0, 0))
    buffer.put("map", "odom", START + 1, (2, 0, 0))
    ear = make(OdometryDisplay(topic="/odom"), "map")
    ear.hear(odometry(0, t=START))
    ear.hear(odometry(1, t=START + 1))
    buffer.put("map", "odom", START + 60, (50, 0, 0))
    assert [line[0][0] for line in ear.look().lines] == [1, 3]


@pytest.mark.parametrize("fault", ["position", "orientation"])
def test_odometry_that_is_no_pose_is_told(make, fault):
    ear = make(OdometryDisplay(topic="/odom"))
    message = odometry()
    if fault == "position":
        message.pose.pose.position.x = math.nan
    else:
        message.pose.pose.orientation.w = 0.0
    ear.hear(message)
    assert ear.look().lines == ()
    assert "Odometry /odom: Message contained invalid floating point values" in ear.trouble()
    ear.hear(odometry())
    assert ear.trouble() == ""
    assert ear.look().count == 1


def test_a_scan_without_a_hit_shows_no_points_and_no_trouble(make):
    ear = make(LaserScanDisplay(topic="/scan"), "laser")
    ear.hear(scan(ranges=(math.inf,)))
    assert ear.look().points == ()
    assert ear.trouble() == ""


PLAN = PathDisplay(topic="/plan")
ODOM = OdometryDisplay(topic="/odom", keep=5)


@pytest.fixture
def graph():
    return Graph(Executor(0))


@pytest.fixture
def ears(graph, buffer):
    return RvizEars(graph.create_node("/simkit"), buffer)


@pytest.fixture
def robot(graph):
    return graph.create_node("/robot")


def odometry_ears(x):
    message = message_class("nav_msgs/Odometry")()
    message.header.frame_id = "odom"
    message.pose.pose.position.x, message.pose.pose.orientation.w = float(x), 1.0
    return message


def path_ears(x):
    message = message_class("nav_msgs/Path")()
    message.header.frame_id = "odom"
    message.poses.append(message_class("geometry_msgs/PoseStamped")())
    message.poses[0].pose.position.x = float(x)
    return message


def said(graph, publisher, message):
    publisher.publish(message)
    graph.executor.run_to(graph.executor.now_ns)


@pytest.mark.parametrize("latch", [True, False])
def test_the_last_message_before_the_view_is_shown(graph, ears, robot, latch):
    publisher = robot.advertise("/plan", type(path_ears(0)), latch=latch)
    said(graph, publisher, path_ears(1))
    said(graph, publisher, path_ears(2))
    (marks,) = ears.marks([PLAN], "odom")
    assert marks.lines == (((2, 0, 0),),)
    graph.executor.run_to(graph.executor.now_ns)
    assert ears.marks([PLAN], "odom") == (marks,)
    assert ears.troubles([PLAN], "odom") == ()


def test_a_trail_grows_from_the_first_view_on(graph, ears, robot):
    publisher = robot.advertise("/odom", type(odometry_ears(0)))
    for x in range(3):
        said(graph, publisher, odometry_ears(x))
    assert len(ears.marks([ODOM], "odom")[0].lines) == 1
    for x in range(3, 5):
        said(graph, publisher, odometry_ears(x))
    assert [line[0][0] for line in ears.marks([ODOM], "odom")[0].lines] == [2, 3, 4]


def test_another_fixed_frame_or_another_display_is_another_trail(graph, ears, robot):
    publisher = robot.advertise("/odom", type(odometry_ears(0)))
    ears.marks([ODOM], "odom")
    said(graph, publisher, odometry_ears(1))
    said(graph, publisher, odometry_ears(2))
    assert len(ears.marks([ODOM], "odom")[0].lines) == 2
    assert "No transform from [odom] to [map]" in ears.troubles([ODOM], "map")[0]
    short = OdometryDisplay(topic="/odom", keep=1)
    assert len(ears.marks([short], "odom")[0].lines) == 1


def test_a_topic_that_nobody_uses_yet_is_listened_to(graph, ears, robot):
    assert ears.troubles([PLAN, ODOM], "odom") == (
        "Path /plan: No messages received. Nobody publishes this topic.",
        "Odometry /odom: No messages received. Nobody publishes this topic.",
    )
    said(graph, robot.advertise("/plan", type(path_ears(0))), path_ears(1))
    robot.advertise("/odom", type(odometry_ears(0)))
    (trouble,) = ears.troubles([PLAN, ODOM], "odom")
    assert trouble == (
        "Odometry /odom: No messages received. "
        "It is listened to from the first view of it on: sim.run(0.2), and look again."
    )


def test_a_topic_of_another_type_is_not_heard(graph, ears, robot):
    said(graph, robot.advertise("/plan", type(odometry_ears(0)), latch=True), odometry_ears(1))
    assert ears.troubles([PLAN], "odom")[0].startswith("Path /plan: No messages received.")
    assert "the two will not be connected" in graph.records[-1].text


def test_the_marks_of_two_displays_have_different_names(ears):
    assert [marks.name for marks in ears.marks([PLAN, ODOM], "odom")] == ["topic-0", "topic-1"]
