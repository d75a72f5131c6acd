"""What other terminals may ask of a live simulation: rosrun, and the tools of ROS."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from simkit.launch import summary_of
from simkit.live.jobs import Command, DoneJob, Job, NodeJob
from simkit.live.launch_job import LaunchJob
from simkit.live.moving import offer_moves
from simkit.live.windows import open_windows
from simkit.simulation import Simulation
from simkit.tools import ToolError, UsageError, run_tool

SCREEN = "--screen"
"""Option of roslaunch: show what all nodes print."""
_STREAMING = ("pub", "echo", "hz")
"""Commands of rostopic that go on until Ctrl-C: each is a node of its own."""


def live_commands() -> Mapping[str, Command]:
    """Commands by name."""
    return {
        "rosrun": _rosrun,
        "roslaunch": _roslaunch,
        "rostopic": _rostopic,
        **{tool: _tool(tool) for tool in ("rosnode", "rosparam", "rosservice")},
    }


def _rosrun(sim: Simulation, argv: Sequence[str]) -> Job:
    if len(argv) < 2:
        raise UsageError("Usage: rosrun PACKAGE EXECUTABLE [ARGUMENTS]")
    begin = len(sim.log)
    node = sim.rosrun(*argv)
    offer_moves([node])
    open_windows(sim, [node])
    return NodeJob(sim, node, begin=begin)


def _roslaunch(sim: Simulation, argv: Sequence[str]) -> Job:
    words = [word for word in argv if word != SCREEN]
    if not words:
        raise UsageError("Usage: roslaunch PACKAGE FILE [NAME:=VALUE]")
    plan = sim.launch_plan(*words)
    begin = len(sim.log)
    launch = sim.roslaunch(plan, all_on_screen=SCREEN in argv)
    offer_moves(launch.nodes.values())
    open_windows(sim, launch.nodes.values())
    before = f"joined the simulation of another terminal\n\n{summary_of(plan)}\n"
    return LaunchJob(sim, launch, before, begin=begin)


def _rostopic(sim: Simulation, argv: Sequence[str]) -> Job:
    if argv and argv[0] in _STREAMING:
        begin = len(sim.log)
        return NodeJob(sim, sim.rosrun("rostopic", "rostopic", *argv), begin=begin)
    return _tool("rostopic")(sim, argv)


def _tool(name: str) -> Command:
    def begin(sim: Simulation, argv: Sequence[str]) -> Job:
        printed: list[str] = []
        try:
            run_tool(sim, name, argv, write=printed.append)
        except ToolError as error:
            return DoneJob("".join([*printed, f"{error}\n"]), error.exit_code)
        return DoneJob("".join(printed))

    return begin
