"""Names beside points, none on top of another: each goes to the first free place near its point."""

from __future__ import annotations

from collections.abc import Sequence

from simkit.viz.drawing import Point

_BELOW = 10.0
"A name is a little below its point, where no axis that points up hides it [px]."
_STEPS = (0, -1, 1, -2, 2, -3, 3, -4, 4, 5, 6, 7, 8)
"Tried places, in lines below the point."


def label_places(
    anchors: Sequence[Point], *, widths: Sequence[float], height: float, size: Point
) -> list[Point | None]:
    """Left end of each name's middle line [px]; None for a name that has no room.

    Args:
        anchors: The points.
        widths: Room for each name [px].
        height: Room for a line [px].
        size: Width and height of the picture, which no name should leave.
    """
    taken: list[tuple[float, float, float]] = []
    places: list[Point | None] = []
    for (x, y), width in zip(anchors, widths, strict=True):
        right, left = x + 9, x - 9 - width
        sides = (right, left) if right + width <= size[0] else (left, right)
        tried = [(side, y + _BELOW + step * height) for step in _STEPS for side in sides]
        seen = [place for place in tried if height / 2 <= place[1] <= size[1] - height / 2]
        free = (place for place in seen if not _hits(place, width, height, taken))
        place = next(free, None)
        if place is not None:
            taken.append((*place, width))
        places.append(place)
    return places


def _hits(
    place: Point, width: float, height: float, taken: Sequence[tuple[float, float, float]]
) -> bool:
    left, middle = place
    return any(
        left < other_left + other_width
        and other_left < left + width
        and abs(middle - other_middle) < height
        for other_left, other_middle, other_width in taken
    )
