"""A scene as pixels: the same things in the same light as in the view to turn."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from simkit.geometry import IDENTITY, Quaternion, Vector, multiply, quaternion_from_z
from simkit.viz.draw.drawing import Point
from simkit.viz.stage import style
from simkit.viz.stage.camera import Stage
from simkit.viz.stage.frames import FramePose
from simkit.viz.stage.parts import POINT_SIZE, Color, Marks, Role, along
from simkit.viz.stage.scene import PlacedSolid, Scene
from simkit.viz.still.raster import Eye, Layer, Pixels
from simkit.viz.still.surfaces import (
    Array,
    Surface,
    joined_surfaces,
    surface_of,
    unit_box,
    unit_cylinder,
)

_HALF = math.sqrt(0.5)
_FROM_Z: tuple[Quaternion, ...] = (
    (0.0, _HALF, 0.0, _HALF),
    (-_HALF, 0.0, 0.0, _HALF),
    (0.0, 0.0, 0.0, 1.0),
)
"Turns z to x, to y, to z."
_INNER = (Role.CENTRE, Role.JOINT)
"Shapes that are inside of others, and shine through them as frames do."


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneParts:
    """Everything that is drawn, by how it is drawn."""

    grid: tuple[tuple[Array, Color], ...]
    """The lines of the grid, shape (n, 2, 3) [m], by their colour."""
    opaque: tuple[tuple[Surface, Color], ...]
    """Shapes that hide what is behind them."""
    frames: tuple[tuple[Surface, Color], ...]
    """Axes and arrows, which shine through the shapes."""
    veils: tuple[tuple[Surface, Color, float], ...]
    """Shapes that light goes through, with their opacity, the farthest first."""
    dots: tuple[tuple[Surface, Color, bool], ...] = ()
    """The points of marks, and whether they shine through the shapes."""
    strokes: tuple[tuple[Array, Color, bool], ...] = ()
    """The lines of marks: their straight parts, shape (n, 2, 3) [m], colour, whether they shine through."""


def scene_parts(scene: Scene) -> SceneParts:
    """What is drawn of a scene, as its displays say."""
    displays = scene.displays
    shown = [placed for placed in scene.solids if displays.shows(placed.solid.role)]
    shown.sort(key=lambda placed: -scene.stage.camera.seen(placed.pose()[0])[2])
    outer = [(s, _opacity(s, scene)) for s in shown if s.solid.role not in _INNER]
    frames: dict[str, list[Surface]] = {}
    if displays.tf:
        for surface, color in _frame_surfaces(scene.tf.poses, scene.stage.axis_length):
            frames.setdefault(color, []).append(surface)
    inner = [(_surface(s), s.color) for s in shown if s.solid.role in _INNER]
    axes = [(joined_surfaces(parts), style.rgb(color)) for color, parts in frames.items()]
    marks = [marks for marks in scene.marks if marks.is_on]
    return SceneParts(
        grid=tuple(_grid(scene.stage)) if displays.grid else (),
        opaque=tuple((_surface(s), s.color) for s, alpha in outer if alpha >= 1.0),
        frames=(*axes, *inner),
        veils=tuple((_surface(s), s.color, alpha) for s, alpha in outer if alpha < 1.0),
        dots=tuple(_dots(marks, POINT_SIZE * scene.stage.camera.distance)),
        strokes=tuple(_strokes(marks)),
    )


def _opacity(placed: PlacedSolid, scene: Scene) -> float:
    is_clear = scene.displays.transparent and placed.solid.role is Role.VISUAL
    return placed.alpha * (style.CLEAR if is_clear else 1.0)


def _dots(displays: Iterable[Marks], size: float) -> Iterator[tuple[Surface, Color, bool]]:
    for marks in displays:
        boxes: dict[str, list[Surface]] = {}
        colors = marks.colors if marks.is_many_colored else [marks.color] * len(marks.points)
        for point, color in zip(marks.points, colors, strict=True):
            boxes.setdefault(color, []).append(unit_box().placed(point, IDENTITY, (size,) * 3))
        for color, parts in boxes.items():
            yield joined_surfaces(parts), style.rgb(color), marks.shines_through


def _strokes(displays: Iterable[Marks]) -> Iterator[tuple[Array, Color, bool]]:
    for marks in displays:
        parts = [part for line in marks.lines for part in pairwise(line)]
        if parts:
            yield np.array(parts), style.rgb(marks.color), marks.shines_through


def _grid(stage: Stage) -> Iterator[tuple[Array, Color]]:
    """Its lines x = 0 and y = 0, and all others."""
    xs, ys = (stage.cell * np.arange(low, high + 1.0) for low, high in (stage.grid_x, stage.grid_y))
    lines = [((x, ys[0], 0.0), (x, ys[-1], 0.0)) for x in xs]
    lines += [((xs[0], y, 0.0), (xs[-1], y, 0.0)) for y in ys]
    is_zero = np.concatenate([xs, ys]) == 0.0
    yield np.array(lines)[~is_zero], style.rgb(style.GRID_COLOR)
    yield np.array(lines)[is_zero], style.rgb(style.ZERO_COLOR)


def _frame_surfaces(poses: tuple[FramePose, ...], length: float) -> Iterator[tuple[Surface, str]]:
    sides = 12 if len(poses) < 100 else 3
    origins = {pose.name: pose.origin for pose in poses}
    rod, cone = unit_cylinder(sides), unit_cylinder(sides, 0.0)
    for pose in poses:
        for axis, turn, color in zip(pose.axes, _FROM_Z, style.AXIS_COLORS, strict=True):
            thick = style.AXIS_RADIUS * length
            middle = along(pose.origin, axis, length / 2)
            yield rod.placed(middle, multiply(pose.rotation, turn), (thick, thick, length)), color
        if pose.parent in origins:
            yield from _arrow(rod, cone, pose.origin, origins[pose.parent], length)


def _arrow(
    rod: Surface, cone: Surface, start: Vector, end: Vector, length: float
) -> Iterator[tuple[Surface, str]]:
    """From a frame to its parent, with a head in the middle if there is room for one."""
    way = math.dist(start, end)
    if way < 1e-9:
        return
    x, y, z = ((b - a) / way for a, b in zip(start, end, strict=True))
    turn, middle = quaternion_from_z((x, y, z)), along(start, (x, y, z), way / 2)
    thick = style.ARROW_RADIUS * length
    yield rod.placed(middle, turn, (thick, thick, way)), style.ARROW_COLOR
    if way > 2 * style.HEAD_LENGTH * length:
        thick, long = style.HEAD_RADIUS * length, style.HEAD_LENGTH * length
        yield cone.placed(middle, turn, (thick, thick, long)), style.ARROW_COLOR


def _surface(placed: PlacedSolid) -> Surface:
    return surface_of(placed.solid.shape).placed(*placed.pose())


_FINER = 2
"Pixels that are computed, in each direction, for one that is kept: edges without steps."
_BAND = 64
"So many rows are made at a time: a whole picture at once would take hundreds of megabytes."
_LINE = 1.2
"Width of a line of the grid [px]."
_STROKE = 2.4
"Width of a line of marks [px]."


def scene_pixels(scene: Scene, *, size: Point, scale: int = 1) -> Pixels:
    """The scene without names, on a ground that is seen through.

    Args:
        scene: What to draw.
        size: Width and height of the picture [px].
        scale: Pixels that are made for one of the picture, in each direction.

    Returns:
        Red, green, blue, opacity; shape (height * scale, width * scale, 4).
    """
    parts = scene_parts(scene)
    fineness, height = _FINER * scale, round(size[1] * scale)
    bands = []
    for top in range(0, height, _BAND):
        rows = (_FINER * top, _FINER * min(top + _BAND, height))
        eye = Eye(scene.stage.camera, size, fineness, rows)
        _draw(parts, eye, line_width=_LINE * fineness)
        bands.append(eye.pixels(_FINER))
    return np.concatenate(bands)


def _draw(parts: SceneParts, eye: Eye, *, line_width: float) -> None:
    for segments, color in parts.grid:
        eye.lines(eye.solid, segments, width=line_width, color=color)
    for surface, color in parts.opaque:
        eye.surface(eye.solid, surface, color)
    _draw_marks(parts, eye, eye.solid, shining=False)
    eye.lay(eye.solid, np.where(eye.solid.nearness > 0.0, 1.0, 0.0))
    if parts.frames or parts.dots or parts.strokes:
        _draw_frames(parts, eye)
    for surface, color, alpha in parts.veils:
        eye.lay_veil(surface, color, alpha)


def _draw_frames(parts: SceneParts, eye: Eye) -> None:
    frames = eye.layer()
    for surface, color in parts.frames:
        eye.surface(frames, surface, color)
    _draw_marks(parts, eye, frames, shining=True)
    is_before = frames.nearness >= eye.solid.nearness
    eye.lay(frames, np.where(is_before, 1.0, style.GHOST) * (frames.nearness > 0.0))
    np.maximum(eye.solid.nearness, frames.nearness, out=eye.solid.nearness)


def _draw_marks(parts: SceneParts, eye: Eye, layer: Layer, *, shining: bool) -> None:
    for surface, color, shines in parts.dots:
        if shines is shining:
            eye.surface(layer, surface, color)
    for segments, color, shines in parts.strokes:
        if shines is shining:
            eye.lines(layer, segments, width=_STROKE * eye.fineness, color=color)
