"""What of a node is shown, and who hears that it has left."""

import pytest

from simkit.graph import Graph, LogLevel
from simkit.graph.executor import Executor


class Heard:
    def __init__(self):
        self.shown = []

    def record(self, record):
        self.shown.append((record.node, record.text))

    def output(self, node, text):
        self.shown.append((node, text))


@pytest.fixture
def graph():
    return Graph(Executor(), Heard())


def test_a_muted_node_shows_warnings_only_and_says_that_something_was_hidden(graph):
    hidden = []
    graph.muted["/quiet"] = lambda: hidden.append(1)
    for name in ("/quiet", "/loud"):
        node = graph.create_node(name)
        node.info("info")
        node.warn("warn")
        graph.show_output(name, "printed")
    assert graph.screen.shown == [
        ("/quiet", "warn"),
        ("/loud", "info"),
        ("/loud", "warn"),
        ("/loud", "printed"),
    ]
    assert len(hidden) == 2
    assert [record.text for record in graph.records] == ["info", "warn"] * 2


def test_without_a_screen_nothing_is_shown(graph):
    graph.screen = None
    graph.muted["/a"] = lambda: pytest.fail("nothing was hidden from anyone")
    graph.show_output("/a", "x")
    graph.log("/a", LogLevel.INFO, "x")
    assert len(graph.records) == 1


def test_departures_are_told(graph):
    told = []
    graph.departures.append(lambda: told.append(sorted(graph.nodes)))
    first, second = graph.create_node("/a"), graph.create_node("/b")
    first.shutdown()
    second.shutdown()
    assert told == [["/b"], []]
