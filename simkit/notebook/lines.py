"""What each line of a notebook does: the commands of `simkit.commands.table`, on the newest open simulation."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from functools import partial

from IPython.display import display

from simkit.commands.command import Bounds, Call, ErrorText, texts
from simkit.commands.errors import HelpShown, UsageError
from simkit.commands.roslaunch import read
from simkit.commands.table import COMMANDS, Entry, TerminalPlace
from simkit.errors import SimkitError
from simkit.graph.process import ScriptNode
from simkit.launch import LaunchError, listings, summary_of
from simkit.nodes import builtin_nodes
from simkit.nodes.builtin import RunningBuiltin
from simkit.nodes.joint_state_publisher import JointStatePublisherGui
from simkit.notebook.starting import StartWatch
from simkit.simulation import Simulation, newest_simulation

START_SECONDS = 0.5
"""How long a simulation runs after a node was started, so that its first faults show [s]."""
BOUNDS = Bounds(seconds=5.0, messages=10)
"""When `rostopic echo` and its kin end in a notebook."""
_CTRL_C = ". Press ctrl-C to terminate"
_of_lines: list[Simulation] = []
"""The one that a line made: a notebook that has only lines has nobody else to hold it."""

Line = Callable[[list[str]], None]
"""Does what the words of a line ask for."""


class LineError(SimkitError):
    """A line of a notebook could not do what it was asked; IPython shows the text alone."""

    def _render_traceback_(self) -> list[str]:
        # IPython asks an exception how it wants to be shown.
        return [str(self)]


def current_simulation() -> Simulation:
    """The newest open simulation of this process; a new one if there is none."""
    newest = newest_simulation()
    if newest is not None:
        return newest
    made = Simulation()
    _of_lines[:] = [made]
    return made


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


def roslaunch(words: list[str]) -> None:
    """Start a launch file: `%roslaunch package file [name:=value]`; `--screen` shows what all its nodes print.

    With `--nodes`, `--dump-params`, `--files`, `--ros-args`, `--args NODE` or `--find-node NODE` nothing is started.

    The simulation runs for half a second, so that what the nodes say at their start stands below.
    """
    try:
        options, names = read(words, program="%roslaunch")
    except HelpShown as text:
        print(text)
        return
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
    show_windows(sim, list(launch.nodes.values()))


def shared(entry: Entry, words: list[str]) -> None:
    """Use a tool of ROS on the simulation.

    What would go on until Ctrl-C ends after a few messages or seconds.
    """
    sim = current_simulation()
    before = set(sim.nodes())
    _show(entry, Call(simulation=sim, words=words, bounds=BOUNDS))
    for node in sorted(set(sim.nodes()) - before):
        print(f"{node} goes on; %rosnode kill {node} ends it")
        sim.run(START_SECONDS)


def here(entry: Entry, words: list[str]) -> None:
    """As `simkit` does in a terminal."""
    try:
        _show(entry, Call(words=words))
    except HelpShown as text:
        print(text)
    except UsageError as error:
        raise SimkitError(str(error).removeprefix(f"simkit {entry.name}: ")) from None


def show_windows(sim: Simulation, nodes: Iterable[ScriptNode | RunningBuiltin]) -> None:
    """Display the view of each rviz or gzclient, and the sliders of each joint_state_publisher_gui.

    Args:
        sim: The simulation.
        nodes: What was just started.
    """
    for node in nodes:
        window = sim.window_of(node)
        if window is not None:
            display(window)  # type: ignore[no-untyped-call]
        program = getattr(node, "program", None)
        if isinstance(program, JointStatePublisherGui) and node.alive:
            display(sim.joint_sliders(node.name))  # type: ignore[no-untyped-call]


def _show(entry: Entry, call: Call) -> None:
    for text in texts(call, entry.load()(call)):
        # One stream: a notebook would show the other one apart, and in red, a mere note too.
        sys.stdout.write(str(text) if isinstance(text, ErrorText) else text.replace(_CTRL_C, ""))


def _lines() -> Mapping[str, Line]:
    own: Mapping[str, Line] = {"rosrun": rosrun, "roslaunch": roslaunch}
    return {
        name: own[name] if name in own else _described(entry)
        for name, entry in COMMANDS.items()
        if not entry.not_in_notebook
    }


def _described(entry: Entry) -> Line:
    line: Callable[[Entry, list[str]], None] = here if entry.place is TerminalPlace.HERE else shared
    described = partial(line, entry)
    described.__doc__ = f"{entry.summary[:1].upper()}{entry.summary[1:]}.\n\n{line.__doc__}"
    return described


LINES: Mapping[str, Line] = _lines()
"""The lines by name."""
