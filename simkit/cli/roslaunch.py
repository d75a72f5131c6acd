"""`simkit roslaunch`: the nodes and parameters of a launch file, in the simulation of another terminal or in a new one.

Source: roslaunch of ROS Noetic for the command line and what it prints; `--for`, `--fast` and `--seed` are ours.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

from simkit.cli.complaint import FAILURE
from simkit.cli.pace import End, run_for_a_person
from simkit.cli.run_options import LAST_WORDS, add_run_options, take_options, wants_own_simulation
from simkit.cli.sharing import OnlyFrom, elsewhere, host, running_session, show
from simkit.diagnostics import Layout
from simkit.errors import SimkitError
from simkit.graph.screen import StreamScreen
from simkit.launch import Launch, LaunchError, LaunchPlan, listings, summary_of
from simkit.launch.budget import MAX_LAUNCH_BYTES
from simkit.live.jobs import keys_of_this_terminal
from simkit.live.launch_job import CLOSING, NO_PROCESSES, exit_code_of
from simkit.live.moving import offer_moves
from simkit.live.windows import open_windows
from simkit.simulation import Simulation


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Package and file, arguments, how long and how fast to run, and what to list instead."""
    parser.usage = "simkit roslaunch [OPTIONS] PACKAGE FILE [NAME:=VALUE]\n       simkit roslaunch [OPTIONS] PATH [NAME:=VALUE]"
    parser.epilog = (
        "The nodes join the simulation of another terminal; if none runs, one begins, which others then join. "
        "Ctrl-C ends them all. With --for, --fast or --seed they have a simulation of their own. If PATH is -, the "
        "launch file is read from standard input. What an id such as LCH-E06 means: simkit check_urdf --explain LCH-E06."
    )
    _add_options(parser)
    parser.add_argument("words", metavar="PACKAGE FILE", nargs=argparse.REMAINDER)


def run(arguments: argparse.Namespace) -> int:
    """Launch until the nodes have ended, the time is over, or Ctrl-C comes; 1 for a fault."""
    words = take_options(arguments, arguments.words, _add_options, program="simkit roslaunch")
    if not words:
        raise SimkitError("which launch file? simkit roslaunch PACKAGE FILE, or PATH")
    try:
        return _run(arguments, words)
    except LaunchError as error:
        print(error.text(Layout.of(sys.stderr)), file=sys.stderr)
        return FAILURE
    except SimkitError as error:  # roslaunch's own words have several lines
        print(error, file=sys.stderr)
        return FAILURE


def _run(arguments: argparse.Namespace, words: list[str]) -> int:
    alone = wants_own_simulation(arguments)
    listed = listings.wants_list(arguments)
    if words[0] == "-":
        words = [_read_text(quiet=listed), *words[1:]]
    if not alone and not listed and running_session() is not None:
        screen = ["--screen"] if arguments.screen else []
        return elsewhere(["roslaunch", *screen, *_from_anywhere(words)])
    with Simulation(arguments.seed or 0) as sim:
        plan = sim.launch_plan(*words)
        if listed:
            show(listings.list_text(plan, arguments, sim.packages))
            return 0
        return _launch(sim, plan, arguments, alone=alone)


def _launch(
    sim: Simulation, plan: LaunchPlan, arguments: argparse.Namespace, *, alone: bool
) -> int:
    others = "" if alone else "; other terminals join it; Ctrl-C ends it"
    show(f"started a simulation{others}\n\n{summary_of(plan)}\n")
    launch = sim.roslaunch(plan, all_on_screen=arguments.screen)
    offer_moves(launch.nodes.values())
    open_windows(sim, launch.nodes.values())
    end = _wait(sim, launch, arguments, alone=alone)
    if end == "interrupted":
        launch.shutdown()
        sim.run_until(lambda: not launch.alive, timeout=LAST_WORDS)
        show(f"{CLOSING}done\n")
        return 0
    if end == "over" and launch.exit_code is not None:  # a required node takes the others with it
        sim.run_until(lambda: not launch.alive, timeout=LAST_WORDS)
    if end == "idle":
        names = ", ".join(launch.nodes)
        print(f"{names} wait for ever: nothing else runs here", file=sys.stderr)
    if plan.nodes and not launch.alive:
        show(f"{CLOSING}done\n" if launch.handles else f"{NO_PROCESSES}\n{CLOSING}")
    return exit_code_of(launch)


def _wait(sim: Simulation, launch: Launch, arguments: argparse.Namespace, *, alone: bool) -> End:
    """Wait until the launch is over. One without nodes has set its parameters, and stays for others."""
    with keys_of_this_terminal(launch.nodes.values()) as hand_over:

        def is_over() -> bool:
            hand_over()
            return launch.exit_code is not None

        if alone:
            return run_for_a_person(sim, is_over, seconds=arguments.seconds, fast=arguments.fast)
        return _host(sim, launch, is_over)


def _host(sim: Simulation, launch: Launch, is_over: Callable[[], bool]) -> End:
    if not launch.plan.nodes:
        show(
            "no nodes: the parameters are set, and stay while this terminal runs; "
            "start nodes in another one\n"
        )
    own = {node.resolved_name for node in launch.plan.nodes} | {"/roslaunch"}
    sim.graph.screen = OnlyFrom(own.__contains__, StreamScreen())
    ended = host(sim, lambda: is_over() and bool(launch.plan.nodes))
    return "interrupted" if ended else "over"


def _add_options(parser: argparse.ArgumentParser) -> None:
    add_run_options(parser)
    parser.add_argument(
        "--screen", action="store_true", help="show what all nodes print, whatever output= says"
    )
    listings.add_list_options(parser)


def _read_text(*, quiet: bool) -> str:
    """The launch file that stands on standard input."""
    if not quiet:
        show("Passed '-' as file argument, attempting to read roslaunch XML from stdin.\n")
    data = sys.stdin.buffer.read(MAX_LAUNCH_BYTES + 1)
    if not quiet:
        show(f"... {len(data)} bytes read successfully.\n\n")
    text = data.decode("utf-8", "replace")
    if "<" not in text:
        raise SimkitError("standard input holds no launch file: it begins with <launch>")
    return text


def _from_anywhere(words: list[str]) -> list[str]:
    """The same words for a simulation that runs in another folder."""
    path = Path(words[0])
    is_path = "<" not in words[0] and path.is_file()
    return [str(path.absolute()), *words[1:]] if is_path else words
