from __future__ import annotations

import math

import pytest

from simkit.graph import Executor, Graph
from simkit.msgs import Time, message_class
from simkit.tf.transformations import quaternion_from_euler
from simkit.viz import TopicListeners
from simkit.viz.stage.rviz_settings import LaserScanDisplay, OdometryDisplay, PathDisplay
from simkit.viz.stage.topic_listener import QUEUE, DisplayListener

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
        return DisplayListener(display, buffer=buffer, fixed_frame=fixed_frame)

    return make


@pytest.fixture
def listener(make):
    return make(LaserScanDisplay(topic="/scan"))


def test_who_has_heard_nothing_says_so_in_rviz_words(listener):
    assert listener.look().points == ()
    assert listener.trouble() == "LaserScan /scan: No messages received."


def test_points_are_where_the_laser_was_when_it_measured(listener, buffer):
    buffer.put("odom", "laser", START, (0, 0, 0))
    buffer.put("odom", "laser", START + 1, (2, 1, 0.5), (0, 0, math.pi / 2))
    listener.hear(scan(t=START + 1, ranges=(3.0,)))
    ((x, y, z),) = listener.look().points
    assert (x, y, z) == pytest.approx((2, 4, 0.5))
    buffer.put("odom", "laser", START + 2, (9, 9, 9))
    assert listener.look().points == ((x, y, z),)  # they stay when the robot goes on
    assert listener.trouble() == ""


def test_a_scan_waits_until_tf_has_its_time(listener, buffer):
    buffer.put("odom", "laser", START, (1, 0, 0))
    listener.hear(scan(t=START))
    before = listener.look()
    listener.hear(scan(t=START + 0.1, ranges=(2.0,)))
    assert listener.look() is before
    assert listener.trouble() == ""
    buffer.put("odom", "laser", START + 0.2, (1, 0, 0))
    assert listener.look().points[0] == pytest.approx((3, 0, 0))


def test_what_tf_never_gets_the_time_for_is_told(listener, buffer):
    buffer.put("odom", "laser", START)
    listener.hear(scan(t=START))
    for number in range(QUEUE):
        assert listener.trouble() == ""
        listener.hear(scan(t=START + 5 + number))
    assert listener.trouble() == (
        "LaserScan /scan: No transform from [laser] to [odom]: tf has no data for the time of the message."
    )


def test_a_frame_that_is_not_there_is_told_with_a_near_one(listener, buffer):
    buffer.put("odom", "laser_link", START)
    listener.hear(scan("laser_lnk"))
    assert listener.trouble() == (
        "LaserScan /scan: No transform from [laser_lnk] to [odom]: "
        "Frame [laser_lnk] does not exist. Did you mean [laser_link]?"
    )


def test_a_fixed_frame_that_is_not_there_is_told(make, buffer):
    buffer.put("odom", "laser", START)
    listener = make(LaserScanDisplay(topic="/scan"), "map")
    listener.hear(scan())
    assert (
        "No transform from [laser] to [map]: Fixed Frame [map] does not exist."
        in listener.trouble()
    )


def test_two_trees_are_told(listener, buffer):
    buffer.put("odom", "base_link", START)
    buffer.put("robot", "laser", START)
    listener.hear(scan())
    assert listener.trouble().endswith(
        "No transform from [laser] to [odom]: they are in two trees."
    )


def test_in_its_own_frame_a_message_needs_no_tf(make):
    listener = make(PathDisplay(topic="/plan"), "map")
    listener.hear(path((0, 0, 0), (1, 2, 3), frame="/map"))
    assert listener.look().lines == (((0, 0, 0), (1, 2, 3)),)
    assert listener.trouble() == ""


def test_of_a_path_only_the_last_message_is_shown_in_the_frame_of_its_header(make, buffer):
    buffer.put("map", "odom", START, (10, 0, 0))
    listener = make(PathDisplay(topic="/plan"), "map")
    listener.hear(path((0, 0, 0), (1, 1, 0)))
    listener.hear(path((5, 5, 0), (math.nan, 0, 0), (6, 5, 0)))
    assert listener.look().lines == (((15, 5, 0), (16, 5, 0)),)
    listener.hear(path())
    assert listener.look().lines == ()


def test_an_arrow_points_along_x_of_its_pose(make):
    listener = make(OdometryDisplay(topic="/odom", length=0.5))
    listener.hear(odometry(1, 2, math.pi / 2))
    (line,) = listener.look().lines
    assert line[0] == pytest.approx((1, 2, 0))
    assert line[1] == line[4] == pytest.approx((1, 2.5, 0))


def test_a_new_arrow_needs_a_step_or_a_turn(make):
    listener = make(OdometryDisplay(topic="/odom", position_tolerance=0.1, angle_tolerance=0.2))
    listener.hear(odometry(0))
    for x in (0.04, 0.08):
        listener.hear(odometry(x))
    assert listener.look().count == 1
    listener.hear(odometry(0.11))
    assert listener.look().count == 2
    listener.hear(odometry(0.11, yaw=0.19))
    assert listener.look().count == 2
    listener.hear(odometry(0.11, yaw=0.21))
    assert listener.look().count == 3


