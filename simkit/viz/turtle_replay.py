"""A run of turtlesim as one HTML file: press play and watch the turtles move again."""

from __future__ import annotations

from pathlib import Path

from simkit.nodes.turtlesim import Frame
from simkit.saving import save_as
from simkit.viz.page import inline_frame
from simkit.viz.replay_page import TITLE, page_height, replay_page
from simkit.viz.turtle_tape import TurtleTape, turtle_tape


class TurtleReplay:
    """The turtles and their trails from the beginning until now; it does not change afterwards.

    It has a button to play, a slider over virtual time and a choice of speeds, and needs neither
    a server nor a network: it also works in a file and in a saved notebook.

    Args:
        frame: The window of turtlesim.

    Attributes:
        tape: What is shown, as numbers.
    """

    def __init__(self, frame: Frame) -> None:
        self.tape: TurtleTape = turtle_tape(frame)

    def to_html(self) -> str:
        """The replay as one HTML file; equal runs give equal text."""
        return replay_page(self.tape)

    def save(self, path: str | Path) -> None:
        """Write the replay to an `.html` file.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        save_as(path, {".html": self.to_html}, kind="replay format")

    def __repr__(self) -> str:
        return f"TurtleReplay({self.tape.duration:.2f} s, {len(self.tape.motions)} turtles)"

    def _repr_html_(self) -> str:
        return inline_frame(self.to_html(), title=TITLE, height=page_height(self.tape))
