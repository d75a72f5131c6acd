"""A scene as JSON: what the script of a view draws, and what a live one sends."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Mapping
from typing import Any, Final

from simkit.geometry import Quaternion, Vector
from simkit.urdf import Box, Cylinder, Sphere
from simkit.viz.draw.letters import shortened
from simkit.viz.stage import style
from simkit.viz.stage.camera import FIELD_OF_VIEW, Stage
from simkit.viz.stage.frames import FramePose
from simkit.viz.stage.marks import LINE_WIDTH, POINT_SIZE, marks_data
from simkit.viz.stage.scene import LONGEST, PlacedSolid, Scene
from simkit.viz.stage.solid import TriangleMesh

MOST_NAMES: Final = 200
"""So many frames are named in the picture; of more than that nobody could read the names."""
HELP: Final = (
    "Drag: turn. Shift and drag, or two fingers: move. Wheel after a click, or + and -: zoom. "
    "Arrow keys: turn. Home: as at first. t: from above."
)
_DIGITS = 6


def summary(scene: Scene) -> str:
    """One sentence on what is to be seen."""
    if scene.tf.error:
        return scene.tf.error
    if scene.headline:
        return f"{scene.headline}."
    count = len(scene.tf.poses)
    fixed = shortened(scene.tf.fixed_frame, LONGEST)
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
        "fixedFrame": shortened(scene.tf.fixed_frame, LONGEST),
        "summary": summary(scene),
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
        "label": shortened(pose.name, LONGEST),
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
