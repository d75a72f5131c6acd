"""Faults of launch files: while they travel from the place where they are found, and what is raised in the end.

roslaunch's handlers of tags catch some kinds of faults, put words of their own around them, and let others
pass. To end with its exact words, ours do the same: a `LaunchRefused` has the words so far, its kind, and, from where it
began, what a teacher says about it. A `LaunchError` has what roslaunch says in the end, and the lesson with its place.
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import TYPE_CHECKING

from simkit.diagnostics import Diagnostic, Layout, Related, Severity, as_text
from simkit.errors import SimkitError
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


class LaunchError(SimkitError, ValueError):
    """A launch file that roslaunch refuses.

    Its text has both layers: the words of roslaunch, then the place, the fault and the remedy.

    Args:
        said: What roslaunch prints; empty where roslaunch has no such rule.
        diagnostic: The fault with its place; the files that include this one are its related places.
    """

    def __init__(self, said: str, diagnostic: Diagnostic) -> None:
        self.said = said
        self.diagnostic = diagnostic
        super().__init__(str(self))

    @property
    def file(self) -> str:
        """File that the fault is in, as it is shown to people."""
        return self.diagnostic.file

    @property
    def line(self) -> int:
        """Line, from 1."""
        return self.diagnostic.span.line

    @property
    def column(self) -> int:
        """Column, from 1."""
        return self.diagnostic.span.column

    @property
    def chain(self) -> tuple[str, ...]:
        """The places that include this file, the nearest first: `hello_ros/launch/all.launch:3:4`."""
        return tuple(
            f"{place.file}:{place.span.line}:{place.span.column}"
            for place in self.diagnostic.related
        )

    @property
    def remedy(self) -> str:
        """What would be right."""
        return self.diagnostic.remedy

    @property
    def hint(self) -> str:
        """The remedy, for a check of an exercise."""
        return self.remedy

    def explained(self, layout: Layout | None = None) -> str:
        """The second layer: the place, the line underlined, the fault, the remedy."""
        one = self.diagnostic
        if not one.source and not one.related:  # about no place in a file
            return f"{one.file}: {one.severity.value} [{one.rule}] {one.what}\n{one.remedy}"
        return as_text([one], layout=layout).rstrip("\n")

    def __str__(self) -> str:
        """Both layers."""
        return self.text()

    def text(self, layout: Layout | None = None) -> str:
        """Both layers, laid out for a stream."""
        explained = self.explained(layout)
        return f"{self.said}\n{explained}" if self.said else explained


def diagnostic_of(
    lesson: Lesson, place: LaunchPlace, severity: Severity = Severity.ERROR
) -> Diagnostic:
    """A lesson as a diagnostic.

    Args:
        lesson: What a teacher says.
        place: Where in a launch file.
        severity: How bad it is.
    """
    document = place.launch_file.document
    return Diagnostic(
        rule=lesson.rule,
        severity=severity,
        file=document.file,
        span=place.span,
        source=document.line(place.span.line),
        what=lesson.what,
        remedy=lesson.remedy,
        related=tuple(_related(outer, "included here") for outer in place.launch_file.chain()),
    )


def error_of(refused: LaunchRefused, shown: str) -> LaunchError:
    """The error for a fault that nobody has caught.

    Args:
        refused: The fault.
        shown: The launch file, for a fault without a place.
    """
    lesson, place = refused.lesson, refused.place
    if refused.elsewhere is not None:
        return LaunchError(refused.said, _in_other_file(lesson, refused.elsewhere, place))
    if place is not None:
        return LaunchError(refused.said, diagnostic_of(lesson, place))
    without_place = Diagnostic(
        rule=lesson.rule,
        severity=Severity.ERROR,
        file=shown,
        span=Span(1, 1),
        source="",
        what=lesson.what,
        remedy=lesson.remedy,
    )
    return LaunchError(refused.said, without_place)


def _in_other_file(lesson: Lesson, elsewhere: Elsewhere, place: LaunchPlace | None) -> Diagnostic:
    related: list[Related] = []
    if place is not None:
        related = [_related(place, "loaded here")]
        related += [_related(outer, "included here") for outer in place.launch_file.chain()]
    return Diagnostic(
        rule=lesson.rule,
        severity=Severity.ERROR,
        file=elsewhere.file,
        span=elsewhere.span,
        source=elsewhere.source,
        what=lesson.what,
        remedy=lesson.remedy,
        related=tuple(related),
    )


def _related(place: LaunchPlace, text: str) -> Related:
    document = place.launch_file.document
    return Related(
        file=document.file, span=place.span, text=text, source=document.line(place.span.line)
    )
