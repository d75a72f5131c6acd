"""Rules on the robot description that a launch file beside a URDF sets: is it there, and is it this robot?"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import PurePosixPath

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.launch_facts import DESCRIPTION, is_known, launch_files
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.values import shown
from simkit.urdf.rules.wording import quoted
from simkit.xml import Element

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
    for launch in launch_files(sheet):
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
                node.attribute("args") or node,
                element=node,
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
    for launch in launch_files(sheet):
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
                parameter.attribute("textfile") or parameter.attribute("command") or parameter,
                element=parameter,
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
    for launch in launch_files(sheet):
        for parameter in launch.parameters:
            command = parameter.attribute("command")
            text = "" if command is None else _SUBSTITUTION.sub("x", command.value)
            words = text.replace("'", " ").split()
            program = PurePosixPath(words[0]).name if words else ""
            if command is None or program in ("cat", "xacro"):
                continue
            is_old = program == "xacro.py"
            yield Find(
                command,
                severity=Severity.ERROR if is_old else Severity.WARNING,
                element=parameter,
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
