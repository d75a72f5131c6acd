"""The table of diagnostics: one row for each kind of fault, whether it is found in a file or met while one is used.

A row is a `Rule`. Where a generator looks for the fault, the row is declared as its decorator:

    @rule("URDF-W09", "an axis that is missing (and so x), zero, or not of length 1", Severity.ERROR)
    def axis(sheet: Sheet) -> Iterator[Find]:
        \"\"\"What `--explain` says.\"\"\"

The generator yields a `Find` for each place: what is wrong there, with its names and numbers. What is the same for all of them
stands in the row.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from inspect import cleandoc
from typing import Any, NamedTuple, Protocol, TypeAlias

from simkit.diagnostics.diagnostic import Diagnostic, Related, Severity
from simkit.xml import Attribute, Element, Span

GROUPS = ("URDF", "GZ", "CTL", "LCH", "LAS", "SDF")
"""What ids begin with: robots, their simulation, their controllers, launch files, lasers, worlds."""
RETIRED: frozenset[str] = frozenset(
    {"CTL-04", "CTL-05", "URDF-33", "URDF-37", "URDF-38", "URDF-39"}
)
"""Group and number of rules that there are no more: a number is never used again."""


class Part(NamedTuple):
    """A part of an element; the element itself if it has none such."""

    element: Element
    """The element."""
    attribute: str = ""
    """Name of the attribute that is meant; empty: its text."""


At: TypeAlias = Element | Part | Attribute | Span
"""Something in a file: an element stands for its name, an attribute for its value."""
Explorer: TypeAlias = Callable[[Any], Iterable["Find"]]
"""A generator that looks for one kind of fault."""


class FaultyFile(Protocol):
    """A file that faults are found in."""

    @property
    def file(self) -> str:
        """Name to show for it."""

    def line(self, number: int) -> str:
        """A line of it, from 1."""


@dataclass(frozen=True, kw_only=True)
class Loss:
    """What follows from a fault, and how bad that is."""

    here: str
    """What simkit does."""
    gazebo: str
    """What ROS and Gazebo do."""
    severity: Severity
    """An error if ROS refuses the file, or loses more than a colour."""


@dataclass(frozen=True)
class Find:
    """A place where a fault is, and the words for it."""

    at: At
    """What is at fault."""
    what: str = field(kw_only=True)
    """What is wrong, with the actual names and numbers; no full stop."""
    remedy: str = field(default="", kw_only=True)
    """What would be right; empty: what the row says."""
    here: str = field(default="", kw_only=True)
    """What simkit does with it; empty: what the row says."""
    gazebo: str = field(default="", kw_only=True)
    """What ROS and Gazebo do with it; empty: what the row says."""
    both: str = field(default="", kw_only=True)
    """What simkit, ROS and Gazebo do with it, if they do the same."""
    loss: Loss | None = field(default=None, kw_only=True)
    """What follows from it, where that depends on the place; it comes before what the row says."""
    severity: Severity | None = field(default=None, kw_only=True)
    """How bad it is; None: as bad as the row says."""
    element: Element | None = field(default=None, kw_only=True)
    """The element that it is about, where `at` is none."""
    related: Iterable[tuple[At, str] | Related] = field(default=(), kw_only=True)
    """Other places that belong to it, with what is there."""
    companion: FaultyFile | None = field(default=None, kw_only=True)
    """The file that it is in; None for the one that is looked at."""

    @property
    def about(self) -> Element | None:
        """The element that it is about; None if there is none."""
        if isinstance(self.at, Part):
            return self.at.element
        return self.at if isinstance(self.at, Element) else self.element


@dataclass(frozen=True)
class Rule:
    """One row: a kind of fault, with a stable id."""

    id: str
    """E.g. `URDF-W07`: group, letter (E, W or I: error, warning, note), number."""
    title: str
    """The fault in a few words, e.g. `degrees where radians are meant`."""
    severity: Severity
    """The worst that it can report."""
    text: str = field(repr=False)
    """The explanation, as it is indented in the source."""
    remedy: str = field(default="", kw_only=True)
    """What would be right, where it is always the same."""
    here: str = field(default="", kw_only=True)
    """What simkit does with it, where it is always the same."""
    gazebo: str = field(default="", kw_only=True)
    """What ROS and Gazebo do with it, where it is always the same."""
    both: str = field(default="", kw_only=True)
    """What simkit, ROS and Gazebo do with it, if they do the same."""
    look: Explorer | None = field(default=None, kw_only=True)
    """Who looks for it; None for a fault that is met while a file is used."""

    @property
    def explanation(self) -> str:
        """What the fault is, how it comes about, what to do, with an example: for `--explain`."""
        return cleandoc(self.text)

    def diagnostic(self, find: Find, source: FaultyFile) -> Diagnostic:
        """A find with the words of the row.

        Args:
            find: The place.
            source: The file that is looked at.
        """
        source = source if find.companion is None else find.companion
        span, element = place_of(find.at), find.about
        return Diagnostic(
            rule=self.id,
            severity=find.severity or (find.loss or self).severity,
            file=source.file,
            span=span,
            source=source.line(span.line),
            path="" if element is None else element.path,
            what=find.what,
            here=find.here or find.both or (find.loss or self).here or self.both,
            gazebo=find.gazebo or find.both or (find.loss or self).gazebo or self.both,
            remedy=find.remedy or self.remedy,
            related=tuple(_related(one, source) for one in find.related),
        )


def rule(
    name: str,
    title: str,
    severity: Severity,
    *,
    remedy: str = "",
    here: str = "",
    gazebo: str = "",
    both: str = "",
) -> Callable[[Explorer], Rule]:
    """Make a row of the generator that looks for its fault: a decorator.

    Args:
        name: Its id.
        title: The fault in a few words.
        severity: The worst that it can report.
        remedy: What would be right, where it is always the same; `here`, `gazebo` and `both` likewise.
        here: What simkit does with it.
        gazebo: What ROS and Gazebo do with it.
        both: What simkit, ROS and Gazebo do, if they do the same.
    """

    def row(look: Explorer) -> Rule:
        text = look.__doc__ or ""
        return Rule(
            name,
            title,
            severity,
            text,
            remedy=remedy,
            here=here,
            gazebo=gazebo,
            both=both,
            look=look,
        )

    return row


def rules_in(module: Any) -> tuple[Rule, ...]:
    """The rows that a module declares."""
    return tuple(one for one in vars(module).values() if isinstance(one, Rule))


def in_table_order(rules: Iterable[Rule]) -> tuple[Rule, ...]:
    """Rows by group, and by number within it."""

    def key(one: Rule) -> tuple[int, str]:
        group, _, number = one.id.partition("-")
        return GROUPS.index(group), number[1:]

    return tuple(sorted(rules, key=key))


def place_of(at: At) -> Span:
    """The place of something: of an element its name, of an attribute its value."""
    if isinstance(at, Part):
        element = at.element
        return element.span_of(at.attribute) if at.attribute else element.text_span or element.span
    if isinstance(at, Span):
        return at
    return at.value_span if isinstance(at, Attribute) else at.span


def related(at: At, text: str, source: FaultyFile) -> Related:
    """A second place that belongs to a find.

    Args:
        at: Where it is.
        text: What is there.
        source: The file that it is in.
    """
    span = place_of(at)
    return Related(file=source.file, span=span, text=text, source=source.line(span.line))


def _related(one: tuple[At, str] | Related, source: FaultyFile) -> Related:
    return one if isinstance(one, Related) else related(*one, source)
