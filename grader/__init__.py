"""grader: checks what a student hands in, in the notebook and for a class, by the same code."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from grader.notebook import check

__all__ = ["check"]


def __getattr__(name: str) -> Any:
    # Loaded when first used: a check file that imports `grader.checks` needs nothing of it.
    if name == "check":
        from grader.notebook import check

        return check
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