def test_only_the_newest_arrows_are_kept(make):
    listener = make(OdometryDisplay(topic="/odom", keep=3))
    for x in range(10):
        listener.hear(odometry(x))
    shown = listener.look()
    assert [line[0][0] for line in shown.lines] == [7, 8, 9]
    assert shown.count == 10


def test_arrows_stay_where_they_were_put_when_the_map_moves(make, buffer):
    buffer.put("map", "odom", START, (1, 0, 0))
    buffer.put("map", "odom", START + 1, (2, 0, 0))
    listener = make(OdometryDisplay(topic="/odom"), "map")
    listener.hear(odometry(0, t=START))
    listener.hear(odometry(1, t=START + 1))
    buffer.put("map", "odom", START + 60, (50, 0, 0))
    assert [line[0][0] for line in listener.look().lines] == [1, 3]


@pytest.mark.parametrize("fault", ["position", "orientation"])
def test_odometry_that_is_no_pose_is_told(make, fault):
    listener = make(OdometryDisplay(topic="/odom"))
    message = odometry()
    if fault == "position":
        message.pose.pose.position.x = math.nan
    else:
        message.pose.pose.orientation.w = 0.0
    listener.hear(message)
    assert listener.look().lines == ()
    assert "Odometry /odom: Message contained invalid floating point values" in listener.trouble()
    listener.hear(odometry())
    assert listener.trouble() == ""
    assert listener.look().count == 1


def test_a_scan_without_a_hit_shows_no_points_and_no_trouble(make):
    listener = make(LaserScanDisplay(topic="/scan"), "laser")
    listener.hear(scan(ranges=(math.inf,)))
    assert listener.look().points == ()
    assert listener.trouble() == ""


PLAN = PathDisplay(topic="/plan")
ODOM = OdometryDisplay(topic="/odom", keep=5)


@pytest.fixture
def graph():
    return Graph(Executor(0))


@pytest.fixture
def listeners(graph, buffer):
    return TopicListeners(graph.create_node("/simkit"), buffer)


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
def test_the_last_message_before_the_view_is_shown(graph, listeners, robot, latch):
    publisher = robot.advertise("/plan", type(path_ears(0)), latch=latch)
    said(graph, publisher, path_ears(1))
    said(graph, publisher, path_ears(2))
    (marks,) = listeners.marks([PLAN], "odom")
    assert marks.lines == (((2, 0, 0),),)
    graph.executor.run_to(graph.executor.now_ns)
    assert listeners.marks([PLAN], "odom") == (marks,)
    assert listeners.troubles([PLAN], "odom") == ()


def test_a_trail_grows_from_the_first_view_on(graph, listeners, robot):
    publisher = robot.advertise("/odom", type(odometry_ears(0)))
    for x in range(3):
        said(graph, publisher, odometry_ears(x))
    assert len(listeners.marks([ODOM], "odom")[0].lines) == 1
    for x in range(3, 5):
        said(graph, publisher, odometry_ears(x))
    assert [line[0][0] for line in listeners.marks([ODOM], "odom")[0].lines] == [2, 3, 4]


def test_another_fixed_frame_or_another_display_is_another_trail(graph, listeners, robot):
    publisher = robot.advertise("/odom", type(odometry_ears(0)))
    listeners.marks([ODOM], "odom")
    said(graph, publisher, odometry_ears(1))
    said(graph, publisher, odometry_ears(2))
    assert len(listeners.marks([ODOM], "odom")[0].lines) == 2
    assert "No transform from [odom] to [map]" in listeners.troubles([ODOM], "map")[0]
    short = OdometryDisplay(topic="/odom", keep=1)
    assert len(listeners.marks([short], "odom")[0].lines) == 1


def test_a_topic_that_nobody_uses_yet_is_listened_to(graph, listeners, robot):
    assert listeners.troubles([PLAN, ODOM], "odom") == (
        "Path /plan: No messages received. Nobody publishes this topic.",
        "Odometry /odom: No messages received. Nobody publishes this topic.",
    )
    said(graph, robot.advertise("/plan", type(path_ears(0))), path_ears(1))
    robot.advertise("/odom", type(odometry_ears(0)))
    (trouble,) = listeners.troubles([PLAN, ODOM], "odom")
    assert trouble == (
        "Odometry /odom: No messages received. "
        "It is listened to from the first view of it on: sim.run(0.2), and look again."
    )


def test_a_topic_of_another_type_is_not_heard(graph, listeners, robot):
    said(graph, robot.advertise("/plan", type(odometry_ears(0)), latch=True), odometry_ears(1))
    assert listeners.troubles([PLAN], "odom")[0].startswith("Path /plan: No messages received.")
    assert "the two will not be connected" in graph.records[-1].text


def test_the_marks_of_two_displays_have_different_names(listeners):
    assert [marks.name for marks in listeners.marks([PLAN, ODOM], "odom")] == ["topic-0", "topic-1"]
