"""Where the original program ends with a traceback, this one ends with the traceback's last line."""

from __future__ import annotations

from simkit.errors import SimkitError


class Crash(SimkitError):
    """The program cannot go on.

    Args:
        said: Last line of the traceback that the original ends with; empty if it has none.
        text: What is wrong and what to do, in a sentence for people.
    """

    def __init__(self, said: str, text: str) -> None:
        super().__init__(text)
        self.said = said
