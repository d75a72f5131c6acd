from __future__ import annotations

import pytest

from simkit.graph import Executor, Graph
from simkit.msgs import message_class
from simkit.viz import RvizEars
from simkit.viz.topics.displays import OdometryDisplay, PathDisplay

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


def odometry(x):
    message = message_class("nav_msgs/Odometry")()
    message.header.frame_id = "odom"
    message.pose.pose.position.x, message.pose.pose.orientation.w = float(x), 1.0
    return message


def path(x):
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
    publisher = robot.advertise("/plan", type(path(0)), latch=latch)
    said(graph, publisher, path(1))
    said(graph, publisher, path(2))
    (marks,) = ears.marks([PLAN], "odom")
    assert marks.lines == (((2, 0, 0),),)
    graph.executor.run_to(graph.executor.now_ns)
    assert ears.marks([PLAN], "odom") == (marks,)
    assert ears.troubles([PLAN], "odom") == ()


def test_a_trail_grows_from_the_first_view_on(graph, ears, robot):
    publisher = robot.advertise("/odom", type(odometry(0)))
    for x in range(3):
        said(graph, publisher, odometry(x))
    assert len(ears.marks([ODOM], "odom")[0].lines) == 1
    for x in range(3, 5):
        said(graph, publisher, odometry(x))
    assert [line[0][0] for line in ears.marks([ODOM], "odom")[0].lines] == [2, 3, 4]


def test_another_fixed_frame_or_another_display_is_another_trail(graph, ears, robot):
    publisher = robot.advertise("/odom", type(odometry(0)))
    ears.marks([ODOM], "odom")
    said(graph, publisher, odometry(1))
    said(graph, publisher, odometry(2))
    assert len(ears.marks([ODOM], "odom")[0].lines) == 2
    assert "No transform from [odom] to [map]" in ears.troubles([ODOM], "map")[0]
    short = OdometryDisplay(topic="/odom", keep=1)
    assert len(ears.marks([short], "odom")[0].lines) == 1


def test_a_topic_that_nobody_uses_yet_is_listened_to(graph, ears, robot):
    assert ears.troubles([PLAN, ODOM], "odom") == (
        "Path /plan: No messages received. Nobody publishes this topic.",
        "Odometry /odom: No messages received. Nobody publishes this topic.",
    )
    said(graph, robot.advertise("/plan", type(path(0))), path(1))
    robot.advertise("/odom", type(odometry(0)))
    (trouble,) = ears.troubles([PLAN, ODOM], "odom")
    assert trouble == (
        "Odometry /odom: No messages received. "
        "It is listened to from the first view of it on: sim.run(0.2), and look again."
    )


def test_a_topic_of_another_type_is_not_heard(graph, ears, robot):
    said(graph, robot.advertise("/plan", type(odometry(0)), latch=True), odometry(1))
    assert ears.troubles([PLAN], "odom")[0].startswith("Path /plan: No messages received.")
    assert "the two will not be connected" in graph.records[-1].text


def test_the_marks_of_two_displays_have_different_names(ears):
    assert [marks.name for marks in ears.marks([PLAN, ODOM], "odom")] == ["topic-0", "topic-1"]
