"""What the verification of a workbook has to say."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Finding:
    """One broken law of the workbook."""

    file: str
    """Where to go, relative to the workbook."""
    what: str
    """What is wrong."""
    remedy: str
    """What to do."""
    log: str = ""
    """Errors and warnings of the simulation that it was found in, a line each."""

    def __str__(self) -> str:
        """The finding as one line, and the log indented below it."""
        lines = [f"{self.file}: {self.what}; {self.remedy}", *self.log.splitlines()]
        return "\n    log: ".join(lines)
