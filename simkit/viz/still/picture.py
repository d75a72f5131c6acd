"""A still picture of a scene, for reports: the pixels of the scene, names, and what is wrong."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from simkit.viz.draw.drawing import Drawing, Label, Point, Polyline, Shape
from simkit.viz.draw.figure import png_bytes
from simkit.viz.draw.files import few_colored_png
from simkit.viz.draw.letters import abbreviated, label_places, text_width, wrapped
from simkit.viz.page.html import png_image
from simkit.viz.page.scene_data import MOST_NAMES, grid_note, scene_summary
from simkit.viz.stage.camera import on_paper
from simkit.viz.stage.scene import LONGEST, Scene
from simkit.viz.stage.style import SKY
from simkit.viz.still.scene_raster import scene_pixels

SIZE: Final[Point] = (720.0, 450.0)
"""Width and height of the picture, without the lines below it [px]."""
_INK, _GREY, _PROBLEM = "#1d2733", "#5b6b7d", "#a11a12"
_NAME_SIZE, _NAME_HEIGHT = 12.5, 17.0
_ROW = 18.0


def still_png(scene: Scene, *, scale: int = 2) -> bytes:
    """The picture as a PNG file.

    Args:
        scene: What it shows.
        scale: Pixels of the file per pixel of the page.
    """
    pixels = scene_pixels(scene, size=SIZE, scale=scale)
    return png_bytes(still_drawing(scene), scale=scale, pixels=pixels)


def still_image(scene: Scene) -> str:
    """The picture as an element of HTML, with words for those who do not see it."""
    data = few_colored_png(still_png(scene, scale=1))
    return png_image(data, f"{scene.window.title}: {scene_summary(scene)}")


def still_drawing(scene: Scene) -> Drawing:
    """What is written on the picture and below it."""
    notes = [
        (line, color)
        for texts, color in (((scene.tf.error, *scene.problems), _PROBLEM), (scene.notes, _GREY))
        for text in texts
        for line in _lines(text)
    ]
    rows = [
        Label(place=(14, SIZE[1] + _ROW * (row + 0.9)), text=line, color=color, size=12)
        for row, (line, color) in enumerate(notes)
    ]
    names = _names(scene) if scene.displays.tf else ()
    return Drawing(
        title=f"{scene.window.title}: {scene_summary(scene)}",
        description=" ".join([scene_summary(scene), *scene.problems, *scene.notes]),
        size=(SIZE[0], SIZE[1] + (_ROW * len(rows) + 10 if rows else 0)),
        background=SKY,
        shapes=(*names, *_corners(scene), *rows),
    )


def _corners(scene: Scene) -> Iterator[Label]:
    fixed = scene.headline or f"Fixed Frame: {abbreviated(scene.tf.fixed_frame, LONGEST)}"
    yield Label(place=(14, 24), text=fixed, color=_GREY, size=12, halo=SKY)
    if scene.displays.grid:
        note = grid_note(scene.stage)
        yield Label(place=(14, SIZE[1] - 12), text=note, color=_GREY, size=12, halo=SKY)


def _lines(text: str) -> list[str]:
    words = " ".join(abbreviated(word, LONGEST + 4) for word in text.split())
    return wrapped(words, size=12, width=SIZE[0] - 28)


def _names(scene: Scene) -> Iterator[Shape]:
    seen = [(pose, scene.stage.camera.seen(pose.origin)) for pose in scene.tf.poses[:MOST_NAMES]]
    named = [(pose, on_paper(at, SIZE)) for pose, at in seen if scene.stage.camera.is_before(at)]
    labels = [abbreviated(pose.name, LONGEST) for pose, _ in named]
    widths = [text_width(label, _NAME_SIZE) for label in labels]
    anchors = [anchor for _, anchor in named]
    places = label_places(anchors, widths=widths, height=_NAME_HEIGHT, size=SIZE)
    for (pose, anchor), label, place, width in zip(named, labels, places, widths, strict=True):
        if place is None:
            continue
        if abs(place[1] - anchor[1]) > 1.2 * _NAME_HEIGHT:
            end = (place[0] - 2 if place[0] > anchor[0] else place[0] + width + 2, place[1])
            yield Polyline(points=(anchor, end), color=_GREY, width=0.8)
        yield Label(
            place=(place[0], place[1] + 0.36 * _NAME_SIZE),
            text=label,
            color=_INK,
            size=_NAME_SIZE,
            bold=pose.name == scene.tf.fixed_frame,
            halo=SKY,
        )
