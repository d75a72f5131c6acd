"""A recording of a world as one HTML file: press play and watch the models move again."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

from simkit.saving import save_as
from simkit.viz.page import inline_frame
from simkit.viz.plots.recorded import RecordedTopics
from simkit.viz.rviz_page import page_height, view_page
from simkit.viz.scene_data import scene_data
from simkit.viz.tape_controls import tape_controls
from simkit.viz.topics.topic_tape import track_data
from simkit.viz.world.play import WorldPlay, world_play
from simkit.viz.world.settings import WorldSettings
from simkit.viz.world.tape import WorldTape

_CONTROLS_HEIGHT: Final = 45


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
            data={**scene_data(self.play.scene), "tape": _data(self.play)},
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
        height = page_height(scene) + _CONTROLS_HEIGHT
        return inline_frame(self.to_html(), title=scene.window.title, height=height)


def _data(play: WorldPlay) -> dict[str, Any]:
    return {
        "duration": play.duration,
        "topics": [track_data(track) for track in play.displays],
        "until": play.until,
        "tracks": [
            [[round(row[0], 3), *(round(value, 5) for value in row[1:])] for row in track]
            for track in play.tracks
        ],
    }
