"""`roslaunch`: the nodes and parameters of a launch file, until they have ended or their terminal ends them.

Source: roslaunch of ROS Noetic for the command line and what it prints; `--for`, `--fast` and `--seed` are ours.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from simkit.commands import rosrun
from simkit.commands.command import Answer, Call, Keys, Wait
from simkit.commands.errors import UsageError
from simkit.commands.parser import ArgumentParser
from simkit.commands.rosrun import LAST_WORDS, NodeOutput, press, takes_keys, watch_output
from simkit.errors import SimkitError
from simkit.graph.log import LogLevel
from simkit.launch import Launch, summary, summary_of
from simkit.launch.files import MAX_LAUNCH_BYTES

if TYPE_CHECKING:
    from simkit.simulation import Simulation

NO_PROCESSES = "No processes to monitor"
"""What roslaunch says when there is nothing to wait for."""
CLOSING = "shutting down processing monitor...\n... shutting down processing monitor complete\n"
"""What roslaunch says at its end."""
USAGE = (
    "simkit roslaunch [OPTIONS] PACKAGE FILE [NAME:=VALUE]\n"
    "       simkit roslaunch [OPTIONS] PATH [NAME:=VALUE]"
)
"""Its command line in a terminal."""
EPILOG = (
    "The nodes join the simulation of another terminal; if none runs, one begins, which others then join. "
    "Ctrl-C ends them all. With --for, --fast or --seed they have a simulation of their own. If PATH is -, the "
    "launch file is read from standard input. What an id such as LCH-E06 means: simkit check_urdf --explain LCH-E06."
)
"""What its help says below the options."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """How long and how fast to run, and what roslaunch itself has."""
    rosrun.add_options(parser)
    add_own_options(parser)


def add_own_options(parser: argparse.ArgumentParser) -> None:
    """What to show, and what to list instead of starting anything."""
    parser.add_argument(
        "--screen", action="store_true", help="show what all nodes print, whatever output= says"
    )
    summary.add_list_options(parser)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Package and file, or path, and arguments."""
    parser.add_argument("words", metavar="PACKAGE FILE", nargs=argparse.REMAINDER)


def own_words(arguments: argparse.Namespace, rest: list[str]) -> list[str]:
    """The words for `roslaunch` itself, which may run in another terminal: a path is made whole.

    Args:
        arguments: What the parser has found.
        rest: Package and file, or path, and arguments.

    Raises:
        SimkitError: No file is named, or standard input holds none.
    """
    if not rest:
        raise SimkitError("which launch file? simkit roslaunch PACKAGE FILE, or PATH")
    listed = summary.wants_list(arguments)
    if listed:  # nothing is started, so nobody is joined
        arguments.fast = True
    first, *more = rest
    if first == "-":
        first = _standard_input(quiet=listed)
    elif "<" not in first and Path(first).is_file():
        first = str(Path(first).absolute())
    options = ["--screen"] if arguments.screen else []
    for name in ("dump_params", "nodes", "files", "ros_args"):
        options += [f"--{name.replace('_', '-')}"] if getattr(arguments, name) else []
    for name, option in (("node_args", "--args"), ("find_node", "--find-node")):
        options += [option, getattr(arguments, name)] if getattr(arguments, name) else []
    return [*options, first, *more]


def _read(words: Sequence[str]) -> tuple[argparse.Namespace, list[str]]:
    """The options among the words after `roslaunch`, and the others."""
    parser = ArgumentParser("roslaunch", usage="roslaunch [OPTIONS] PACKAGE FILE [NAME:=VALUE]")
    add_own_options(parser)
    options, names = parser.parse_known_args(words)
    if not names:
        raise UsageError("usage: roslaunch PACKAGE FILE [NAME:=VALUE]")
    return options, names


def _standard_input(*, quiet: bool) -> str:
    """The launch file that stands on standard input."""
    say = (lambda _text: None) if quiet else print
    say("Passed '-' as file argument, attempting to read roslaunch XML from stdin.")
    data = sys.stdin.buffer.read(MAX_LAUNCH_BYTES + 1)
    say(f"... {len(data)} bytes read successfully.\n")
    text = data.decode("utf-8", "replace")
    if "<" not in text:
        raise SimkitError("standard input holds no launch file: it begins with <launch>")
    return text


def run(call: Call) -> Answer:
    """Launch, give what the launch and its nodes say, and end them with the command."""
    options, names = _read(call.words)
    sim = call.sim
    plan = sim.launch_plan(*names)
    if summary.wants_list(options):
        yield summary.list_text(plan, options, sim.packages)
        return 0
    yield f"{call.opening}{summary_of(plan)}\n"
    if call.hosts and not plan.nodes:
        yield (
            "no nodes: the parameters are set, and stay while this terminal runs; "
            "start nodes in another one\n"
        )
    output = _output(sim, lambda: launch)
    launch = sim.roslaunch(plan, all_on_screen=options.screen)
    nodes = list(launch.nodes.values())
    for node in nodes:
        call.show_window(node)
    if any(map(takes_keys, nodes)):
        yield Keys(lambda key: _press_all(launch, key))
    try:
        yield from watch_output(call, output, lambda: _is_over(launch), seconds=call.bounds.start)
        if call.leaves_nodes:
            return exit_code_of_launch(launch)
        if call.hosts and not plan.nodes:
            yield Wait()
        yield f"{CLOSING}done\n" if launch.handles else f"{NO_PROCESSES}\n{CLOSING}"
        return exit_code_of_launch(launch)
    except KeyboardInterrupt:
        launch.shutdown()
        yield output.new()
        yield Wait(until=lambda: not launch.alive, seconds=LAST_WORDS)
        yield f"{output.new()}{CLOSING}done\n"
        return 0
    finally:
        if not call.leaves_nodes:
            launch.shutdown()


def exit_code_of_launch(launch: Launch) -> int:
    """What `roslaunch` ends with: 1 if a required node has ended, or nothing could be started."""
    return 1 if launch.exit_code or (launch.failures and not launch.handles) else 0


def _press_all(launch: Launch, key: str) -> None:
    for node in launch.nodes.values():
        press(node, key)


def _is_over(launch: Launch) -> bool:
    return launch.exit_code is not None and not launch.alive


def _output(sim: Simulation, launch: Callable[[], Launch]) -> NodeOutput:
    """What a launch and its nodes will have said.

    Args:
        sim: The simulation.
        launch: The launch, once it runs.
    """
    return NodeOutput(
        sim,
        lambda: [(planned.resolved_name, node) for planned, node in launch().handles],
        form=lambda record: f"{record}\n" if record.level >= LogLevel.INFO else "",
        hides=lambda name: launch().hides(name),
        note_hidden=lambda name: launch().note_hidden(name),
        lines=lambda: launch().lines,
    )
