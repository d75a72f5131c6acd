"""Which values a parameter can have: those that ROS can send to its server.

Source: XML-RPC as rosmaster speaks it: whole numbers of 32 bits, no empty value, keys that are texts.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

_INT_LIMIT = 2**31


@dataclass(frozen=True, slots=True, kw_only=True)
class Unsendable:
    """Why a value cannot be sent."""

    cause: str
    """What ROS says."""
    what: str
    """The same for people."""


def why_unsendable(value: Any) -> Unsendable | None:
    """Why a value cannot be that of a parameter; None if it can.

    Args:
        value: Any value of YAML; it must not stand in itself.
    """
    parts = [value]
    while parts:
        part = parts.pop()
        if isinstance(part, dict):
            parts += [*part.keys(), *part.values()]
        elif isinstance(part, list):
            parts += part
        elif found := _of_one(part):
            return found
    return None


def _of_one(part: Any) -> Unsendable | None:
    if part is None:
        cause = "cannot marshal None unless allow_none is enabled"
        return Unsendable(cause=cause, what="a parameter cannot be empty (null)")
    if isinstance(part, int) and not -_INT_LIMIT <= part < _INT_LIMIT:
        return Unsendable(cause="int exceeds XML-RPC limits", what=f"{part} is too large")
    if isinstance(part, bool | int | float | str | bytes):
        return None
    kind = type(part)
    return Unsendable(
        cause=f"cannot marshal {kind} objects", what=f"{part} is a {kind.__name__} in YAML"
    )
