"""What viewers are told of a moving scene: all of it when something new is there, else where its frames are."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

from simkit.viz.page.scene_data import rounded, scene_data
from simkit.viz.stage.camera import Stage
from simkit.viz.stage.frames import FramePose, TfScene
from simkit.viz.stage.marks import Marks, moment_data
from simkit.viz.stage.scene import Scene

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
class SceneState:
    """A scene and where its frames are now."""

    number: int
    """Grows when the scene is another one, and not when frames have only moved."""
    scene: str
    """The scene as JSON, with its frames where they were when it was made."""
    poses: Poses
    """Where they are now."""
    marks: tuple[Marks, ...] = ()
    """Points and lines as they are now."""

    def news(self, known: SceneState | None) -> str | None:
        """What a viewer still has to be told as JSON; None if it knows everything.

        Args:
            known: What the viewer was told last; None if nothing.
        """
        is_known = known is not None and known.number == self.number
        poses, marks = (known.poses, known.marks) if known and is_known else ((), ())
        old = dict(enumerate(poses))
        moved = {number: pose for number, pose in enumerate(self.poses) if old.get(number) != pose}
        news: dict[str, Any] = {}
        if moved:
            news["poses"] = moved
        if self.marks != marks:
            news["marks"] = [moment_data(one) for one in self.marks]
        text = json.dumps(news, allow_nan=False, separators=(",", ":"))
        if not is_known:
            return f'{{"scene":{self.scene},"news":{text}}}'
        return f'{{"news":{text}}}' if news else None

    def moment(self) -> str:
        """Where everything is now as JSON, for whoever has the scene of this number."""
        news = {
            "poses": dict(enumerate(self.poses)),
            "marks": [moment_data(one) for one in self.marks],
        }
        return json.dumps(
            {"number": self.number, "news": news}, allow_nan=False, separators=(",", ":")
        )


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

    def look(self) -> SceneState:
        """What there is to be seen now."""
        frames = self._source.frames()
        if self._features(frames) != self._known or _has_left(frames, self.scene.stage):
            self.scene = self._source.scene()
            self.state = self._made(number=self.state.number + 1)
        else:
            self.state = SceneState(
                number=self.state.number,
                scene=self.state.scene,
                poses=_poses(frames),
                marks=self._source.marks(),
            )
        return self.state

    def _made(self, *, number: int) -> SceneState:
        self._known = self._features(self.scene.tf)
        text = json.dumps(scene_data(self.scene), allow_nan=False, separators=(",", ":"))
        poses, marks = _poses(self.scene.tf), self.scene.marks
        return SceneState(number=number, scene=text, poses=poses, marks=marks)

    def _features(self, frames: TfScene) -> tuple[object, ...]:
        """Everything but the poses."""
        names = tuple((pose.name, pose.parent) for pose in frames.poses)
        return frames.fixed_frame, names, frames.error, frames.problems, id(self._source.shapes())


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
