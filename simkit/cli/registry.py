"""Which commands there are. A new one is a file beside this one, and a line here.

The module of a command is imported when it is called. It has two functions: `add_arguments(parser)` says what it takes, and
`run(arguments)` does it and gives the exit code.
"""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import argparse


@dataclass(frozen=True, kw_only=True)
class Command:
    """One word behind `simkit`."""

    name: str
    """The word, e.g. `rosmsg`."""
    summary: str
    """What it is for, in a few words."""
    group: str
    """Heading under which `simkit --help` lists it."""
    module: str
    """Module with its `add_arguments` and `run`."""

    def load(self) -> Any:
        """Its module."""
        return importlib.import_module(self.module)

    def fill(self, parser: argparse.ArgumentParser) -> None:
        """Tell `parser` what the command takes."""
        parser.set_defaults(command=self.name)
        self.load().add_arguments(parser)


_RUN, _ASK, _ROBOTS, _LOOK_UP, _HERE = (
    "Run nodes",
    "Ask a running simulation",
    "Robots",
    "Packages and types",
    "This installation",
)
_COMMANDS = (
    Command(
        name="rosrun",
        summary="run a node of a package",
        group=_RUN,
        module="simkit.cli.rosrun",
    ),
    Command(
        name="roslaunch",
        summary="start the nodes of a launch file",
        group=_RUN,
        module="simkit.cli.roslaunch",
    ),
    Command(
        name="roscore",
        summary="begin a simulation with nothing in it",
        group=_RUN,
        module="simkit.cli.roscore",
    ),
    Command(
        name="rostopic",
        summary="list, echo, publish topics",
        group=_ASK,
        module="simkit.cli.shared_tool",
    ),
    Command(
        name="rosnode",
        summary="list, inspect, end nodes",
        group=_ASK,
        module="simkit.cli.shared_tool",
    ),
    Command(
        name="rosservice",
        summary="list and call services",
        group=_ASK,
        module="simkit.cli.shared_tool",
    ),
    Command(
        name="rosparam",
        summary="get and set parameters",
        group=_ASK,
        module="simkit.cli.shared_tool",
    ),
    Command(
        name="check_urdf",
        summary="what ROS makes of a URDF, and what is wrong with it",
        group=_ROBOTS,
        module="simkit.cli.check_urdf",
    ),
    Command(
        name="xacro",
        summary="make a URDF of a file with macros",
        group=_ROBOTS,
        module="simkit.cli.xacro",
    ),
    Command(
        name="rosmsg",
        summary="show and list message types",
        group=_LOOK_UP,
        module="simkit.cli.rosmsg",
    ),
    Command(
        name="rossrv",
        summary="show and list service types",
        group=_LOOK_UP,
        module="simkit.cli.rosmsg",
    ),
    Command(
        name="catkin_create_pkg",
        summary="make a package",
        group=_LOOK_UP,
        module="simkit.cli.catkin_create_pkg",
    ),
    Command(
        name="rospack",
        summary="list and find packages",
        group=_LOOK_UP,
        module="simkit.cli.rospack",
    ),
    Command(
        name="doctor",
        summary="what works on this machine, and what is lost without the rest",
        group=_HERE,
        module="simkit.cli.doctor",
    ),
)


def commands() -> dict[str, Command]:
    """All commands by name, in the order of the help."""
    return {command.name: command for command in _COMMANDS}
