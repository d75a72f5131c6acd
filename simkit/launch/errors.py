"""What a launch file that cannot be used raises: what roslaunch says, and what a teacher would say, with its place."""

from __future__ import annotations

from simkit.diagnostics import Diagnostic, Layout, Related, Severity, as_text
from simkit.errors import SimkitError
from simkit.launch.refusal import Elsewhere, LaunchPlace, LaunchRefused, Lesson
from simkit.xml import Span


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
