"""What a launch file that cannot be used raises: what roslaunch says, and what a teacher would say."""

from __future__ import annotations

from simkit.diagnostics import Diagnostic, Layout, as_text
from simkit.errors import SimkitError


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
