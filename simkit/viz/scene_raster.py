"""A scene as pixels: the same things in the same light as in the view to turn."""

from __future__ import annotations

import numpy as np

from simkit.viz import scene_style as style
from simkit.viz.draw.drawing import Point
from simkit.viz.eye import Eye, Pixels
from simkit.viz.raster import Layer
from simkit.viz.scene import Scene
from simkit.viz.scene_parts import SceneParts, scene_parts

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
    for start, end, color in parts.lines:
        eye.line(eye.solid, start, end, width=line_width, color=color)
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
