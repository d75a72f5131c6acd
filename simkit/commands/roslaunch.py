"""`roslaunch`: the nodes and parameters of a launch file, until they have ended or their terminal ends them.

Source: roslaunch of ROS Noetic for the command line and what it prints; `--for`, `--fast` and `--seed` are ours.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from simkit.commands.command import Answer, Call, Keys, Wait
from simkit.commands.errors import UsageError
from simkit.commands.parser import ArgumentParser
from simkit.commands.rosrun import LAST_WORDS, press, takes_keys
from simkit.commands.run_options import add_run_options
from simkit.errors import SimkitError
from simkit.graph.log import LogLevel
from simkit.launch import Launch, listings, summary_of
from simkit.launch.budget import MAX_LAUNCH_BYTES

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
    add_run_options(parser)
    add_own_options(parser)


def add_own_options(parser: argparse.ArgumentParser) -> None:
    """What to show, and what to list instead of starting anything."""
    parser.add_argument(
        "--screen", action="store_true", help="show what all nodes print, whatever output= says"
    )
    listings.add_list_options(parser)


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
    listed = listings.wants_list(arguments)
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


def read(words: Sequence[str], *, program: str) -> tuple[argparse.Namespace, list[str]]:
    """The options among the words after `roslaunch`, and the others.

    Args:
        words: The words.
        program: Who complains, e.g. `%roslaunch`.

    Raises:
        UsageError: They name no launch file.
    """
    usage = f"{program} [OPTIONS] PACKAGE FILE [NAME:=VALUE]".replace("%", "%%")
    parser = ArgumentParser(program, usage=usage)
    add_own_options(parser)
    options, names = parser.parse_known_args(words)
    if not names:
        raise UsageError(f"usage: {program} PACKAGE FILE [NAME:=VALUE]")
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
    options, names = read(call.words, program="roslaunch")
    sim = call.sim
    plan = sim.launch_plan(*names)
    if listings.wants_list(options):
        yield listings.list_text(plan, options, sim.packages)
        return 0
    yield f"{call.opening}{summary_of(plan)}\n"
    if call.hosts and not plan.nodes:
        yield (
            "no nodes: the parameters are set, and stay while this terminal runs; "
            "start nodes in another one\n"
        )
    begin = len(sim.log)
    launch = sim.roslaunch(plan, all_on_screen=options.screen)
    nodes = list(launch.nodes.values())
    call.show_windows(nodes)
    said = _Said(sim, launch, begin)
    if any(map(takes_keys, nodes)):
        yield Keys(lambda key: _press_all(launch, key))
    try:
        while launch.exit_code is None or launch.alive:
            yield said.news()
            yield Wait(until=lambda: said.has_news or _is_over(launch))
        yield said.news()
        if call.hosts and not plan.nodes:
            yield Wait()
        yield f"{CLOSING}done\n" if launch.handles else f"{NO_PROCESSES}\n{CLOSING}"
        return exit_code_of(launch)
    except KeyboardInterrupt:
        launch.shutdown()
        yield said.news()
        yield Wait(until=lambda: not launch.alive, seconds=LAST_WORDS)
        yield f"{said.news()}{CLOSING}done\n"
        return 0
    finally:
        launch.shutdown()


def exit_code_of(launch: Launch) -> int:
    """What `roslaunch` ends with: 1 if a required node has ended, or nothing could be started."""
    return 1 if launch.exit_code or (launch.failures and not launch.handles) else 0


def _press_all(launch: Launch, key: str) -> None:
    for node in launch.nodes.values():
        press(node, key)


def _is_over(launch: Launch) -> bool:
    return launch.exit_code is not None and not launch.alive


class _Said:
    """What a launch and its nodes have said, as it comes."""

    def __init__(self, sim: Simulation, launch: Launch, begin: int) -> None:
        self._sim = sim
        self._launch = launch
        self._lines = 0
        self._shown: dict[int, int] = {}
        self._records = begin

    @property
    def has_news(self) -> bool:
        """Whether there may be more than was given."""
        return (
            len(self._launch.lines) > self._lines
            or len(self._sim.log) > self._records
            or any(
                len(node.output) > self._shown.get(number, 0)
                for number, (_, node) in enumerate(self._launch.handles)
            )
        )

    def news(self) -> str:
        """What has come since the last time."""
        lines = self._launch.lines[self._lines :]
        self._lines += len(lines)
        said = "".join(f"{line}\n" for line in lines)
        return "".join([*self._outputs(), *self._log(), said])

    def _outputs(self) -> Iterator[str]:
        for number, (planned, node) in enumerate(self._launch.handles):
            shown = self._shown.get(number, 0)
            new = node.output[shown:]
            self._shown[number] = shown + len(new)
            if new and self._launch.hides(planned.resolved_name):
                self._launch.note_hidden(planned.resolved_name)
            else:
                yield new

    def _log(self) -> Iterator[str]:
        names = {planned.resolved_name for planned, _ in self._launch.handles}
        records = self._sim.log[self._records :]
        self._records += len(records)
        for record in records:
            if record.node not in names:
                continue
            if record.level < LogLevel.WARN and self._launch.hides(record.node):
                self._launch.note_hidden(record.node)
            elif record.level >= LogLevel.INFO:
                yield f"{record}\n"
