"""What a command line of ROS says when it cannot do what it was asked."""

from __future__ import annotations

from collections.abc import Iterable

from simkit.errors import SimkitError, near_names

FAILURE = 1
"""Exit code of a command that could not do what it was asked."""
USAGE_ERROR = 2
"""Exit code for a command line that cannot be understood."""
INTERRUPTED = 130
"""Exit code after Ctrl-C, where that is not how a command usually ends."""


class ToolError(SimkitError):
    """A command failed.

    Args:
        text: What the original prints on its error output, and perhaps a hint.
        exit_code: What the original ends with.
    """

    def __init__(self, text: str, *, exit_code: int = FAILURE) -> None:
        super().__init__(text)
        self.exit_code = exit_code


class UsageError(ToolError):
    """The words of a command line fit no command; the text says what does."""

    def __init__(self, text: str, *, exit_code: int = USAGE_ERROR) -> None:
        super().__init__(text, exit_code=exit_code)


class HelpShown(ToolError):
    """The words asked for help; the text is the help, and nothing went wrong."""

    def __init__(self, text: str) -> None:
        super().__init__(text, exit_code=0)


def near_hint(name: str, known: Iterable[str]) -> str:
    """A line with the name that may have been meant; empty if none is near."""
    near = near_names(name, known, limit=1)
    return f"\nhint: did you mean {near[0]}?" if near else ""
