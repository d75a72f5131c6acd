"""Each recipe of CONTRIBUTING, followed by its text in a copy of the tree: few places, and one command proves it."""

from __future__ import annotations

import re
from typing import Any

import pytest

from tests.laws import broken_laws
from tests.recipes.conftest import ROOT

pytestmark = pytest.mark.slow

NODE = '''"""shouter: says a word again and again."""

from __future__ import annotations

from typing import Any

from simkit.graph import Node
from simkit.msgs import Duration, message_class


class Shouter:
    """The node `shouter`: a word on `shout`, ten times a second.

    Args:
        node: Its place in the graph.
        _argv: Arguments of its command line; it takes none.
    """

    def __init__(self, node: Node, _argv: list[str]) -> None:
        word: Any = message_class("std_msgs/String")(data="hello")
        publisher = node.advertise("shout", type(word), queue_size=1)
        node.create_timer(Duration(0.1), lambda: publisher.publish(word))
'''
NODE_TEST = """from simkit import Simulation


def test_the_shouter_shouts():
    with Simulation(screen=None) as sim:
        sim.rosrun("shouting", "shouter")
        sim.run(1.0)
        assert sim.latest("/shout").data == "hello"
"""
COMMAND = '''"""`simkit rosdistro`: which ROS the kit stands for."""

from __future__ import annotations

import argparse

from simkit.commands.command import Answer, parsed


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The option -d, which is all there is."""
    parser.add_argument("-d", action="store_true", help="show the name of the distribution")


def _answer(_arguments: argparse.Namespace) -> Answer:
    yield "noetic\\n"
    return 0


run = parsed("rosdistro", add_arguments, _answer)
'''
COMMAND_TEST = """def test_it_is_noetic(simkit):
    assert simkit("rosdistro", "-d") == (0, "noetic\\n", "")
"""
RULE = '''@rule("URDF-I49", "a robot that is named robot", Severity.NOTE)
def robot_named_robot(sheet: Sheet) -> Iterator[Find]:
    """A robot that is named robot.

    A name tells robots apart, in the world of Gazebo and in what people say. One that is named `robot` cannot be told from
    the next one that is.

    Wrong:

        <robot name="robot">

    Right:

        <robot name="mower">
    """
    if sheet.robot is not None and sheet.robot.get("name") == "robot":
        yield Find(
            sheet.robot.attribute("name") or sheet.robot,
            what="the robot is named robot",
            remedy='Give it a name of its own, e.g. name="mower".',
        )


'''
PLUGIN = '''"""The plugin `libgazebo_ros_altimeter.so`: how high a model stands."""

from __future__ import annotations

from typing import Any, ClassVar

from simkit.msgs import message_class
from simkit.plugins.plugin import Plugin
from simkit.plugins.rate import UpdateRate
from simkit.plugins.tags import AltimeterParameters


class Altimeter(Plugin[AltimeterParameters]):
    """Publishes the height of its model."""

    Parameters: ClassVar[type[AltimeterParameters]] = AltimeterParameters

    def on_attach(self) -> None:
        """Advertise."""
        self._rate = UpdateRate(self.parameters.update_rate, self.site.now_ns)
        topic = self.site.resolve("height")
        self._publisher = self.site.node.advertise(topic, message_class("std_msgs/Float64"))

    @property
    def due_ns(self) -> int:
        """Once a period."""
        return self._rate.due_ns

    def after_step(self) -> None:
        """Publish, if it is time."""
        if self._rate.is_due(self.site.now_ns):
            height: Any = message_class("std_msgs/Float64")()
            height.data = self.site.model.pose.translation[2]
            self._publisher.publish(height)

    def on_reset(self) -> None:
        """Count its period anew."""
        self._rate = UpdateRate(self.parameters.update_rate, self.site.now_ns)

    def on_detach(self) -> None:
        """Withdraw."""
        self._publisher.unregister()
'''
TAGS = '''@plugin("altimeter.Altimeter")
@dataclass(frozen=True, slots=True, kw_only=True)
class AltimeterParameters:
    """What the tag of `libgazebo_ros_altimeter.so` says."""

    update_rate: float = tag("updateRate", 10.0, "Messages a second; 0: one each step [Hz].", at_least=0.0)


'''
SAMPLE = '''"""How high a model stands."""

from tests.simkit.plugins.samples import PENDULUM, Sample

SAMPLE = Sample(robot=PENDULUM, rate_tag="updateRate")
'''
ROBOT = """<?xml version="1.0"?>
<!-- A post to bump into. -->
<robot name="post">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="world"/>
  <joint name="foot" type="fixed"><parent link="world"/><child link="post"/></joint>
  <link name="post">
    <visual>
      <origin xyz="0 0 0.5"/><geometry><cylinder length="1" radius="0.05"/></geometry>
      <material name="grey"/>
    </visual>
  </link>
</robot>
"""
MANIFEST = """<?xml version="1.0"?>
<package format="2">
  <name>posts</name>
  <version>0.1.0</version>
  <description>Posts.</description>
  <maintainer email="nobody@example.com">nobody</maintainer>
  <license>BSD-3-Clause</license>
  <buildtool_depend>catkin</buildtool_depend>
</package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.0.2)
project(posts)
find_package(catkin REQUIRED)
catkin_package()
install(DIRECTORY urdf
  DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
"""


