"""One find of a rule: what is wrong, where, what follows from it, and what would be right."""

from __future__ import annotations

import enum
from collections.abc import Iterable
from dataclasses import dataclass

from simkit.xml import Span


class Severity(enum.Enum):
    """How bad it is."""

    ERROR = "error"
    """ROS or Gazebo refuses the file, or loses what the author meant."""
    WARNING = "warning"
    """It loads, and does something else than the author most likely meant."""
    NOTE = "note"
    """Worth knowing; often meant so."""


@dataclass(frozen=True, kw_only=True)
class Related:
    """A second place that belongs to a find."""

    file: str
    """File that it stands in."""
    span: Span
    """Where in it."""
    text: str
    """What is there, e.g. `the link is defined here`."""
    source: str = ""
    """The line of the file; empty if it need not be shown."""


@dataclass(frozen=True, kw_only=True)
class Diagnostic:
    """One find."""

    rule: str
    """Stable id of the rule, e.g. `URDF-E05`."""
    severity: Severity
    """How bad it is."""
    file: str
    """File that it is in."""
    span: Span
    """Where in it."""
    source: str
    """The line of the file that the span lies in."""
    path: str = ""
    """Which element, e.g. `robot/joint[hip]/limit`; empty if none."""
    what: str
    """What is wrong, with the actual names and numbers; no full stop."""
    here: str = ""
    """What simkit does with it; a sentence."""
    gazebo: str = ""
    """What ROS and Gazebo do with it; a sentence."""
    remedy: str
    """What would be right, with computed values where there are some; a sentence."""
    related: tuple[Related, ...] = ()
    """Other places that belong to it."""


_RANK = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.NOTE: 2}


def in_order(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """Each find once, by file and place; of one place the worst first."""
    unique = dict.fromkeys(diagnostics)
    return tuple(
        sorted(
            unique, key=lambda one: (one.file, one.span, _RANK[one.severity], one.rule, one.what)
        )
    )
