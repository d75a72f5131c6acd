"""A fault while it travels from the place where it is found to the one who asked.

roslaunch's handlers of tags catch some kinds of faults, put words of their own around them, and let others
pass. To end with its exact words, ours do the same: a `LaunchRefused` has the words so far, its kind, and, from where it
began, what a teacher says about it.
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import TYPE_CHECKING

from simkit.xml import Span

if TYPE_CHECKING:
    from simkit.launch.launch_file import LaunchFile


class Kind(enum.Enum):
    """How roslaunch's handlers tell faults apart."""

    SYNTAX = enum.auto()
    """Attributes or tags that make no sense."""
    LOAD = enum.auto()
    """Something that cannot be loaded; it passes the handlers that put their words around SYNTAX."""
    ARGUMENT = enum.auto()
    """`$(arg x)` without a value."""
    SUBSTITUTION = enum.auto()
    """Another `$(...)` that makes no sense."""
    VALUE = enum.auto()
    """A value of the wrong type."""
    KEY = enum.auto()
    """A required attribute that is not there."""
    NOT_FOUND = enum.auto()
    """A package that is not there."""
    OTHER = enum.auto()
    """What roslaunch does not foresee: it prints the name of Python's error, and a traceback."""
    OURS = enum.auto()
    """A rule of this kit that roslaunch does not have: no handler puts words around it."""


_PREFIXES = {
    Kind.VALUE: "Value error: ",
    Kind.KEY: "KeyError: ",
    Kind.NOT_FOUND: "Resource not found: ",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Lesson:
    """What a teacher says about a fault."""

    rule: str
    """Id of the rule, e.g. `LCH-E04`."""
    what: str
    """What is wrong; no full stop."""
    remedy: str
    """What would be right; a sentence."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LaunchPlace:
    """A piece of a launch file."""

    launch_file: LaunchFile
    """The file."""
    span: Span
    """Where in it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Elsewhere:
    """A piece of another file than a launch file, e.g. of one with YAML."""

    file: str
    """The file, as it is shown to people."""
    span: Span
    """Where in it."""
    source: str
    """The line."""


class LaunchRefused(Exception):
    """A fault of a launch file.

    Args:
        kind: How handlers treat it.
        text: roslaunch's words for it.
        lesson: What a teacher says.
        place: Where it is; whoever knows adds it later.
        name: For kind OTHER: the name of Python's error, e.g. `ZeroDivisionError`.
        mark: Line and column, from 1, in a text within the file, if the fault is about one.
    """

    def __init__(
        self,
        kind: Kind,
        text: str,
        lesson: Lesson,
        *,
        place: LaunchPlace | None = None,
        name: str = "",
        mark: tuple[int, int] | None = None,
    ) -> None:
        super().__init__(text)
        self.kind = kind
        self.text = text
        self.lesson = lesson
        self.place = place
        self.name = name
        self.mark = mark
        self.elsewhere: Elsewhere | None = None

    def worded(self, kind: Kind, text: str) -> LaunchRefused:
        """The same fault in a handler's words."""
        new = LaunchRefused(kind, text, self.lesson, place=self.place, mark=self.mark)
        new.elsewhere = self.elsewhere
        return new

    def at(self, place: LaunchPlace) -> LaunchRefused:
        """The same fault, with its place if it has none yet."""
        if self.place is None:
            self.place = place
        return self

    @property
    def said(self) -> str:
        """What roslaunch prints in the end; empty for a rule that it does not have."""
        if self.kind is Kind.OURS:
            return ""
        if self.kind is Kind.OTHER:
            return f"{self.name}: {self.text}"
        return _PREFIXES.get(self.kind, "RLException: ") + self.text


def ours(rule: str, what: str, remedy: str) -> LaunchRefused:
    """A fault that only this kit refuses."""
    return LaunchRefused(Kind.OURS, what, Lesson(rule=rule, what=what, remedy=remedy))
