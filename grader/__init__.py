"""grader: checks what a student hands in, in the notebook and for a class, by the same code."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from grader.last_checks import progress
    from grader.notebook import check

__all__ = ["check", "progress"]

_HOMES = {"check": "notebook", "progress": "last_checks"}


def __getattr__(name: str) -> Any:
    # Loaded when first used: a check file that imports `grader.checks` needs nothing of it.
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"grader.{_HOMES[name]}"), name)
