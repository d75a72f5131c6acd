"""Tells IPython of the lines, and turns what goes wrong in one into one line."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from typing import Any

from simkit.errors import SimkitError
from simkit.launch import LaunchError
from simkit.notebook.lines import LINES, Line
from simkit.packages import PackagePath

_ROSPACK_FIND = re.compile(r"`\s*rospack\s+find\s+(\w+)\s*`|\$\(\s*rospack\s+find\s+(\w+)\s*\)")
"What the book's command lines ask their shell for; the two ways to write it."


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
