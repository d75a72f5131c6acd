from __future__ import annotations

import pytest

from simkit.commands.errors import UsageError
from simkit.graph import Executor, Graph
from simkit.nodes import builtin_nodes
from simkit.nodes.gzclient import HINT, GzclientProgram


@pytest.fixture
def graph():
    return Graph(Executor(10**18), None)


@pytest.fixture
def start(graph):
    def start(*arguments):
        node = graph.create_node("/gazebo_gui", {})
        return builtin_nodes()["gazebo_ros", "gzclient"](node, list(arguments))

    return start


def run(graph, seconds):
    graph.executor.run_to(graph.executor.now_ns + round(seconds * 1e9))


def test_it_is_the_node_gzclient_of_the_package_gazebo_ros(start):
    program = start()
    assert isinstance(program, GzclientProgram)
    assert program.exit_code is None


def test_it_says_once_how_the_window_is_opened(graph, start):
    program = start()
    assert program.output == ""
    run(graph, 5.0)
    assert program.output == f"no window opens here: {HINT}\n"


def test_it_says_where_the_window_is_instead(graph, start):
    program = start()
    program.show_address("http://127.0.0.1:1/x/")
    run(graph, 5.0)
    assert program.output == (
        "Gazebo is at http://127.0.0.1:1/x/ (open it in a browser; Ctrl-C ends it)\n"
    )


def test_it_takes_the_options_of_gzclient_and_no_others(start):
    start("--verbose", "-g", "libx.so")
    with pytest.raises(UsageError, match=r"gzclient: '--verbos' is no argument of it; usage: gz"):
        start("--verbos")
    with pytest.raises(UsageError, match="'-g'"):
        start("-g")
