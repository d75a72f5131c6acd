"""From a fault to what people read: a diagnostic with its place, and the includes that lead there."""

from __future__ import annotations

from simkit.diagnostics import Diagnostic, Related, Severity
from simkit.launch.errors import LaunchError
from simkit.launch.refusal import Elsewhere, Lesson, Place, Refused
from simkit.xml import Span


def diagnostic_of(lesson: Lesson, place: Place, severity: Severity = Severity.ERROR) -> Diagnostic:
    """A lesson as a diagnostic.

    Args:
        lesson: What a teacher says.
        place: Where in a launch file.
        severity: How bad it is.
    """
    document = place.sheet.document
    return Diagnostic(
        rule=lesson.rule,
        severity=severity,
        file=document.file,
        span=place.span,
        source=document.line(place.span.line),
        what=lesson.what,
        remedy=lesson.remedy,
        related=tuple(_related(outer, "included here") for outer in place.sheet.chain()),
    )


def error_of(refused: Refused, shown: str) -> LaunchError:
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


def _in_other_file(lesson: Lesson, elsewhere: Elsewhere, place: Place | None) -> Diagnostic:
    related: list[Related] = []
    if place is not None:
        related = [_related(place, "loaded here")]
        related += [_related(outer, "included here") for outer in place.sheet.chain()]
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


def _related(place: Place, text: str) -> Related:
    document = place.sheet.document
    return Related(
        file=document.file, span=place.span, text=text, source=document.line(place.span.line)
    )
