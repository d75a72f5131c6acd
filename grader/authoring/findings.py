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

    def __str__(self) -> str:
        """The finding as one line."""
        return f"{self.file}: {self.what}; {self.remedy}"
