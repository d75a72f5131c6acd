"""How a law over the tree fails: with every place where it is broken, and what to do about it.

from tests.laws import broken_laws
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import pytest


def broken_laws(found: Iterable[object], remedy: str) -> None:
    """Fail if there is a violation; the message lists all of them, and ends with the remedy.

    Args:
        found: One entry for each violation, as it shall be read; of a mapping, "key: value".
        remedy: What to do: which table, which line, what is allowed.
    """
    __tracebackhide__ = True
    entries = found.items() if isinstance(found, Mapping) else found
    lines = [": ".join(map(str, e)) if isinstance(e, tuple) else str(e) for e in entries]
    if lines:
        listed = "\n".join(f"  {line}" for line in lines)
        pytest.fail(f"{len(lines)} broken:\n{listed}\nWhat to do: {remedy}", pytrace=False)
