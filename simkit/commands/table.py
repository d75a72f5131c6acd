"""Which commands there are. A new one is a file beside this one, a line here, and a test.

The module of a command is imported when it is called: its function `run` takes a `Call` and yields what is printed.
"""

from __future__ import annotations

import importlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from types import ModuleType
from typing import TYPE_CHECKING, cast

from simkit.commands.command import Answer, Bounds, Call, Write, texts, to_stdout
from simkit.commands.errors import ToolError
from simkit.errors import SimkitError, UnknownNameError

if TYPE_CHECKING:
    from collections.abc import Callable

    from simkit.simulation import Simulation


class TerminalPlace(Enum):
    """Where a command is done that is typed in a terminal."""

    HERE = "in this process; no simulation is needed"
    SHARED = "in the simulation of another terminal"
    HOSTED = "in the simulation of another terminal, or in one that this terminal hosts"


@dataclass(frozen=True, slots=True, kw_only=True)
class Entry:
    """One word behind `simkit`, or behind `%` in a notebook."""

    name: str
    """The word, e.g. `rosmsg`."""
    summary: str
    """What it is for, in a few words."""
    group: str
    """Heading under which `simkit --help` lists it."""
    module: str = ""
    """Module of its function, in this package; the one of its name if empty."""
    function: str = "run"
    """Name of the function there."""
    place: TerminalPlace = TerminalPlace.HERE
    """Where it is done."""
    not_in_notebook: str = ""
    """Why it is no line of a notebook; empty if it is one."""

    def load_module(self) -> ModuleType:
        """The module of its function."""
        return importlib.import_module(f"simkit.commands.{self.module or self.name}")

    def load(self) -> Callable[[Call], Answer]:
        """Its function."""
        return cast("Callable[[Call], Answer]", getattr(self.load_module(), self.function))


_RUN, _ASK, _ROBOTS, _LOOK_UP = (
    "Run nodes",
    "Ask a running simulation",
    "Robots",
    "Packages and types",
)
THIS_INSTALLATION = "This installation"
"""Group of the commands that ROS has not."""
_ENTRIES = (
    Entry(
        name="rosrun",
        summary="run a node of a package",
        group=_RUN,
        place=TerminalPlace.HOSTED,
    ),
    Entry(
        name="roslaunch",
        summary="start the nodes of a launch file",
        group=_RUN,
        place=TerminalPlace.HOSTED,
    ),
    Entry(
        name="roscore",
        summary="begin a simulation with nothing in it",
        group=_RUN,
        place=TerminalPlace.HOSTED,
        not_in_notebook="a notebook has a simulation from its first line on",
    ),
    Entry(
        name="rostopic",
        summary="list, echo, publish topics",
        group=_ASK,
        place=TerminalPlace.SHARED,
    ),
    Entry(
        name="rosnode",
        summary="list, inspect, end nodes",
        group=_ASK,
        place=TerminalPlace.SHARED,
    ),
    Entry(
        name="rosservice",
        summary="list and call services",
        group=_ASK,
        place=TerminalPlace.SHARED,
    ),
    Entry(
        name="rosparam",
        summary="get and set parameters",
        group=_ASK,
        place=TerminalPlace.SHARED,
    ),
    Entry(
        name="check_urdf",
        summary="what ROS makes of a URDF, and what is wrong with it",
        group=_ROBOTS,
    ),
    Entry(
        name="urdf_to_graphiz",
        summary="draw the tree of a robot",
        group=_ROBOTS,
    ),
    Entry(
        name="xacro",
        summary="make a URDF of a file with macros",
        group=_ROBOTS,
    ),
    Entry(
        name="rosmsg",
        summary="show and list message types",
        group=_LOOK_UP,
    ),
    Entry(
        name="rossrv",
        summary="show and list service types",
        group=_LOOK_UP,
        module="rosmsg",
        function="run_rossrv",
    ),
    Entry(
        name="catkin_create_pkg",
        summary="make a package",
        group=_LOOK_UP,
    ),
    Entry(
        name="rospack",
        summary="list and find packages",
        group=_LOOK_UP,
    ),
    Entry(
        name="roscd",
        summary="go to the folder of a package",
        group=_LOOK_UP,
        module="rosbash",
        function="run_roscd",
        not_in_notebook="a notebook stays in its folder; %rosls PACKAGE shows another one",
    ),
    Entry(
        name="rosls",
        summary="list the files of a package",
        group=_LOOK_UP,
        module="rosbash",
        function="run_rosls",
    ),
    Entry(
        name="rosed",
        summary="edit a file of a package",
        group=_LOOK_UP,
        module="rosbash",
        function="run_rosed",
        not_in_notebook="it opens an editor in the terminal",
    ),
    Entry(
        name="rosversion",
        summary="show the version of a package, or of ROS",
        group=_LOOK_UP,
        module="rospack",
        function="run_rosversion",
    ),
    Entry(
        name="doctor",
        summary="what works on this machine, and what is lost without the rest",
        group=THIS_INSTALLATION,
        not_in_notebook="it asks about the machine, and takes some seconds: a terminal is the place for it",
    ),
    Entry(
        name="env",
        summary="put the words of ROS on the PATH of this terminal",
        group=THIS_INSTALLATION,
        not_in_notebook="a notebook has them as lines: %rosrun",
    ),
    Entry(
        name="shell",
        summary="open a shell with the words of ROS on its PATH",
        group=THIS_INSTALLATION,
        module="env",
        function="run_shell",
        not_in_notebook="a notebook has them as lines: %rosrun",
    ),
    Entry(
        name="complete",
        summary="what Tab offers",
        group=THIS_INSTALLATION,
        module="completion",
        not_in_notebook="a notebook completes by itself",
    ),
)
COMMANDS: Mapping[str, Entry] = {entry.name: entry for entry in _ENTRIES}
"""All commands by name, in the order of the help."""


def run_command(
    sim: Simulation,
    name: str,
    words: Sequence[str],
    *,
    write: Write = to_stdout,
    bounds: Bounds | None = None,
) -> None:
    """Do what a command line asks for: `run_command(sim, "rostopic", ["echo", "/tf", "-n", "1"])`.

    Args:
        sim: The simulation it acts on, whose time passes meanwhile.
        name: Name of the command.
        words: The words after it.
        write: Takes what it prints, line breaks included.
        bounds: When it ends if it would go on until Ctrl-C.

    Raises:
        UnknownNameError: There is no such command.
        ToolError: It cannot do it; the text is what the original prints, `exit_code` its code.
    """
    if name not in COMMANDS:
        raise UnknownNameError("command", name, COMMANDS)
    call = Call(simulation=sim, words=words, bounds=bounds or Bounds())
    try:
        for text in texts(call, COMMANDS[name].load()(call)):
            write(text)
    except ToolError:
        raise
    except SimkitError as error:
        raise ToolError(f"ERROR: {error}") from error
