"""What urdfdom says while it reads, line by line as on its standard error."""

from __future__ import annotations


class Log:
    """Collects lines. Where in its own source urdfdom was ("at line N in ...") is left out."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        """The lines, with the level in front."""

    def error(self, text: str) -> None:
        """Something that urdfdom calls an error; without words it says nothing."""
        if text:
            self.lines.append(f"Error:   {text}")

    def warning(self, text: str) -> None:
        """Something that urdfdom warns of."""
        self.lines.append(f"Warning: {text}")
