"""The lines of a notebook: the commands of `simkit.commands.table`, on the newest open simulation.

IPython comes to know them by `register`; what goes wrong in one is one line.
"""

from __future__ import annotations

import re
import shlex
import sys
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from IPython.display import display

from simkit.commands.command import Bounds, Call, ErrorText, texts
from simkit.commands.errors import HelpShown, UsageError
from simkit.commands.table import COMMANDS, Entry, TerminalPlace
from simkit.errors import SimkitError
from simkit.launch import LaunchError
from simkit.launch.process import NodeHandle
from simkit.packages import PackagePath
from simkit.simulation import Simulation, newest_simulation

BOUNDS = Bounds(seconds=5.0, messages=10)
"""When `rostopic echo` and its kin end in a notebook."""
_CTRL_C = ". Press ctrl-C to terminate"
_DOC = """{summary}.

The words are those of the terminal, on the newest open simulation of this notebook. What would go on until Ctrl-C
ends after a few messages or seconds. A node that is started goes on, and what it says in its first half second stands below; one
that only prints what it sees, such as tf_echo, goes on if a & is the last word.
"""
_ROSPACK_FIND = re.compile(r"`\s*rospack\s+find\s+(\w+)\s*`|\$\(\s*rospack\s+find\s+(\w+)\s*\)")
"What the book's command lines ask their shell for; the two ways to write it."
_of_lines: list[Simulation] = []
"""The one that a line made: a notebook that has only lines has nobody else to hold it."""

Line = Callable[[list[str]], None]
"""Does what the words of a line ask for."""


def current_simulation() -> Simulation:
    """The newest open simulation of this process; a new one if there is none."""
    newest = newest_simulation()
    if newest is not None:
        return newest
    made = Simulation()
    _of_lines[:] = [made]
    return made


def do_line(entry: Entry, words: list[str]) -> None:
    """Do a command, and print what it says.

    Args:
        entry: The command.
        words: The words behind its name.

    Raises:
        SimkitError: It cannot be done.
    """
    started: list[NodeHandle] = []
    sim = None if entry.place is TerminalPlace.HERE else current_simulation()
    before = set(sim.nodes()) if sim is not None else set()
    call = Call(simulation=sim, words=words, bounds=BOUNDS, show_window=started.append)
    try:
        for text in texts(call, entry.load()(call)):
            # One stream: a notebook would show the other one apart, and in red, a mere note too.
            sys.stdout.write(
                str(text) if isinstance(text, ErrorText) else text.replace(_CTRL_C, "")
            )
    except HelpShown as text:
        print(text)
    except UsageError as error:
        raise SimkitError(str(error).removeprefix(f"simkit {entry.name}: ")) from None
    for node in started:
        window = call.sim.window_of(node)
        if window is not None:
            display(window)  # type: ignore[no-untyped-call]
    if entry.place is TerminalPlace.SHARED:
        for name in sorted(set(call.sim.nodes()) - before):
            print(f"{name} goes on; %rosnode kill {name} ends it")
            call.sim.run(BOUNDS.start)


def _described(entry: Entry) -> Line:
    line = partial(do_line, entry)
    line.__doc__ = _DOC.format(summary=f"{entry.summary[:1].upper()}{entry.summary[1:]}")
    return line


LINES: Mapping[str, Line] = {
    name: _described(entry) for name, entry in COMMANDS.items() if not entry.not_in_notebook
}
"""The lines by name."""


class LineError(SimkitError):
    """A line of a notebook could not do what it was asked; IPython shows the text alone."""

    def _render_traceback_(self) -> list[str]:
        # IPython asks an exception how it wants to be shown.
        return [str(self)]


def register(ipython: Any) -> None:
    """Make `%rosrun` and its kin known to an IPython shell.

    Args:
        ipython: The `InteractiveShell`.
    """
    from IPython.core.magic import no_var_expand

    for name, line in LINES.items():
        # IPython would take {linear: {x: 1.0}} for a place to put a variable in.
        magic = no_var_expand(_magic(name, line))
        ipython.register_magic_function(magic, "line", name)


def _magic(name: str, line: Line) -> Callable[[str], None]:
    def magic(text: str) -> None:
        try:
            line(_words(text))
        except LaunchError as error:  # the words of roslaunch have several lines
            raise LineError(str(error)) from None
        except (SimkitError, OSError) as error:
            raise LineError(f"%{name}: {_in_one_line(str(error))}") from None

    magic.__doc__ = line.__doc__
    magic.__name__ = name
    return magic


def _words(text: str) -> list[str]:
    text = _ROSPACK_FIND.sub(_folder, text)
    try:
        return shlex.split(text)
    except ValueError as error:
        raise SimkitError(f"{text}: {error}; quotation marks come in pairs") from error


def _folder(asked: re.Match[str]) -> str:
    return shlex.quote(str(PackagePath().find(asked[1] or asked[2]).folder))


def _in_one_line(text: str) -> str:
    return " ".join(text.split())
