import io

import pytest

from simkit.graph import Executor, Graph
from simkit.graph.log import StreamScreen
from simkit.graph.topic_hints import TopicHints, unmatched_topics
from simkit.msgs import message_class

POSE, TWIST = message_class("turtlesim/Pose"), message_class("geometry_msgs/Twist")
POES = "listens to /turtle1/poes, which no node publishes; did you mean /turtle1/pose?"


@pytest.fixture
def graph():
    """With a turtle that publishes its pose and listens to commands."""
    made = Graph(Executor(0), StreamScreen(io.StringIO()))
    turtle = made.create_node("/turtle")
    turtle.advertise("/turtle1/pose", POSE)
    turtle.subscribe("/turtle1/cmd_vel", TWIST, print)
    return made


@pytest.fixture
def node(graph):
    return graph.create_node("/mine")


def said(graph, node):
    return list(unmatched_topics(graph, node, "your node").values())


def test_a_topic_that_no_node_publishes_is_named_with_the_near_one(graph, node):
    node.subscribe("/turtle1/poes", POSE, print)
    assert said(graph, node) == [f"your node {POES}"]


def test_a_topic_that_no_node_hears_is_named_with_the_one_that_waits(graph, node):
    node.advertise("/cmd_vel", TWIST)
    expected = "publishes /cmd_vel, which no node listens to; did you mean /turtle1/cmd_vel?"
    assert said(graph, node) == [f"your node {expected}"]


def test_the_same_name_in_another_namespace_is_near(graph, node):
    node.subscribe("/pose", POSE, print)
    assert "did you mean /turtle1/pose?" in said(graph, node)[0]


def test_nothing_is_said_where_nothing_is_near(graph, node):
    node.subscribe("/somewhere/else", POSE, print)
    node.subscribe("/turtle1/posee", TWIST, print)  # of another type
    node.advertise("/odometry", TWIST)
    assert said(graph, node) == []


def test_a_name_that_the_node_uses_beside_it_was_not_meant(graph, node):
    for name in ("/turtle1/pose", "/turtle2/pose"):
        node.subscribe(name, POSE, print)
    assert said(graph, node) == []


def test_what_is_in_use_by_another_publisher_is_no_place_for_this_one(graph, node):
    graph.create_node("/teleop").advertise("/turtle1/cmd_vel", TWIST)
    node.advertise("/turtle1/cmd_val", TWIST)
    assert said(graph, node) == []


def test_the_screen_shows_it_once_after_a_while_and_the_log_is_as_before(graph, node):
    hints = TopicHints(graph, [node])
    node.subscribe("/turtle1/poes", POSE, print)
    shown = graph.screen._stream
    for seconds, lines in ((1, 0), (3, 1), (9, 1)):
        graph.executor.run_to(seconds * 10**9)
        hints.look()
        assert shown.getvalue().count("\n") == lines
    assert shown.getvalue() == f"[WARN] [3.000000] /mine: this node {POES}\n"
    assert graph.records == []
