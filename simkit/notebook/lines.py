"""What each line of a notebook does. A new line is a function, and an entry in `LINES`."""

from __future__ import annotations

import contextlib
import io
import sys
from collections.abc import Callable, Mapping
from functools import partial

from simkit.cli import main as command_line
from simkit.errors import SimkitError
from simkit.launch import LaunchError, listings, summary_of
from simkit.new_package import create_package
from simkit.nodes import builtin_nodes
from simkit.notebook.current import current_simulation
from simkit.notebook.sliders import show_sliders
from simkit.notebook.starting import StartWatch
from simkit.notebook.windows import show_windows
from simkit.tools import Bounds, HelpShown, run_tool
from simkit.tools.command_line import ArgumentParser

START_SECONDS = 0.5
"""How long a simulation runs after a node was started, so that its first faults show [s]."""
BOUNDS = Bounds(seconds=5.0, messages=10)
"""When `rostopic echo` and its kin end in a notebook."""
_CTRL_C = ". Press ctrl-C to terminate"

Line = Callable[[list[str]], None]
"""Does what the words of a line ask for."""


class LineError(SimkitError):
    """A line of a notebook could not do what it was asked; IPython shows the text alone."""

    def _render_traceback_(self) -> list[str]:
        # IPython asks an exception how it wants to be shown.
        return [str(self)]


def rosrun(words: list[str]) -> None:
    """Start a node: `%rosrun package executable [arguments]`; a last `&` keeps a tf_echo running.

    The simulation runs for half a second, so that what the node says at its start stands below.
    """
    if len(words) < 2:
        raise SimkitError("usage: %rosrun PACKAGE EXECUTABLE [ARGUMENTS]")
    in_background = words[-1] == "&"
    package, executable, *arguments = words[:-1] if in_background else words
    sim = current_simulation()
    definition = builtin_nodes().get((package, executable))
    watched = None if definition is None or in_background else definition.watch_seconds
    with StartWatch(sim) as watch:
        node = sim.rosrun(package, executable, *arguments)
        try:
            sim.run_until(lambda: not node.alive, watched or START_SECONDS)
        finally:
            if watched is not None:
                node.shutdown()
    watch.show_rest(node)
    show_windows(sim, [node])
    show_sliders(sim, [node])


def roslaunch(words: list[str]) -> None:
    """Start a launch file: `%roslaunch package file [name:=value]`; `--screen` shows what all its nodes print.

    With `--nodes`, `--dump-params`, `--files`, `--ros-args`, `--args NODE` or `--find-node NODE` nothing is started.

    The simulation runs for half a second, so that what the nodes say at their start stands below.
    """
    try:
        options, names = _roslaunch_parser().parse_known_args(words)
    except HelpShown as text:
        print(text)
        return
    if not names:
        raise SimkitError("usage: %roslaunch PACKAGE FILE [NAME:=VALUE]")
    sim = current_simulation()
    try:
        plan = sim.launch_plan(*names)
    except LaunchError as error:
        raise LineError(str(error)) from None  # the words of roslaunch have several lines
    if listings.wants_list(options):
        print(listings.list_text(plan, options, sim.packages), end="")
        return
    print(summary_of(plan))
    with StartWatch(sim) as watch:
        launch = sim.roslaunch(plan, all_on_screen=options.screen)
        sim.run(START_SECONDS)
    watch.show_launch(launch)
    nodes = list(launch.nodes.values())
    show_windows(sim, nodes)
    show_sliders(sim, nodes)


def _roslaunch_parser() -> ArgumentParser:
    usage = "%%roslaunch [OPTIONS] PACKAGE FILE [NAME:=VALUE]"
    parser = ArgumentParser("%roslaunch", usage=usage)
    parser.add_argument("--screen", action="store_true", help="show what all nodes print")
    listings.add_list_options(parser)
    return parser


def tool(name: str, words: list[str]) -> None:
    """Use a tool of ROS on the simulation: rostopic, rosnode, rosservice, rosparam.

    What would go on until Ctrl-C ends after a few messages or seconds.
    """
    sim = current_simulation()
    before = set(sim.nodes())
    run_tool(sim, name, words, write=_write, bounds=BOUNDS)
    for node in sorted(set(sim.nodes()) - before):
        print(f"{node} goes on; %rosnode kill {node} ends it")
        sim.run(START_SECONDS)


def command(name: str, words: list[str]) -> None:
    """As `simkit` in a terminal: rosmsg, rossrv, rospack."""
    complaint = io.StringIO()
    with contextlib.redirect_stderr(complaint):
        code = command_line([name, *words])
    if code:
        raise SimkitError(complaint.getvalue().removeprefix(f"simkit {name}: "))


def check_urdf(words: list[str]) -> None:
    """Say what ROS makes of a URDF, and what is wrong with it: `%check_urdf hello_ros/urdf/robot.urdf`.

    A file that is refused is no error of the cell: what is wrong stands below it.
    """
    if not words:
        raise SimkitError("usage: %check_urdf FILE")
    # One stream: a notebook would show the other one apart, and in red, a mere note too.
    with contextlib.redirect_stderr(sys.stdout):
        command_line(["check_urdf", *words])


def catkin_create_pkg(words: list[str]) -> None:
    """Make the folder of a new package: `%catkin_create_pkg hello_ros rospy tf`."""
    if not words:
        raise SimkitError("usage: %catkin_create_pkg NAME [DEPENDENCIES]")
    print(create_package(words[0], words[1:]))


def _write(text: str) -> None:
    sys.stdout.write(text.replace(_CTRL_C, ""))


def _described(line: Callable[[str, list[str]], None], name: str) -> Line:
    described = partial(line, name)
    described.__doc__ = line.__doc__
    return described


LINES: Mapping[str, Line] = {
    "catkin_create_pkg": catkin_create_pkg,
    "check_urdf": check_urdf,
    "roslaunch": roslaunch,
    "rosrun": rosrun,
    "rosnode": _described(tool, "rosnode"),
    "rosparam": _described(tool, "rosparam"),
    "rosservice": _described(tool, "rosservice"),
    "rostopic": _described(tool, "rostopic"),
    "rosmsg": _described(command, "rosmsg"),
    "rospack": _described(command, "rospack"),
    "rossrv": _described(command, "rossrv"),
}
"""The lines by name."""
