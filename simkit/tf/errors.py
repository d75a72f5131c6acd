"""What a TF lookup can say instead of an answer: the exceptions of tf2."""

from __future__ import annotations

from dataclasses import dataclass

from simkit.errors import SimkitError


@dataclass(frozen=True, slots=True, kw_only=True)
class DataGap:
    """The frame whose data does not cover the time that was asked for."""

    frame: str
    "Frame (child) whose transform to its parent was needed."
    requested: int
    "Time that was asked for [ns]."
    oldest: int
    "Oldest stamp that is stored for the frame [ns]."
    newest: int
    "Newest stamp that is stored for the frame [ns]."

    @property
    def missing(self) -> int:
        """How far the request lies outside the data [ns]: after it if positive, else before."""
        if self.requested > self.newest:
            return self.requested - self.newest
        return min(self.requested - self.oldest, 0)


class TransformException(SimkitError):
    """Root of what a lookup may raise; `str()` is tf's own text.

    Attributes:
        hint: One or two sentences that teach: what exists, and what to do. Empty if none is known.
    """

    hint: str = ""


class LookupException(TransformException):
    """A frame name is unknown, or the tree has a loop.

    Args:
        *text: tf's text.
        frame: The unknown name; None for a loop.
    """

    def __init__(self, *text: object, frame: str | None = None) -> None:
        super().__init__(*text)
        self.frame = frame


class ConnectivityException(TransformException):
    """Both frames exist, but in two trees that nothing joins.

    Args:
        *text: tf's text.
        frames: The target and the source.
    """

    def __init__(self, *text: object, frames: tuple[str, str] | None = None) -> None:
        super().__init__(*text)
        self.frames = frames


class ExtrapolationException(TransformException):
    """The time asked for lies outside the stored data.

    Args:
        *text: tf's text.
        gap: The frame that lacks data, and the numbers; None if it holds no data at all.
    """

    def __init__(self, *text: object, gap: DataGap | None = None) -> None:
        super().__init__(*text)
        self.gap = gap


class InvalidArgumentException(TransformException):
    """A frame name is empty or starts with a slash.

    Args:
        *text: tf's text.
        frame: The name.
    """

    def __init__(self, *text: object, frame: str | None = None) -> None:
        super().__init__(*text)
        self.frame = frame


class TimeoutException(TransformException):
    """A transform did not become available in time."""
