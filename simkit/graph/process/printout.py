"""Graph side: what a script prints, and how much of it was shown."""

from __future__ import annotations

import codecs
from collections.abc import Callable


class Printout:
    """What one script has printed, standard output and error in one.

    Args:
        show: Shows a text to a person.
    """

    def __init__(self, show: Callable[[str], None]) -> None:
        self.data = bytearray()
        """What has come so far; its link fills it."""
        self._show = show
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")
        self._shown = 0

    @property
    def text(self) -> str:
        """All of it."""
        return self.data.decode("utf-8", "replace")

    def show_news(self) -> None:
        """Show what has come since the last call; half a character waits for its other half."""
        if self._shown < len(self.data):
            text = self._decoder.decode(self.data[self._shown :])
            self._shown = len(self.data)
            if text:
                self._show(text)
