"""What viewers are told of a moving scene: all of it when something new is there, else where its frames are."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

from simkit.viz.marks import Marks, moment_data
from simkit.viz.scene import Scene
from simkit.viz.scene_data import rounded, scene_data
from simkit.viz.stage import Stage
from simkit.viz.tf_scene import FramePose, TfScene

Poses: TypeAlias = tuple[tuple[float, ...], ...]
"""x, y, z [m] and the quaternion xyzw of each frame, in the order of the scene."""


class NewsSource(Protocol):
    """Where the scenes of a live view come from."""

    @property
    def settings(self) -> object:
        """What is to be seen."""

    def scene(self) -> Scene:
        """What is to be seen now."""

    def frames(self) -> TfScene:
        """Where the frames are now; less work than a whole scene."""

    def marks(self) -> tuple[Marks, ...]:
        """The points and lines of this moment; the displays of the scene, in its order."""

    def shapes(self) -> object:
        """The shapes that hang on the frames; another object when they are others."""


@dataclass(frozen=True, slots=True, kw_only=True)
class State:
    """A scene and where its frames are now."""

    number: int
    """Grows when the scene is another one, and not when frames have only moved."""
    scene: str
    """The scene as JSON, with its frames where they were when it was made."""
    poses: Poses
    """Where they are now."""
    marks: tuple[Marks, ...] = ()
    """Points and lines as they are now."""


class LiveNews:
    """Follows a scene, with little to do when nothing but poses has changed.

    Args:
        source: Where the scenes come from.

    Attributes:
        scene: The last one that was made as a whole.
        state: What a viewer has to know.
    """

    def __init__(self, source: NewsSource) -> None:
        self._source = source
        self.scene = source.scene()
        self.state = self._made(number=0)

    def look(self) -> State:
        """What there is to be seen now."""
        frames = self._source.frames()
        if self._features(frames) != self._known or _has_left(frames, self.scene.stage):
            self.scene = self._source.scene()
            self.state = self._made(number=self.state.number + 1)
        else:
            self.state = State(
                number=self.state.number,
                scene=self.state.scene,
                poses=_poses(frames),
                marks=self._source.marks(),
            )
        return self.state

    def _made(self, *, number: int) -> State:
        self._known = self._features(self.scene.tf)
        text = json.dumps(scene_data(self.scene), allow_nan=False, separators=(",", ":"))
        poses, marks = _poses(self.scene.tf), self.scene.marks
        return State(number=number, scene=text, poses=poses, marks=marks)

    def _features(self, frames: TfScene) -> tuple[object, ...]:
        """Everything but the poses."""
        names = tuple((pose.name, pose.parent) for pose in frames.poses)
        return frames.fixed_frame, names, frames.error, frames.problems, id(self._source.shapes())


def message(
    state: State,
    known_number: int,
    known: Mapping[int, tuple[float, ...]],
    known_marks: tuple[Marks, ...] = (),
) -> str | None:
    """What a viewer still has to be told; None if it knows everything.

    Args:
        state: What there is to know.
        known_number: The number of the scene that it has.
        known: Which poses it has, by number of the frame; empty for another scene.
        known_marks: Which points and lines it has.
    """
    news: dict[str, Any] = {}
    if state.number != known_number:
        known, known_marks = {}, ()
    moved = {number: pose for number, pose in enumerate(state.poses) if known.get(number) != pose}
    if moved:
        news["poses"] = moved
    if state.marks != known_marks:
        news["marks"] = [moment_data(marks) for marks in state.marks]
    text = json.dumps(news, allow_nan=False, separators=(",", ":"))
    if state.number != known_number:
        return f'{{"scene":{state.scene},"news":{text}}}'
    return f'{{"news":{text}}}' if news else None


def _poses(frames: TfScene) -> Poses:
    return tuple(tuple(rounded((*pose.origin, *pose.rotation))) for pose in frames.poses)


def _has_left(frames: TfScene, stage: Stage) -> bool:
    """Whether a frame is beyond the grid, so that there should be a larger one."""
    return any(not _is_on(pose, stage) for pose in frames.poses)


def _is_on(pose: FramePose, stage: Stage) -> bool:
    bounds = (stage.grid_x, stage.grid_y)
    return all(
        low * stage.cell <= value <= high * stage.cell
        for value, (low, high) in zip(pose.origin[:2], bounds, strict=True)
    )
