"""Whether one name is most likely another one, misspelt."""

from __future__ import annotations

_LONGEST = 40
_SHORT = 4


def is_near(name: str, other: str) -> bool:
    """Whether a person may have written `name` for `other`: one slip in a short name, two in a longer one."""
    name, other = name.lower(), other.lower()
    if name == other:
        return True
    slips = 1 if min(len(name), len(other)) <= _SHORT else 2
    if abs(len(name) - len(other)) > slips or max(len(name), len(other)) > _LONGEST:
        return False
    return _slips(name, other) <= slips and min(len(name), len(other)) > 1


def _slips(name: str, other: str) -> int:
    """Letters added, left out, replaced, or swapped with their neighbour, at least, between two names."""
    before: list[int] = []
    row = list(range(len(other) + 1))
    for i, letter in enumerate(name):
        last, before, row = before, row, [i + 1]
        for j, wanted in enumerate(other):
            best = min(before[j + 1] + 1, row[j] + 1, before[j] + (letter != wanted))
            if i and j and letter == other[j - 1] and name[i - 1] == wanted:
                best = min(best, last[j - 1] + 1)
            row.append(best)
    return row[-1]
