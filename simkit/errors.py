"""The errors of simkit: each says what was asked, what exists, and what to do."""

from __future__ import annotations

from collections.abc import Iterable


class SimkitError(Exception):
    """Root of every error that simkit raises on purpose."""


def near_names(name: str, known: Iterable[str], limit: int = 3) -> list[str]:
    """Names of `known` that a person may have meant by `name`, best first.

    Args:
        name: What was written.
        known: What exists.
        limit: At most so many.
    """
    import difflib  # only who has made a mistake waits for it

    by_folded: dict[str, str] = {}
    for candidate in sorted(known):
        by_folded.setdefault(candidate.lower(), candidate)
    close = difflib.get_close_matches(name.lower(), list(by_folded), n=limit, cutoff=0.6)
    return [by_folded[folded] for folded in close]


class UnknownNameError(SimkitError, KeyError):
    """A name of some kind (topic, service, message type, package, ...) that does not exist."""

    def __init__(self, kind: str, name: str, known: Iterable[str]) -> None:
        self.kind = kind
        self.name = name
        self.known = tuple(sorted(known))
        super().__init__(str(self))

    def __str__(self) -> str:
        """One line: the unknown name, near names, and (a few of) the known ones."""
        text = f"no {self.kind} {self.name!r}"
        near = near_names(self.name, self.known)
        if near:
            text += "; did you mean " + " or ".join(repr(n) for n in near) + "?"
        elif self.known:
            text += ";"
        if self.known:
            shown = ", ".join(self.known[:12])
            more = len(self.known) - 12
            text += f" Known: {shown}" + (f" and {more} more" if more > 0 else "")
        return text
