"""How a command says that it cannot: one line on standard error, and an exit code."""

from __future__ import annotations

import sys

FAILURE = 1
"""Exit code of a command that could not do what it was asked."""
USAGE_ERROR = 2
"""Exit code for a command line that cannot be understood."""
INTERRUPTED = 130
"""Exit code after Ctrl-C, where that is not how a command usually ends."""


def complain(program: str, text: str, code: int = FAILURE) -> int:
    """Print what went wrong, on one line.

    Args:
        program: Who says it, e.g. `simkit rosmsg`.
        text: What went wrong.
        code: Exit code.

    Returns:
        The exit code.
    """
    print(f"{program}: {' '.join(text.split())}", file=sys.stderr)
    return code
