"""A file that stands beside a URDF: a launch file that loads it, or a YAML file with its controllers."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import Any

from simkit.xml import Document, parse_xml


class CompanionKind(enum.Enum):
    """What a companion is."""

    LAUNCH = "launch"
    YAML = "yaml"


@dataclass(frozen=True, kw_only=True)
class Companion:
    """One file beside the URDF."""

    kind: CompanionKind
    """What it is."""
    file: str
    """Name to show for it."""
    text: str
    """What is in it."""

    def document(self) -> Document:
        """It as XML, for a launch file."""
        return parse_xml(self.text, file=self.file)

    def values(self) -> Any:
        """What a YAML file holds; None if it cannot be read."""
        import yaml  # takes 20 ms to load, and most calls have no YAML

        try:
            return yaml.safe_load(self.text)
        except (yaml.YAMLError, ValueError, RecursionError):
            return None

    def line(self, number: int) -> str:
        """A line of it, from 1; empty beyond its end."""
        lines = self.text.splitlines()
        return lines[number - 1] if 0 < number <= len(lines) else ""
