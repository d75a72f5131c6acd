"""What other terminals may ask of a live simulation: rosrun, and the tools of ROS."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from simkit.live.jobs import Command, DoneJob, Job, NodeJob
from simkit.simulation import Simulation
from simkit.tools import ToolError, UsageError, run_tool

_STREAMING = ("pub", "echo", "hz")
"""Commands of rostopic that go on until Ctrl-C: each is a node of its own."""


def live_commands() -> Mapping[str, Command]:
    """Commands by name."""
    return {
        "rosrun": _rosrun,
        "rostopic": _rostopic,
        **{tool: _tool(tool) for tool in ("rosnode", "rosparam", "rosservice")},
    }


def _rosrun(sim: Simulation, argv: Sequence[str]) -> Job:
    if len(argv) < 2:
        raise UsageError("Usage: rosrun PACKAGE EXECUTABLE [ARGUMENTS]")
    return NodeJob(sim, sim.rosrun(*argv))


def _rostopic(sim: Simulation, argv: Sequence[str]) -> Job:
    if argv and argv[0] in _STREAMING:
        return NodeJob(sim, sim.rosrun("rostopic", "rostopic", *argv))
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
