"""A graph with nodes in it, and nothing else."""

import pytest

from simkit.graph import Executor, Graph
from simkit.msgs import message_class


class World:
    """A graph on a clock that begins at zero."""

    def __init__(self):
        self.executor = Executor()
        self.graph = Graph(self.executor)
        self.node = self.graph.create_node("/tester")
        self.int32 = message_class("std_msgs/Int32")
        self.string = message_class("std_msgs/String")

    def run(self, seconds=0.0):
        self.executor.run_to(self.executor.now_ns + round(seconds * 1e9))

    def hear(self, topic, node=None, **options):
        """A list that grows with the numbers that come on a topic."""
        heard = []
        subscriber = node or self.node
        subscriber.subscribe(
            topic, self.int32, lambda message: heard.append(message.data), **options
        )
        return heard

    def said(self, level=None):
        return [r.text for r in self.graph.records if level is None or r.level.name == level]


@pytest.fixture
def world():
    return World()
