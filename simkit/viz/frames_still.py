"""A still picture of frames in space, for reports: the same scene as the view to turn."""

from __future__ import annotations

import math
from collections.abc import Iterator

from simkit.tf.transform import Vector
from simkit.viz.camera import focal_length, on_paper
from simkit.viz.drawing import Area, Drawing, Group, Line, Point, Shape, Text
from simkit.viz.frames_page import LONGEST, MOST_NAMES, TITLE, grid_note, summary
from simkit.viz.label_places import label_places
from simkit.viz.letters import shortened, text_width, wrapped
from simkit.viz.stage import Stage
from simkit.viz.tf_scene import FramePose, TfScene

SIZE = (720.0, 450.0)
_PAPER, _INK, _GREY, _GRID, _LINK = "#ffffff", "#1d2733", "#5b6b7d", "#d5dde6", "#b3801a"
_AXES = ("#e03b3b", "#2ba84a", "#3f82f2")
_PROBLEM = "#a11a12"
_NAME_SIZE, _NAME_HEIGHT = 12.5, 17.0
_ROW = 18.0


def draw_scene(scene: TfScene, stage: Stage) -> Drawing:
    """The picture of a scene.

    Args:
        scene: The frames.
        stage: The grid and the camera.
    """
    still = _Still(scene, stage)
    notes = [line for text in (scene.error, *scene.problems) if text for line in _lines(text)]
    rows = [
        Text(place=(14, SIZE[1] + _ROW * (row + 0.8)), text=line, color=_PROBLEM, size=12)
        for row, line in enumerate(notes)
    ]
    grid = Text(place=(14, SIZE[1] - 12), text=grid_note(stage), color=_GREY, size=12, halo=_PAPER)
    fixed = Text(
        place=(14, 24),
        text=f"Fixed Frame: {shortened(scene.fixed_frame, LONGEST)}",
        color=_GREY,
        size=12,
        halo=_PAPER,
    )
    return Drawing(
        title=TITLE,
        description=" ".join([summary(scene), *scene.problems]),
        size=(SIZE[0], SIZE[1] + (_ROW * len(rows) + 10 if rows else 0)),
        background=_PAPER,
        shapes=(*still.grid(), *still.links(), *still.axes(), *still.names(), grid, fixed, *rows),
    )


def _lines(text: str) -> list[str]:
    words = " ".join(shortened(word, LONGEST + 4) for word in text.split())
    return wrapped(words, size=12, width=SIZE[0] - 28)


class _Still:
    def __init__(self, scene: TfScene, stage: Stage) -> None:
        self._scene, self._stage, self._camera = scene, stage, stage.camera
        self._seen = {pose.name: self._camera.seen(pose.origin) for pose in scene.poses}

    def grid(self) -> Iterator[Shape]:
        cell, (x0, x1), (y0, y1) = self._stage.cell, self._stage.grid_x, self._stage.grid_y
        columns = [
            (x, ((x * cell, y0 * cell, 0.0), (x * cell, y1 * cell, 0.0))) for x in range(x0, x1 + 1)
        ]
        rows = [
            (y, ((x0 * cell, y * cell, 0.0), (x1 * cell, y * cell, 0.0))) for y in range(y0, y1 + 1)
        ]
        for number, (start, end) in [*columns, *rows]:
            seen = self._camera.seen(start), self._camera.seen(end)
            yield from self._line(*seen, color=_GRID, width=1.0 if number else 2.0)

    def links(self) -> Iterator[Shape]:
        """From each frame to its parent."""
        for pose in self._scene.poses:
            if pose.parent in self._seen:
                child, parent = self._seen[pose.name], self._seen[pose.parent]
                yield from self._line(child, parent, color=_LINK, width=1.4)
                if self._camera.is_before(child) and self._camera.is_before(parent):
                    yield from _head(on_paper(child, SIZE), on_paper(parent, SIZE))

    def axes(self) -> Iterator[Shape]:
        """The axes of each frame, far ones first."""
        for pose in sorted(self._scene.poses, key=lambda pose: -self._seen[pose.name][2]):
            yield Group(title=pose.name, shapes=tuple(self._axes_of(pose)))

    def names(self) -> Iterator[Shape]:
        named = self._scene.poses[:MOST_NAMES]
        poses = [pose for pose in named if self._camera.is_before(self._seen[pose.name])]
        labels = [shortened(pose.name, LONGEST) for pose in poses]
        anchors = [on_paper(self._seen[pose.name], SIZE) for pose in poses]
        widths = [text_width(label, _NAME_SIZE) for label in labels]
        places = label_places(anchors, widths=widths, height=_NAME_HEIGHT, size=SIZE)
        for pose, label, anchor, place, width in zip(
            poses, labels, anchors, places, widths, strict=True
        ):
            if abs(place[1] - anchor[1]) > 1.2 * _NAME_HEIGHT:
                end = (place[0] - 2 if place[0] > anchor[0] else place[0] + width + 2, place[1])
                yield Line(points=(anchor, end), color=_GREY, width=0.8)
            yield Text(
                place=(place[0], place[1] + 0.36 * _NAME_SIZE),
                text=label,
                color=_INK,
                size=_NAME_SIZE,
                bold=pose.name == self._scene.fixed_frame,
                halo=_PAPER,
            )

    def _axes_of(self, pose: FramePose) -> Iterator[Line]:
        length, origin = self._stage.axis_length, self._seen[pose.name]
        tips: list[tuple[Vector, str]] = []
        for axis, color in zip(pose.axes, _AXES, strict=True):
            x, y, z = (o + length * a for o, a in zip(pose.origin, axis, strict=True))
            tips.append((self._camera.seen((x, y, z)), color))
        width = min(max(0.09 * length * focal_length(SIZE) / origin[2], 2.0), 9.0)
        for tip, color in sorted(tips, key=lambda tip: -tip[0][2]):
            yield from self._line(origin, tip, color=color, width=width)

    def _line(self, start: Vector, end: Vector, *, color: str, width: float) -> Iterator[Line]:
        part = self._camera.clipped(start, end)
        if part is not None:
            points = (on_paper(part[0], SIZE), on_paper(part[1], SIZE))
            yield Line(points=points, color=color, width=width)


def _head(start: Point, end: Point) -> Iterator[Shape]:
    """An arrow's head in the middle of a line, if the line is long enough."""
    length = math.dist(start, end)
    if length < 28:
        return
    ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    x, y = (start[0] + end[0]) / 2 + 5 * ux, (start[1] + end[1]) / 2 + 5 * uy
    left = (x - 10 * ux - 4 * uy, y - 10 * uy + 4 * ux)
    right = (x - 10 * ux + 4 * uy, y - 10 * uy - 4 * ux)
    yield Area(points=((x, y), left, right), fill=_LINK)
