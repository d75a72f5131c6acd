"""A scene over time, of any source: where each frame was, what each display showed; and its replay."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final

from simkit.geometry import Quaternion, Vector
from simkit.viz.draw.thinning import Row, thinned
from simkit.viz.page.scene_data import scene_data
from simkit.viz.page.view_page import page_height, view_page
from simkit.viz.replay import Replay, Track, tape_controls, track_data
from simkit.viz.stage.frames import FramePose
from simkit.viz.stage.parts import Marks, Solid, corners, moment_data
from simkit.viz.stage.scene import Scene
from simkit.viz.stage.topic_marks import Shown

_SHARE, _TURN = 0.0005, 0.0015
"Nobody sees a frame that is off by this share of the distance, or a quaternion that is off by so much."
_SAMPLES: Final = 50
"At so many of its times one asks how much room something needs."
_CONTROLS_HEIGHT: Final = 45


@dataclass(frozen=True, slots=True, kw_only=True)
class MarksTrack:
    """What one display of points and lines showed over time."""

    marks: Marks
    """What it showed at the end."""
    moments: tuple[tuple[float, Shown], ...]
    """What it showed from a time [s] on; of a trail, the lines that came at that time."""
    keep: int = 0
    """So many lines of a trail are seen, the newest; 0 for what is not a trail."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneTape:
    """A scene over time; times count from the beginning."""

    start_ns: int
    """Virtual time of the beginning [ns]."""
    duration: float
    """From the beginning to the end [s]."""
    scene: Scene
    """The end, with a grid and a camera for the whole."""
    tracks: tuple[Track, ...]
    """For each frame of the scene x, y, z [m] and its quaternion xyzw."""
    marks: tuple[MarksTrack, ...]
    """For each display of points and lines, what it showed."""


def pose_track(scene: Scene, rows: Sequence[Row], *, until: float | None = None) -> Track:
    """The track of a frame, without rows that nobody would miss.

    Args:
        scene: Where it is seen.
        rows: Time [s], x, y, z [m], quaternion xyzw.
        until: When the frame was gone [s]; None if it was there to the end.
    """
    tolerances = (*[_SHARE * scene.stage.camera.distance] * 3, *[_TURN] * 4)
    return Track(rows=tuple(thinned(rows, tolerances)), until=until)


def pose_row(rows: Sequence[Row], time: float, origin: Vector, rotation: Quaternion) -> Row:
    """The row that follows others; of the two quaternions of a rotation, the one that is nearer to the last."""
    if rows and math.fsum(a * b for a, b in zip(rows[-1][4:], rotation, strict=True)) < 0.0:
        x, y, z, w = rotation
        rotation = (-x, -y, -z, -w)
    return (time, *origin, *rotation)


def posed(pose: FramePose, row: Row) -> FramePose:
    """A frame as a row has it."""
    _, x, y, z, a, b, c, d = row
    return replace(pose, origin=(x, y, z), rotation=(a, b, c, d))


def sampled(pose: FramePose, rows: Sequence[Row]) -> Iterator[FramePose]:
    """A frame at some of its times."""
    for row in rows[:: max(1, len(rows) // _SAMPLES)]:
        yield posed(pose, row)


def swept_corners(solid: Solid, poses: Iterable[FramePose]) -> Iterator[Vector]:
    """The corners of the box around a shape, wherever its frame was [m]."""
    for pose in poses:
        yield from corners(solid, pose)


def marks_track_data(track: MarksTrack) -> Mapping[str, Any]:
    """A display for the script of a replay."""
    moments = [
        {
            "time": round(time, 3),
            **moment_data(
                replace(track.marks, points=one.points, colors=one.colors, lines=one.lines)
            ),
        }
        for time, one in track.moments
    ]
    return {"keep": track.keep, "moments": moments}


class SceneReplay(Replay):
    """A tape of a scene as a page: press play, and its frames, robots or models move again.

    Args:
        tape: What it shows.

    Attributes:
        tape: What it shows, as numbers.
    """

    def __init__(self, tape: SceneTape) -> None:
        self.tape = tape
        self.TITLE = tape.scene.window.title

    def to_html(self) -> str:
        """The replay as one HTML file; equal recordings give equal text."""
        data = {
            "duration": self.tape.duration,
            "marks": [marks_track_data(track) for track in self.tape.marks],
            "tracks": [track_data(track, digits=5) for track in self.tape.tracks],
        }
        return view_page(
            self.tape.scene,
            data={**scene_data(self.tape.scene), "tape": data},
            controls=tape_controls(self.tape.duration),
            scripts=["tape", "rviz_replay"],
        )

    def end_png(self) -> bytes:
        """The end as a PNG file, without a browser."""
        from simkit.viz.still.picture import still_png

        return still_png(self.tape.scene, scale=1)

    def height(self) -> int:
        """Room that the page needs inside another [px]."""
        return page_height(self.tape.scene) + _CONTROLS_HEIGHT
