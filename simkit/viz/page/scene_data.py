"""A scene as JSON: what the script of a view draws, and what a live one sends."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Final, Protocol, TypeAlias

from simkit.geometry import Quaternion, Vector
from simkit.urdf import Box, Cylinder, Sphere
from simkit.viz.draw.letters import abbreviated
from simkit.viz.stage import style
from simkit.viz.stage.camera import FIELD_OF_VIEW, Stage
from simkit.viz.stage.frames import FramePose, TfScene
from simkit.viz.stage.parts import (
    LINE_WIDTH,
    POINT_SIZE,
    Marks,
    TriangleMesh,
    marks_data,
    moment_data,
)
from simkit.viz.stage.scene import LONGEST, PlacedSolid, Scene

MOST_NAMES: Final = 200
"""So many frames are named in the picture; of more than that nobody could read the names."""
HELP: Final = (
    "Drag: turn. Shift and drag, or two fingers: move. Wheel after a click, or + and -: zoom. "
    "Arrow keys: turn. Home: as at first. t: from above."
)
_DIGITS = 6


def scene_summary(scene: Scene) -> str:
    """One sentence on what is to be seen."""
    if scene.tf.error:
        return scene.tf.error
    if scene.headline:
        return f"{scene.headline}."
    count = len(scene.tf.poses)
    fixed = abbreviated(scene.tf.fixed_frame, LONGEST)
    return f"{count} frame{'s' * (count != 1)} seen from {fixed}."


def grid_note(stage: Stage) -> str:
    """How large the cells of the grid are, in words."""
    return f"grid: {stage.cell:g} m"


def scene_data(scene: Scene) -> Mapping[str, Any]:
    """The whole scene."""
    numbers = {pose.name: number for number, pose in enumerate(scene.tf.poses)}
    meshes: dict[TriangleMesh, int] = {}
    solids = [_solid(placed, numbers, meshes) for placed in scene.solids]
    return {
        "fixedFrame": abbreviated(scene.tf.fixed_frame, LONGEST),
        "summary": scene_summary(scene),
        "error": scene.tf.error,
        "problems": scene.problems,
        "notes": scene.notes,
        "scale": grid_note(scene.stage),
        "help": HELP,
        "command": scene.window.command,
        "mostNames": MOST_NAMES,
        "style": _STYLE,
        "stage": _stage(scene.stage),
        "frames": [_frame(pose, numbers, scene.tf.fixed_frame) for pose in scene.tf.poses],
        "solids": solids,
        "meshes": [
            {"vertices": _text(mesh.vertices), "triangles": _text(mesh.triangles)}
            for mesh in meshes
        ],
        "marks": [marks_data(marks) for marks in scene.marks],
    }


def rounded(values: Iterable[float]) -> list[float]:
    """Numbers as exact as a picture needs them."""
    return [round(value, _DIGITS) for value in values]


_STYLE: Final = {
    "axisColors": style.AXIS_COLORS,
    "axisRadius": style.AXIS_RADIUS,
    "arrowColor": style.ARROW_COLOR,
    "arrowRadius": style.ARROW_RADIUS,
    "headRadius": style.HEAD_RADIUS,
    "headLength": style.HEAD_LENGTH,
    "ghost": style.GHOST,
    "ambient": style.AMBIENT,
    "light": style.LIGHT,
    "clear": style.CLEAR,
    "pointSize": POINT_SIZE,
    "lineWidth": LINE_WIDTH,
}


def _stage(stage: Stage) -> Mapping[str, Any]:
    camera = stage.camera
    return {
        "axisLength": stage.axis_length,
        "cell": stage.cell,
        "gridX": stage.grid_x,
        "gridY": stage.grid_y,
        "fieldOfView": FIELD_OF_VIEW,
        "camera": {
            "target": camera.target,
            "distance": camera.distance,
            "azimuth": camera.azimuth,
            "elevation": camera.elevation,
        },
    }


def _frame(pose: FramePose, numbers: Mapping[str, int], fixed_frame: str) -> Mapping[str, Any]:
    return {
        "label": abbreviated(pose.name, LONGEST),
        "isFixed": pose.name == fixed_frame,
        "parent": numbers.get(pose.parent) if pose.parent is not None else None,
        **_pose(pose.origin, pose.rotation),
    }


def _solid(
    placed: PlacedSolid, numbers: Mapping[str, int], meshes: dict[TriangleMesh, int]
) -> Mapping[str, Any]:
    solid = placed.solid
    match solid.shape:
        case Box(size=lengths):
            kind, size = "box", rounded(lengths)
        case Cylinder(radius=radius, length=length):
            kind, size = "cylinder", rounded((radius, length))
        case Sphere(radius=radius):
            kind, size = "sphere", rounded((radius,))
        case TriangleMesh() as mesh:
            kind, size = "mesh", [meshes.setdefault(mesh, len(meshes))]
    return {
        "role": solid.role.value,
        "frame": numbers[placed.frame.name] if placed.frame is not None else None,
        "kind": kind,
        "size": size,
        "color": style.hex_color(placed.color),
        "alpha": round(placed.alpha, 3),
        **_pose(solid.translation, solid.rotation),
    }


def _pose(origin: Vector, rotation: Quaternion) -> Mapping[str, list[float]]:
    return {"p": rounded(origin), "q": rounded(rotation)}


def _text(data: bytes) -> str:
    return base64.b64encode(data).decode("ascii")


Poses: TypeAlias = tuple[tuple[float, ...], ...]
"""x, y, z [m] and the quaternion xyzw of each frame, in the order of the scene."""


class LiveSource(Protocol):
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

    def changes(self, known: SceneState | None) -> str | None:
        """What a viewer does not know yet, as JSON; None if it knows everything.

        Args:
            known: What the viewer got last; None if nothing.
        """
        is_known = known is not None and known.number == self.number
        poses, marks = (known.poses, known.marks) if known and is_known else ((), ())
        old = dict(enumerate(poses))
        moved = {number: pose for number, pose in enumerate(self.poses) if old.get(number) != pose}
        changes: dict[str, Any] = {}
        if moved:
            changes["poses"] = moved
        if self.marks != marks:
            changes["marks"] = [moment_data(one) for one in self.marks]
        text = json.dumps(changes, allow_nan=False, separators=(",", ":"))
        if not is_known:
            return f'{{"scene":{self.scene},"changes":{text}}}'
        return f'{{"changes":{text}}}' if changes else None

    def moment(self) -> str:
        """Where everything is now as JSON, for whoever has the scene of this number."""
        changes = {
            "poses": dict(enumerate(self.poses)),
            "marks": [moment_data(one) for one in self.marks],
        }
        return json.dumps(
            {"number": self.number, "changes": changes}, allow_nan=False, separators=(",", ":")
        )


class LiveScene:
    """Follows a scene, with little to do when nothing but poses has changed.

    Args:
        source: Where the scenes come from.

    Attributes:
        scene: The last one that was made as a whole.
        state: What a viewer has to know.
    """

    def __init__(self, source: LiveSource) -> None:
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
