"""Which built-in nodes there are; the code of one is imported when it is started."""

from __future__ import annotations

import importlib
from collections.abc import Collection
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from simkit.graph.names import CommandLine, free_name, join
from simkit.packages import PackagePath

if TYPE_CHECKING:
    from simkit.graph import Node


@dataclass(frozen=True, slots=True, kw_only=True)
class BuiltinNode:
    """A node of the kit, and its factory: called with a graph node and arguments, it starts."""

    package: str
    """ROS package, e.g. `turtlesim`."""
    executable: str
    """What `rosrun` is given after the package, e.g. `turtlesim_node`."""
    node_name: str
    """Name that the node gives itself when nobody gives it another."""
    program: str
    """Its class, or a function that picks one, as `module:name`; called with (node, argv)."""
    anonymous: bool = False
    """Whether several may run at once: each gets a number behind its name."""
    reads_packages: bool = False
    """Whether it reads files of packages: then it is given the package path too."""
    watch_seconds: float | None = None
    """For one that only prints what it sees, until Ctrl-C: how long a line of a notebook shows it [s]."""

    def named(self, command_line: CommandLine, taken: Collection[str]) -> CommandLine:
        """The command line with a free name in it, if this node is anonymous and has none.

        Args:
            command_line: What the node is started with.
            taken: Resolved names of the nodes that are up.
        """
        if not self.anonymous or command_line.node_name is not None:
            return command_line
        name = free_name(join(command_line.namespace, self.node_name), taken)
        return replace(command_line, node_name=name.rpartition("/")[2])

    def __call__(self, node: Node, argv: list[str], packages: PackagePath | None = None) -> object:
        """Start the node.

        Args:
            node: Its place in the graph.
            argv: Arguments of its command line, without remappings.
            packages: Where packages are; none if None.
        """
        module, _, name = self.program.partition(":")
        start = getattr(importlib.import_module(module), name)
        if not self.reads_packages:
            return start(node, argv)
        return start(node, argv, packages or PackagePath([]))


def _entry(command: str, program: str, *, node_name: str = "", **options: Any) -> BuiltinNode:
    """A node by `package/executable`, where its class is, and what differs from the usual."""
    package, _, executable = command.partition("/")
    return BuiltinNode(
        package=package,
        executable=executable,
        node_name=node_name or executable,
        program=program,
        **options,
    )


_BUILTIN = (
    _entry(
        "turtlesim/turtlesim_node",
        "simkit.nodes.turtlesim.node:TurtlesimNode",
        node_name="turtlesim",
    ),
    _entry(
        "turtlesim/turtle_teleop_key",
        "simkit.nodes.turtlesim.teleop:TurtleTeleop",
        node_name="teleop_turtle",
    ),
    _entry("turtlesim/draw_square", "simkit.nodes.turtlesim.draw_square:DrawSquare"),
    _entry("turtlesim/mimic", "simkit.nodes.turtlesim.mimic:TurtleMimic", node_name="turtle_mimic"),
    _entry("tf/tf_echo", "simkit.nodes.tf_tools.echo:TfEcho", anonymous=True, watch_seconds=3.0),
    # it prints five times a second
    _entry(
        "tf/tf_monitor",
        "simkit.nodes.tf_tools.monitor:TfMonitor",
        anonymous=True,
        watch_seconds=1.0,
    ),
    _entry(
        "tf/static_transform_publisher",
        "simkit.nodes.tf_tools.static_publisher:TfStaticTransformPublisher",
        anonymous=True,
    ),
    _entry(
        "tf2_ros/static_transform_publisher",
        "simkit.nodes.tf_tools.static_publisher:Tf2StaticTransformPublisher",
        anonymous=True,
    ),
    _entry(
        "tf2_tools/echo.py",
        "simkit.nodes.tf_tools.echo:Tf2Echo",
        node_name="echo",
        watch_seconds=3.0,
    ),
    _entry(
        "tf/view_frames",
        "simkit.nodes.tf_tools.view_frames:TfViewFrames",
        anonymous=True,
        watch_seconds=5.5,
    ),
    _entry(
        "tf2_tools/view_frames.py",
        "simkit.nodes.tf_tools.view_frames:Tf2ViewFrames",
        node_name="view_frames",
        anonymous=True,
        watch_seconds=5.5,
    ),
    _entry(
        "joint_state_publisher/joint_state_publisher",
        "simkit.nodes.joint_state_publisher.gui:start_joint_state_publisher",
    ),
    _entry(
        "joint_state_publisher_gui/joint_state_publisher_gui",
        "simkit.nodes.joint_state_publisher.gui:JointStatePublisherGui",
    ),
    _entry(
        "robot_state_publisher/robot_state_publisher",
        "simkit.nodes.robot_state_publisher.node:RobotStatePublisher",
    ),
    _entry(
        "robot_state_publisher/state_publisher",
        "simkit.nodes.robot_state_publisher.node:StatePublisher",
        node_name="robot_state_publisher",
    ),
    _entry("rviz/rviz", "simkit.nodes.rviz:RvizProgram", anonymous=True, watch_seconds=0.5),
    _entry("rostopic/rostopic", "simkit.nodes.rostopic:RostopicProgram", anonymous=True),
    _entry(
        "gazebo_ros/gzserver",
        "simkit.gazebo.gzserver:GzServer",
        node_name="gazebo",
        reads_packages=True,
    ),
    # a line of a notebook shows the window, and has no need of the hint
    _entry(
        "gazebo_ros/gzclient",
        "simkit.nodes.gzclient:GzclientProgram",
        node_name="gazebo_gui",
        anonymous=True,
        watch_seconds=0.1,
    ),
    _entry("gazebo_ros/spawn_model", "simkit.gazebo.spawn_model:SpawnModel", reads_packages=True),
    _entry(
        "controller_manager/spawner",
        "simkit.nodes.controller_manager.spawner:Spawner",
        anonymous=True,
    ),
    _entry(
        "controller_manager/unspawner",
        "simkit.nodes.controller_manager.spawner:Unspawner",
        anonymous=True,
    ),
    _entry(
        "controller_manager/controller_manager",
        "simkit.nodes.controller_manager.tool:ControllerManagerTool",
        anonymous=True,
        watch_seconds=1.0,
    ),
)


def builtin_nodes() -> dict[tuple[str, str], BuiltinNode]:
    """All built-in nodes by (package, executable)."""
    return {(builtin.package, builtin.executable): builtin for builtin in _BUILTIN}
