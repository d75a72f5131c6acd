"""rosout: what nodes log, with node, level and virtual time; and the screen on which a person reads it."""

from __future__ import annotations

import enum
import sys
from dataclasses import dataclass
from typing import Protocol, TextIO

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


class Screen(Protocol):
    """Takes what nodes log and print, at once."""

    def record(self, record: LogRecord) -> None:
        """A line of rosout."""

    def output(self, node: str, text: str) -> None:
        """What a script printed."""


class StreamScreen:
    """Prints to a text stream in the form of a ROS terminal.

    Args:
        stream: Where to print; standard output of the moment if None (in a notebook: under the running cell).
        level: Quieter lines of rosout are left out.
    """

    def __init__(self, stream: TextIO | None = None, level: LogLevel = LogLevel.INFO) -> None:
        self._stream = stream
        self._level = level

    def record(self, record: LogRecord) -> None:
        """Print `[INFO] [time]: text`, as rospy does, with the node's name."""
        if record.level >= self._level:
            seconds = record.time.to_sec()
            self._write(f"[{record.level.name}] [{seconds:.6f}] {record.node}: {record.text}\n")

    def output(self, node: str, text: str) -> None:  # noqa: ARG002 - the form of Screen
        """Print what a script printed, unchanged."""
        self._write(text)

    def _write(self, text: str) -> None:
        stream = self._stream or sys.stdout
        stream.write(text)
        stream.flush()