def test_a_node(tree: Any) -> None:
    tree.write("simkit/nodes/shouting/shouter.py", NODE)
    tree.write("tests/simkit/nodes/shouting/test_shouter.py", NODE_TEST)
    tree.insert(
        "simkit/nodes/registry.py",
        '    _entry("turtlesim/mimic"',
        '    _entry("shouting/shouter", "simkit.nodes.shouting.shouter:Shouter"),\n',
    )
    tree.prove("a node", NAME="shouter")


def test_a_message(tree: Any) -> None:
    text = "string text\nfloat64 loudness\n"
    tree.write("simkit/msgs/definitions/rospy_tutorials/msg/Shout.msg", text)
    tree.insert(
        "tests/simkit/msgs/test_digest.py",
        "sensor_msgs/CameraInfo",
        "rospy_tutorials/Shout d97e85ba68a2368bb8fc77ec5453ab64\n",
    )
    tree.prove("a message", NAME="Shout")


def test_a_command(tree: Any) -> None:
    tree.write("simkit/commands/rosdistro.py", COMMAND)
    tree.write("tests/simkit/commands/test_rosdistro.py", COMMAND_TEST)
    tree.insert(
        "simkit/commands/table.py",
        '    Entry(\n        name="rosrun"',
        '    Entry(\n        name="rosdistro",\n        summary="show the distribution of ROS",\n'
        "        group=THIS_INSTALLATION,\n    ),\n",
    )
    tree.prove("a command", NAME="rosdistro")


def test_a_rule(tree: Any) -> None:
    names = (tree.folder / "simkit/urdf/rules/names.py").read_text(encoding="utf-8")
    first = re.search(r"^@rule\(", names, re.MULTILINE)
    assert first
    tree.insert("simkit/urdf/rules/names.py", "@rule(", RULE)
    tree.write(
        "tests/simkit/urdf/faults/robot_named_robot.urdf",
        '<robot name="robot">\n  <link name="base"/>\n</robot>\n',
    )
    tree.insert(
        "tests/simkit/urdf/faults/faults.toml",
        "[[fault]]",
        '[[fault]]\nfile = "robot_named_robot.urdf"\nrule = "URDF-I49"\nseverity = "note"\n'
        'at = [1, 14]\nremedy = ["mower"]\nmend = [[\'name="robot"\', \'name="mower"\']]\n\n',
    )
    tree.prove("a rule", ID="URDF-I49", NAME="robot_named_robot")


def test_a_plugin(tree: Any) -> None:
    tree.write("simkit/plugins/altimeter.py", PLUGIN)
    tree.insert("simkit/plugins/tags.py", '@plugin(\n    "diff_drive.DiffDrive"', TAGS)
    tree.write("tests/simkit/plugins/test_altimeter.py", SAMPLE)
    tree.prove("a plugin", NAME="altimeter")


def test_a_robot(tree: Any) -> None:
    for name, text in (
        ("package.xml", MANIFEST),
        ("CMakeLists.txt", CMAKE),
        ("urdf/post.urdf", ROBOT),
    ):
        path = tree.folder / "robots/posts" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    tree.touched.add("robots/posts/")
    tree.insert("tests/robots/test_check_urdf.py", '    "m2wr": {', '    "post": {"URDF-W10"},\n')
    tree.run("python docs/robots/make_pages.py")
    tree.prove("a robot", NAME="post")


def test_an_exercise(tree: Any) -> None:
    made = tree.run('grader new 3.12 --title "Two turtles" --like 3.1')
    for name in re.findall(r"made (\S+)", made):
        path = tree.folder / name
        lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
        path.write_text("".join(line for line in lines if "FILL IN" not in line), encoding="utf-8")
    tree.run("grader build")
    tree.prove("an exercise", ID="3.12")


def test_every_recipe_has_a_test_here() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    table = text.partition("## Recipes")[2].partition("\n## ")[0]
    recipes = re.findall(r"^\| (an? [\w ]+) \|", table, re.MULTILINE)
    assert recipes
    proved = {
        name.removeprefix("test_").replace("_", " ") for name in globals() if "test_a" in name
    }
    broken_laws(
        [one for one in recipes if one not in proved],
        "follow it in a copy of the tree, by a test in tests/recipes/test_recipes.py",
    )
