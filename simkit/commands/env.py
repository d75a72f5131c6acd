"""`simkit env` and `simkit shell`: the words of ROS on the PATH of a terminal, so that the book's lines run as printed."""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys

from simkit.commands import shells
from simkit.commands.command import Answer, parsed
from simkit.commands.errors import ToolError


def add_env_arguments(parser: argparse.ArgumentParser) -> None:
    """Which shell, and whether to begin or to end."""
    parser.epilog = (
        'bash, zsh and sh: eval "$(simkit env)"; fish: simkit env | source; PowerShell: simkit env | Out-String | '
        "Invoke-Expression. From then on rosrun, roslaunch, rostopic, check_urdf and all the others are typed as the "
        "book prints them, in this terminal, and Tab completes packages, topics and types."
    )
    _add_common(parser)
    parser.add_argument("--undo", action="store_true", help="take the words from the PATH again")


def add_shell_arguments(parser: argparse.ArgumentParser) -> None:
    """Which shell."""
    parser.epilog = "exit, or Ctrl-D, leads back to the shell in which it was typed."
    _add_common(parser)


def _add_common(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--shell", choices=shells.SHELLS, help="the shell that is to understand it (this one)"
    )
    parser.add_argument(
        "--force", action="store_true", help="also where a real ROS is on the PATH, and hide it"
    )


def _env(arguments: argparse.Namespace) -> Answer:
    shell = arguments.shell or shells.shell_of_parent()
    if arguments.undo:
        yield shells.end_text(shell)
        return 0
    _refuse_to_hide_ros(arguments.force, "env")
    yield shells.begin_text(shell)
    return 0


def _shell(arguments: argparse.Namespace) -> Answer:
    shell = arguments.shell or shells.shell_of_parent()
    _refuse_to_hide_ros(arguments.force, "shell")
    program = shutil.which(shell)
    if program is None:
        raise ToolError(f"{shell} is not on the PATH; --shell names another one")
    yield "The words of ROS are known here: roscore, rosrun, roslaunch, ... `exit` leads back.\n"
    words, more = shells.interactive(shell, program)
    sys.stdout.flush()
    return subprocess.call(words, env={**os.environ, **more})


def _refuse_to_hide_ros(force: bool, command: str) -> None:
    found = shells.program_elsewhere("roscore")
    if found and not force:
        raise ToolError(
            f"a real ROS is on the PATH ({found}), and its commands would be hidden; simkit {command} --force does so"
            " in this terminal"
        )


run = parsed("env", add_env_arguments, _env)
run_shell = parsed("shell", add_shell_arguments, _shell)
