"""The tools of a ROS terminal that act on a graph: rostopic, rosnode, rosservice, rosparam.

Each has a module with one function per command, which gives what the original prints. `run_tool`
reads a whole command line, for a terminal and for the lines of a notebook.
"""

from __future__ import annotations

import importlib
from collections.abc import Mapping, Sequence

from simkit.errors import SimkitError, UnknownNameError
from simkit.tools.command_line import Call, Command, HelpShown, dispatch
from simkit.tools.errors import ToolError, UsageError
from simkit.tools.world import Bounds, World, Write, to_stdout

__all__ = [
    "TOOLS",
    "Bounds",
    "HelpShown",
    "ToolError",
    "UsageError",
    "World",
    "run_tool",
]

TOOLS: Mapping[str, str] = {
    "rosnode": "simkit.tools.rosnode",
    "rosparam": "simkit.tools.rosparam",
    "rosservice": "simkit.tools.rosservice",
    "rostopic": "simkit.tools.rostopic_command",
}
"""Module of each tool; its table `COMMANDS` has the commands by name."""


def run_tool(
    world: World,
    tool: str,
    argv: Sequence[str],
    *,
    write: Write = to_stdout,
    bounds: Bounds | None = None,
) -> None:
    """Do what a command line asks for: `run_tool(sim, "rostopic", ["echo", "/tf", "-n", "1"])`.

    Args:
        world: The simulation it acts on.
        tool: Name of the tool.
        argv: The words after it.
        write: Takes what it prints, line breaks included.
        bounds: When a command ends that would go on until Ctrl-C.

    Raises:
        UnknownNameError: There is no such tool.
        ToolError: It cannot do it; the text is what the original prints, `exit_code` its code.
    """
    if tool not in TOOLS:
        raise UnknownNameError("tool", tool, TOOLS)
    try:
        command, words = dispatch(tool, _commands(tool), argv)
        command(Call(world=world, words=words, write=write, bounds=bounds or Bounds()))
    except HelpShown as help_text:
        write(f"{help_text}\n")
    except ToolError:
        raise
    except SimkitError as error:
        raise ToolError(f"ERROR: {error}") from error


def _commands(tool: str) -> Mapping[str, Command]:
    commands: Mapping[str, Command] = importlib.import_module(TOOLS[tool]).COMMANDS
    return commands
