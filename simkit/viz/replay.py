"""A tape as one HTML file: press play and watch the frames, the robot or the models move again."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

from simkit.viz.page.html import inline_frame
from simkit.viz.page.scene_data import scene_data
from simkit.viz.page.view_page import TITLE, page_height, view_page
from simkit.viz.plots.recorded import RecordedTopics
from simkit.viz.rviz_tape import RvizTape, rviz_tape
from simkit.viz.saving import save_as
from simkit.viz.stage.robot import RobotShapes
from simkit.viz.stage.rviz_settings import RvizSettings
from simkit.viz.stage.world_scene import WorldSettings
from simkit.viz.tape import track_data
from simkit.viz.tape_controls import tape_controls
from simkit.viz.world_recording import WorldTape
from simkit.viz.world_tape import WorldPlay, world_play

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


_CONTROLS_HEIGHT2: Final = 45


class WorldReplay:
    """What the window of Gazebo showed during a recording; it does not change afterwards.

    It has a button to play, a slider over virtual time and a choice of speeds, and needs neither
    a server nor a network: it also works in a file and in a saved notebook.

    Args:
        tape: The recording.
        settings: What is seen at first; the usual if None.
        trails: Links that leave a trail: `model::link`, or `model` for its root link.
        odometry: A recording of nav_msgs/Odometry; each of its topics leaves a trail as well.

    Attributes:
        play: What is shown, as numbers.

    Raises:
        UnknownNameError: There was no such link, or no model to look at, of that name.
    """

    def __init__(
        self,
        tape: WorldTape,
        settings: WorldSettings | None = None,
        *,
        trails: Sequence[str] = (),
        odometry: RecordedTopics | None = None,
    ) -> None:
        tape.look()
        self.play: WorldPlay = world_play(
            tape, settings or WorldSettings(), trails=trails, odometry=odometry
        )

    def to_html(self) -> str:
        """The replay as one HTML file; equal recordings give equal text."""
        return view_page(
            self.play.scene,
            data={**scene_data(self.play.scene), "tape": _world_data(self.play)},
            controls=tape_controls(self.play.duration),
            scripts=["tape", "rviz_replay"],
        )

    def save(self, path: str | Path) -> None:
        """Write the replay to an `.html` file.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        save_as(path, {".html": self.to_html}, kind="replay format")

    def __repr__(self) -> str:
        return f"WorldReplay({self.play.duration:.2f} s, {len(self.play.tracks)} links)"

    def _repr_html_(self) -> str:
        scene = self.play.scene
        height = page_height(scene) + _CONTROLS_HEIGHT2
        return inline_frame(self.to_html(), title=scene.window.title, height=height)


def _world_data(play: WorldPlay) -> dict[str, Any]:
    return {
        "duration": play.duration,
        "topics": [track_data(track) for track in play.displays],
        "until": play.until,
        "tracks": [
            [[round(row[0], 3), *(round(value, 5) for value in row[1:])] for row in track]
            for track in play.tracks
        ],
    }
