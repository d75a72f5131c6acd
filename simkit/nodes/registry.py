"""Which built-in nodes there are; the code of one is imported when it is started."""

from __future__ import annotations

import importlib
from collections.abc import Collection
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

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
    module: str
    """Python module of its class."""
    class_name: str
    """Its class, or a function that picks one; called with (node, argv)."""
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
        start = getattr(importlib.import_module(self.module), self.class_name)
        if not self.reads_packages:
            return start(node, argv)
        return start(node, argv, packages or PackagePath([]))


_BUILTIN = (
    BuiltinNode(
        package="turtlesim",
        executable="turtlesim_node",
        node_name="turtlesim",
        module="simkit.nodes.turtlesim.node",
        class_name="TurtlesimNode",
    ),
    BuiltinNode(
        package="turtlesim",
        executable="turtle_teleop_key",
        node_name="teleop_turtle",
        module="simkit.nodes.turtlesim.teleop",
        class_name="TurtleTeleop",
    ),
    BuiltinNode(
        package="turtlesim",
        executable="draw_square",
        node_name="draw_square",
        module="simkit.nodes.turtlesim.draw_square",
        class_name="DrawSquare",
    ),
    BuiltinNode(
        package="turtlesim",
        executable="mimic",
        node_name="turtle_mimic",
        module="simkit.nodes.turtlesim.mimic",
        class_name="TurtleMimic",
    ),
    BuiltinNode(
        package="tf",
        executable="tf_echo",
        node_name="tf_echo",
        module="simkit.nodes.tf_tools.echo",
        class_name="TfEcho",
        anonymous=True,
        watch_seconds=3.0,
    ),
    BuiltinNode(
        package="tf",
        executable="tf_monitor",
        node_name="tf_monitor",
        module="simkit.nodes.tf_tools.monitor",
        class_name="TfMonitor",
        anonymous=True,
        watch_seconds=1.0,  # it prints five times a second
    ),
    BuiltinNode(
        package="tf",
        executable="static_transform_publisher",
        node_name="static_transform_publisher",
        module="simkit.nodes.tf_tools.static_publisher",
        class_name="TfStaticTransformPublisher",
        anonymous=True,
    ),
    BuiltinNode(
        package="tf2_ros",
        executable="static_transform_publisher",
        node_name="static_transform_publisher",
        module="simkit.nodes.tf_tools.static_publisher",
        class_name="Tf2StaticTransformPublisher",
        anonymous=True,
    ),
    BuiltinNode(
        package="tf2_tools",
        executable="echo.py",
        node_name="echo",
        module="simkit.nodes.tf_tools.echo",
        class_name="Tf2Echo",
        watch_seconds=3.0,
    ),
    BuiltinNode(
        package="tf",
        executable="view_frames",
        node_name="view_frames",
        module="simkit.nodes.tf_tools.view_frames",
        class_name="TfViewFrames",
        anonymous=True,
        watch_seconds=5.5,
    ),
    BuiltinNode(
        package="tf2_tools",
        executable="view_frames.py",
        node_name="view_frames",
        module="simkit.nodes.tf_tools.view_frames",
        class_name="Tf2ViewFrames",
        anonymous=True,
        watch_seconds=5.5,
    ),
    BuiltinNode(
        package="joint_state_publisher",
        executable="joint_state_publisher",
        node_name="joint_state_publisher",
        module="simkit.nodes.joint_state_publisher.start",
        class_name="start_joint_state_publisher",
    ),
    BuiltinNode(
        package="joint_state_publisher_gui",
        executable="joint_state_publisher_gui",
        node_name="joint_state_publisher_gui",
        module="simkit.nodes.joint_state_publisher.gui",
        class_name="JointStatePublisherGui",
    ),
    BuiltinNode(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        node_name="robot_state_publisher",
        module="simkit.nodes.robot_state_publisher.node",
        class_name="RobotStatePublisher",
    ),
    BuiltinNode(
        package="robot_state_publisher",
        executable="state_publisher",
        node_name="robot_state_publisher",
        module="simkit.nodes.robot_state_publisher.node",
        class_name="StatePublisher",
    ),
    BuiltinNode(
        package="rviz",
        executable="rviz",
        node_name="rviz",
        module="simkit.nodes.rviz",
        class_name="RvizProgram",
        anonymous=True,
        watch_seconds=0.5,
    ),
    BuiltinNode(
        package="rostopic",
        executable="rostopic",
        node_name="rostopic",
        module="simkit.nodes.rostopic",
        class_name="RostopicProgram",
        anonymous=True,
    ),
    BuiltinNode(
        package="gazebo_ros",
        executable="gzserver",
        node_name="gazebo",
        module="simkit.gazebo.gzserver",
        class_name="GzServer",
        reads_packages=True,
    ),
    BuiltinNode(
        package="gazebo_ros",
        executable="gzclient",
        node_name="gazebo_gui",
        module="simkit.nodes.gzclient",
        class_name="GzclientProgram",
        anonymous=True,
        watch_seconds=0.1,  # a line of a notebook shows the window, and has no need of the hint
    ),
    BuiltinNode(
        package="gazebo_ros",
        executable="spawn_model",
        node_name="spawn_model",
        module="simkit.gazebo.spawn_model",
        class_name="SpawnModel",
        reads_packages=True,
    ),
    BuiltinNode(
        package="controller_manager",
        executable="spawner",
        node_name="spawner",
        module="simkit.nodes.controller_manager.spawner",
        class_name="Spawner",
        anonymous=True,
    ),
    BuiltinNode(
        package="controller_manager",
        executable="unspawner",
        node_name="unspawner",
        module="simkit.nodes.controller_manager.spawner",
        class_name="Unspawner",
        anonymous=True,
    ),
    BuiltinNode(
        package="controller_manager",
        executable="controller_manager",
        node_name="controller_manager",
        module="simkit.nodes.controller_manager.tool",
        class_name="ControllerManagerTool",
        anonymous=True,
        watch_seconds=1.0,
    ),
)


def builtin_nodes() -> dict[tuple[str, str], BuiltinNode]:
    """All built-in nodes by (package, executable)."""
    return {(builtin.package, builtin.executable): builtin for builtin in _BUILTIN}
