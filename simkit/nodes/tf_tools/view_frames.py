"""view_frames: listens to tf for five seconds, then writes the tree of frames into files.

Source: tf `view_frames` and tf2_tools `view_frames.py`: their words, `frames.gv` and `frames.pdf`. No graphviz is needed here.
"""

from __future__ import annotations

from simkit.graph import Node
from simkit.msgs import Duration
from simkit.nodes.program import Program
from simkit.tf import Buffer, TransformListener

LISTENS = Duration(5)
"""How long it listens."""


class _ViewFrames(Program):
    begins: str
    ends: str

    def __init__(self, node: Node, argv: list[str]) -> None:  # noqa: ARG002 - it takes none
        super().__init__(node)
        self._buffer = Buffer()
        TransformListener(node, self._buffer)
        self._print(self.begins)
        node.create_timer(LISTENS, self._write)

    def _write(self) -> None:
        from simkit.viz.trees.frames import FramesPicture

        picture = FramesPicture(self._buffer, now=self._node.now())
        try:
            for name in ("frames.gv", "frames.pdf"):
                picture.save(self._folder / name)
        except OSError as error:
            self._print(f"cannot write {error.filename}: {error.strerror}\n")
            self._exit(1)
            return
        self._print(self.ends)
        self._exit(0)


class TfViewFrames(_ViewFrames):
    """The program `view_frames` of the package tf."""

    begins = (
        "WARNING: tf view_frames is deprecated. Use tf2_tools view_frames.py instead.\n"
        "Listening to /tf for 5.0 seconds\n"
    )
    ends = "Done Listening\nframes.pdf generated\n"


class Tf2ViewFrames(_ViewFrames):
    """The program `view_frames.py` of the package tf2_tools."""

    begins = "Listening to tf data during 5 seconds...\n"
    ends = "Generating graph in frames.pdf file...\n"
