"""Rules: kinds of mistakes, each with a stable id and an explanation."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from simkit.diagnostics.diagnostic import Diagnostic, Severity
from simkit.record import Record


class Rule(Record):
    """One rule: looks at something and finds one kind of mistake in it.

    Its explanation is the docstring of the function that looks.
    """

    id: str
    """Stable id, e.g. `URDF-W07`."""
    title: str
    """The mistake in a few words, e.g. `degrees where radians are meant`."""
    severity: Severity
    """The worst that it can report."""
    look: Callable[[Any], Iterable[Diagnostic]]
    """Yields what it finds."""

    @property
    def explanation(self) -> str:
        """What the mistake is, how it comes about, what to do: for `--explain`."""
        import inspect  # takes 10 ms to load, and most calls explain nothing

        return inspect.cleandoc(self.look.__doc__ or "")


class MetRule(Record):
    """A rule that nothing looks for: the mistake is met when a file is used, e.g. launched."""

    id: str
    """Stable id, e.g. `LCH-E06`."""
    title: str
    """The mistake in a few words."""
    severity: Severity
    """The worst that it is reported as."""
    text: str
    """The explanation, as it is indented in the source."""

    @property
    def explanation(self) -> str:
        """What the mistake is, how it comes about, what to do: for `--explain`."""
        import inspect

        return inspect.cleandoc(self.text)
