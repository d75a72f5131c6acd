"""rosout: what nodes log, with node, level and virtual time."""

from __future__ import annotations

import enum
from dataclasses import dataclass

from simkit.msgs import Time


class LogLevel(enum.IntEnum):
    """Levels of rosgraph_msgs/Log."""

    DEBUG = 1
    INFO = 2
    WARN = 4
    ERROR = 8
    FATAL = 16


@dataclass(frozen=True, slots=True, kw_only=True)
class LogRecord:
    """One line of rosout."""

    time: Time
    """Virtual time at which it was logged."""
    node: str
    """Resolved name of the node."""
    level: LogLevel
    """Severity."""
    text: str
    """The message."""

    def __str__(self) -> str:
        return f"[{self.level.name}] [{self.time.to_sec():.6f}] {self.node}: {self.text}"
