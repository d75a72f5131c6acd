"""Rules about launch files beside a URDF."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import PurePosixPath

from simkit.diagnostics import Find, Part, Related, Severity, rule
from simkit.diagnostics.table import related
from simkit.urdf.rules.companions import DESCRIPTION, companion_launches, is_known
from simkit.urdf.rules.sheet import CompanionKind, Sheet
from simkit.urdf.rules.wording import quoted, shown
from simkit.xml import Element, Span

_KNOWN_INCLUDES = ("empty_world.launch",)
"Launch files that set no description of a robot."
_SUBSTITUTION = re.compile(r"\$\([^()]*\)")


@rule(
    "LCH-E03",
    "a robot description that is not set",
    Severity.ERROR,
    here="The node ends with that message.",
    gazebo="robot_state_publisher and spawn_model end; gazebo_ros_control waits for ever.",
)
def description_missing(sheet: Sheet) -> Iterator[Find]:
    """A node asks for a robot description that the launch file does not set.

    Symptom: `Could not find parameter robot_description on parameter server`, a spawner that ends with `KeyError`, a plugin
    that waits for ever.

    Cause: The `<param>` is missing, has another name, or stands in a namespace of its own, inside of a `<node>` for
    example.

    Remedy: One `<param name="robot_description" ...>` in `<launch>`, in front of the nodes, and the same name behind
    `-param`.

    Right:

        <param name="robot_description" textfile="$(find hello_ros)/urdf/hello_ros_robot_1.urdf"/>
        <node name="spawn_urdf" pkg="gazebo_ros" type="spawn_model"
              args="-param robot_description -urdf -model hello_ros_robot"/>
    """
    for launch in companion_launches(sheet):
        if any(_may_set_description(one) for one in launch.others):
            continue
        names = launch.names()
        if not all(is_known(name) for name in names):
            continue
        given = {name.rpartition("/")[2] for name in names}
        for node, wanted in launch.readers():
            if not is_known(wanted) or wanted in given:
                continue
            near = sheet.near(wanted, names)
            yield Find(
                Part(node, "args"),
                companion=launch.companion,
                what=f"node {quoted(node.get('name'))} needs the parameter {quoted(wanted)}, and the launch file does not set it",
                remedy=f"Did you mean {' or '.join(map(quoted, near))}? The names must be the same."
                if near
                else f'Add <param name="{shown(wanted)}" textfile="$(find ...)/urdf/{_own_name(sheet)}"/>.',
            )


@rule(
    "LCH-I15",
    "a launch file that loads another URDF",
    Severity.NOTE,
    here="simkit roslaunch loads the file that is named there.",
    gazebo="roslaunch loads the file that is named there.",
)
def other_description(sheet: Sheet) -> Iterator[Find]:
    """The launch file loads another URDF.

    Symptom: Changes of the file have no effect.

    Cause: The launch file was copied, and its `textfile` still names the robot of the last exercise.

    Remedy: Name this file, or check the other one.

    Right:

        <param name="robot_description" textfile="$(find hello_ros)/urdf/hello_ros_robot_2.urdf"/>
    """
    own = _own_name(sheet)
    for launch in companion_launches(sheet):
        for parameter in launch.parameters:
            source = parameter.get("textfile") or parameter.get("command") or ""
            if (parameter.get("name") or "").rpartition("/")[2] != DESCRIPTION:
                continue
            words = [
                word for word in source.replace("'", " ").replace('"', " ").split() if "." in word
            ]
            loaded = [
                PurePosixPath(word).name for word in words if word.endswith((".urdf", ".xacro"))
            ]
            if not loaded or own in loaded or own.removesuffix(".urdf") + ".urdf.xacro" in loaded:
                continue
            yield Find(
                Part(parameter, "command" if parameter.get("textfile") is None else "textfile"),
                companion=launch.companion,
                what=f"the launch file loads {quoted(loaded[0])}, not {quoted(own)}",


                remedy=f"Name {quoted(own)} there if this is the robot you mean.",
            )  # fmt: skip


@rule(
    "LCH-E02",
    "a command that gives no robot description",
    Severity.ERROR,
    here="simkit runs no program of a launch file but xacro; what cat does, it does itself.",
    gazebo="roslaunch stops with: Cannot load command parameter, if the program is not there.",
    remedy='Write textfile="..." for a URDF, or command="xacro ..." for a xacro file.',
)
def description_command(sheet: Sheet) -> Iterator[Find]:
    """A `command="..."` that does not give a robot description.

    Symptom: `Invalid <param> tag: Cannot load command parameter`.

    Cause: The program is not there. `xacro.py` has been renamed to `xacro`, `cat` does not exist on Windows.

    Remedy: `textfile="..."` for a URDF, `command="xacro FILE"` for a xacro file.

    Right:

        <param name="robot_description" textfile="$(find my_robot_urdf)/urdf/m2wr.urdf"/>
    """
    for launch in companion_launches(sheet):
        for parameter in launch.parameters:
            command = parameter.attribute("command")
            text = "" if command is None else _SUBSTITUTION.sub("x", command.value)
            words = text.replace("'", " ").split()
            program = PurePosixPath(words[0]).name if words else ""
            if command is None or program in ("cat", "xacro"):
                continue
            is_old = program == "xacro.py"
            yield Find(
                Part(parameter, "command"),
                severity=Severity.ERROR if is_old else Severity.WARNING,
                companion=launch.companion,
                what=f"the command {quoted(program)} "
                + ("is gone: it is called xacro now" if is_old else "is neither cat nor xacro"),
            )


def _may_set_description(element: Element) -> bool:
    """Whether an `<include>` or `<rosparam>` may set a description; no one looks into it here."""
    if element.name == "rosparam":
        return DESCRIPTION in element.text or element.get("param") == DESCRIPTION
    name = PurePosixPath((element.get("file") or "").strip()).name
    return name not in _KNOWN_INCLUDES


def _own_name(sheet: Sheet) -> str:
    return PurePosixPath(sheet.document.file.replace("\\", "/")).name


_PLUGIN = "libgazebo_ros_joint_state_publisher.so"
_CONTROLLER = "joint_state_controller/JointStateController"


@rule(
    "LCH-E04",
    "a launch file that is not well-formed",
    Severity.ERROR,
    here="simkit roslaunch refuses the file.",
    gazebo="roslaunch refuses the file: Invalid roslaunch XML syntax.",
)
def launch_xml(sheet: Sheet) -> Iterator[Find]:
    """A launch file is not well-formed XML.

    Symptom: `RLException: Invalid roslaunch XML syntax`, and nothing is started.

    Cause: A tag that is not closed, a quotation mark that is missing, a stray `>`, `--` in a comment.

    Remedy: The place is named here; roslaunch names the place where its parser gave up, which may be far below.

    Right:

        <rosparam file="$(find hello_ros)/urdf/controllers_simple.yaml" command="load"/>
    """
    for launch in companion_launches(sheet):
        for fault in launch.document.faults:
            yield Find(
                fault.span,
                companion=launch.companion,
                what=fault.what,
                remedy=fault.remedy,
                related=() if fault.other is None else [(fault.other, "it belongs to this")],
            )


@rule(
    "LCH-W05",
    "use_gui, which ROS Noetic ignores",
    Severity.NOTE,
    here="simkit shows the sliders, as Melodic does.",
    gazebo="Melodic opens the window with a warning; Noetic ignores the switch, and no sliders appear.",
    remedy="For Noetic start the node joint_state_publisher_gui of the package joint_state_publisher_gui.",
)
def old_gui_switch(sheet: Sheet) -> Iterator[Find]:
    """`use_gui` asks joint_state_publisher for sliders.

    Symptom: In ROS Noetic no window with sliders opens.

    Cause: Melodic's joint_state_publisher opened the window when `use_gui` was true, and warned that this would go away.
    Noetic's does not read it: the sliders are a node of their own.

    Remedy: Start `joint_state_publisher_gui` instead. Here both work.

    Right:

        <node name="joint_state_publisher_gui" pkg="joint_state_publisher_gui" type="joint_state_publisher_gui"/>
    """
    for launch in companion_launches(sheet):
        every = [] if launch.document.root is None else list(launch.document.root.walk())
        for parameter in every:
            if parameter.name != "param" or (parameter.get("name") or "").lstrip("/~") != "use_gui":
                continue
            yield Find(
                parameter,
                companion=launch.companion,
                what="use_gui is a switch of ROS Melodic",
            )


@rule(
    "CTL-W07",
    "two publishers of joint states",
    Severity.WARNING,
    here="The robot jumps between two poses in the view.",
    gazebo="RViz shows the robot jumping between two poses.",
    remedy="Leave the node out when the robot is simulated: the simulation knows where the joints are.",
)
def two_joint_states(sheet: Sheet) -> Iterator[Find]:
    """Two nodes publish the positions of the joints.

    Symptom: In RViz the robot flickers between two poses.

    Cause: The simulation publishes `/joint_states` (by a plugin, or by a JointStateController), and so does
    joint_state_publisher with its sliders. Each says where the joints are, and they disagree.

    Remedy: One of them. With a simulation leave joint_state_publisher out; robot_state_publisher stays.

    Right:

        <gazebo>
          <plugin name="joint_state_publisher" filename="libgazebo_ros_joint_state_publisher.so">
            <jointName>hip, shoulder</jointName>
          </plugin>
        </gazebo>
    """
    publishers = [
        related(one.element, "the plugin", sheet.document)
        for one in sheet.plugins
        if one.filename == _PLUGIN
    ]
    publishers += [
        Related(file=one.file, span=Span(1, 1), text=f"has a {_CONTROLLER}")
        for one in sheet.companions
        if one.kind is CompanionKind.YAML and _CONTROLLER in one.text
    ]
    for launch in companion_launches(sheet):
        spawns = any(node.get("type") == "spawn_model" for node in launch.nodes)
        for node in launch.nodes:
            if (
                (node.get("type") or "").startswith("joint_state_publisher")
                and publishers
                and spawns
            ):
                yield Find(
                    node,
                    companion=launch.companion,
                    what=f"node {quoted(node.get('name'))} and the simulation both publish /joint_states",
                    related=publishers[:1],
                )
