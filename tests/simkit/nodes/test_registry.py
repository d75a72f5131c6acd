from __future__ import annotations

import subprocess
import sys

import pytest

from simkit.graph.names import split_command_line
from simkit.nodes import builtin_nodes
from simkit.nodes.joint_state_publisher import JointStatePublisher, JointStatePublisherGui
from simkit.nodes.robot_state_publisher import RobotStatePublisher, StatePublisher
from simkit.nodes.turtlesim import DrawSquare, TurtleMimic, TurtlesimNode, TurtleTeleop
from tests.laws import broken_laws

CLASSES = {
    "turtlesim_node": ("/turtlesim", TurtlesimNode),
    "turtle_teleop_key": ("/teleop_turtle", TurtleTeleop),
    "draw_square": ("/draw_square", DrawSquare),
    "mimic": ("/turtle_mimic", TurtleMimic),
}


@pytest.mark.parametrize("executable", CLASSES)
def test_each_entry_starts_its_class_under_the_name_of_ros(bench, executable: str) -> None:
    name, node_class = CLASSES[executable]
    assert isinstance(bench.start(executable), node_class)
    assert name in bench.graph.nodes


PUBLISHERS = {
    ("joint_state_publisher", "joint_state_publisher"): JointStatePublisher,
    ("joint_state_publisher_gui", "joint_state_publisher_gui"): JointStatePublisherGui,
    ("robot_state_publisher", "robot_state_publisher"): RobotStatePublisher,
    ("robot_state_publisher", "state_publisher"): StatePublisher,
}


@pytest.mark.parametrize("key", PUBLISHERS)
def test_the_publishers_of_a_robot_start_under_the_names_of_their_packages(bench, key) -> None:
    bench.graph.params.set("/robot_description", '<robot name="r"><link name="a"/></robot>')
    definition = builtin_nodes()[key]
    assert definition.node_name == definition.package
    node = bench.graph.create_node(f"/{definition.node_name}")
    assert type(definition(node, [])) is PUBLISHERS[key]
    assert node.alive


def test_keys_are_the_names_of_their_entries() -> None:
    nodes = builtin_nodes().items()
    broken_laws(
        {key: node for key, node in nodes if key != (node.package, node.executable)},
        "the key of an entry in simkit/nodes/registry.py is its package and its executable",
    )


def test_the_registry_imports_no_node_and_no_node_imports_matplotlib() -> None:
    program = (
        "import sys; from simkit.nodes import builtin_nodes; builtin_nodes();"
        "assert 'simkit.nodes.turtlesim' not in sys.modules;"
        "import simkit.nodes.turtlesim; assert 'matplotlib' not in sys.modules"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=False
    )
    broken_laws(
        done.stderr.splitlines(),
        "simkit/nodes/registry.py names modules as text, and a node imports matplotlib where it draws",
    )


@pytest.mark.parametrize(
    ("words", "taken", "name"),
    [
        ([], [], "tf_echo_1"),
        ([], ["/tf_echo_1", "/tf_echo_2"], "tf_echo_3"),
        (["__ns:=/lab"], ["/tf_echo_1"], "tf_echo_1"),
        (["__ns:=/lab"], ["/lab/tf_echo_1"], "tf_echo_2"),
        (["__name:=mine"], ["/mine"], "mine"),
    ],
)
def test_an_anonymous_node_gets_a_number_unless_it_is_named(words, taken, name) -> None:
    definition = builtin_nodes()["tf", "tf_echo"]
    assert definition.named(split_command_line(words), taken).node_name == name


def test_any_other_node_keeps_its_command_line() -> None:
    line = split_command_line(["a:=b"])
    assert builtin_nodes()["turtlesim", "turtlesim_node"].named(line, ["/turtlesim"]) is line
