"""What a command line of ROS says when it cannot do what it was asked."""

from __future__ import annotations

from collections.abc import Iterable

from simkit.errors import SimkitError, near_names


class ToolError(SimkitError):
    """A command failed.

    Args:
        text: What the original prints on its error output, and perhaps a hint.
        exit_code: What the original ends with.
    """

    def __init__(self, text: str, *, exit_code: int = 1) -> None:
        super().__init__(text)
        self.exit_code = exit_code


class UsageError(ToolError):
    """The words of a command line fit no command; the text says what does."""

    def __init__(self, text: str, *, exit_code: int = 2) -> None:
        super().__init__(text, exit_code=exit_code)


def near_hint(name: str, known: Iterable[str]) -> str:
    """A line with the name that may have been meant; empty if none is near."""
    near = near_names(name, known, limit=1)
    return f"\nhint: did you mean {near[0]}?" if near else ""
