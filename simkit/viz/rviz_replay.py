"""A recording of tf as one HTML file: press play and watch the frames and the robot move again."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from simkit.saving import save_as
from simkit.viz.page import inline_frame
from simkit.viz.plots.recorded import RecordedTopics
from simkit.viz.robot_solids import RobotShapes
from simkit.viz.rviz_page import TITLE, page_height, view_page
from simkit.viz.rviz_settings import RvizSettings
from simkit.viz.rviz_tape import RvizTape, rviz_tape
from simkit.viz.scene_data import scene_data
from simkit.viz.tape_controls import tape_controls
from simkit.viz.topics.topic_tape import track_data

_CONTROLS_HEIGHT: Final = 45


class RvizReplay:
    """What RViz showed from the first to the last message; it does not change afterwards.

    It has a button to play, a slider over virtual time and a choice of speeds, and needs neither
    a server nor a network: it also works in a file and in a saved notebook.

    Args:
        recording: Of /tf, of /tf_static if there are static transforms, and of the topics that are shown.
        settings: What is to be seen; the usual if None.
        robot: The robot; None if there is none.

    Attributes:
        tape: What is shown, as numbers.
    """

    def __init__(
        self,
        recording: RecordedTopics,
        settings: RvizSettings | None = None,
        *,
        robot: RobotShapes | None = None,
    ) -> None:
        self.tape: RvizTape = rviz_tape(recording, settings or RvizSettings(), robot)

    def to_html(self) -> str:
        """The replay as one HTML file; equal recordings give equal text."""
        data = {**scene_data(self.tape.scene), "tape": _data(self.tape)}
        return view_page(
            self.tape.scene,
            data=data,
            controls=tape_controls(self.tape.duration),
            scripts=["tape", "rviz_replay"],
        )

    def save(self, path: str | Path) -> None:
        """Write the replay to an `.html` file.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        save_as(path, {".html": self.to_html}, kind="replay format")

    def __repr__(self) -> str:
        return f"RvizReplay({self.tape.duration:.2f} s, {len(self.tape.tracks)} frames)"

    def _repr_html_(self) -> str:
        height = page_height(self.tape.scene) + _CONTROLS_HEIGHT
        return inline_frame(self.to_html(), title=TITLE, height=height)


def _data(tape: RvizTape) -> dict[str, object]:
    return {
        "duration": tape.duration,
        "topics": [track_data(track) for track in tape.topics],
        "tracks": [
            [[round(row[0], 3), *(round(value, 5) for value in row[1:])] for row in track]
            for track in tape.tracks
        ],
    }
