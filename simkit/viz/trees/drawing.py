"""One tree as shapes: a box for each node, its facts on the line to its parent; and what pages of trees share."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.viz.draw.drawing import (
    Area,
    Curve,
    Group,
    Label,
    Point,
    Polyline,
    RoundedBox,
    Shape,
)
from simkit.viz.draw.files import DrawnPicture, Formats
from simkit.viz.draw.letters import abbreviated
from simkit.viz.trees.layout import (
    CARD_PADDING,
    FACT_HEIGHT,
    FACT_SIZE,
    LONGEST,
    NAME_SIZE,
    CardNode,
    Rectangle,
    TreeLayout,
    column_of,
)

PAPER, INK, GREY = "#ffffff", "#1d2733", "#5b6b7d"
MARGIN, SMALL = 18.0, 12.5
"""Border of a page, and size of its small letters [px]."""
READABLE_WIDTH = 1000.0
"""Up to this width a page of a notebook shows trees that grow downwards [px]."""
_LINE, _CARD, _CARD_EDGE = "#7d8fa3", "#fbfcfe", "#ccd6e2"
_FRAME, _FRAME_EDGE, _ROOT = "#e6f0fd", "#3a6fb0", "#1f4f8f"
_LOOP, _LOOP_INK = "#fdeceb", "#b3261e"


class TreePicture(DrawnPicture):
    """A tree as a picture, and in graphviz' language."""

    def to_dot(self) -> str:
        """The tree in graphviz' language."""
        raise NotImplementedError

    def formats(self) -> Formats:
        """`.svg`, `.pdf`, `.png` and `.gv`."""
        return {".gv": self.to_dot, **super().formats()}


def dot_quoted(text: str) -> str:
    """A text between quotes, for graphviz."""
    return f'"{dot_escaped(text)}"'


def dot_escaped(text: str) -> str:
    """A text that is to stand between quotes, for graphviz."""
    return text.replace("\\", "\\\\").replace('"', '\\"')


def key_of_broken_lines(place: Point, text: str) -> list[Shape]:
    """What a broken line means, below the trees.

    Args:
        place: Left end of the key [px].
        text: What it says.
    """
    x, y = place
    return [
        Polyline(points=((x, y - 4), (x + 32, y - 4)), color=GREY, width=1.6, dashed=True),
        Label(place=(x + 42, y), text=text, color=GREY, size=SMALL - 1),
    ]


def tree_shapes(layout: TreeLayout, origin: Point) -> Iterator[Shape]:
    """The shapes of a tree: first the lines, then what lies on them.

    Args:
        layout: The tree with its places.
        origin: Upper left corner of the whole [px].
    """
    frames = [room.moved(origin) for room in layout.frames]
    cards = [room.moved(origin) if room else None for room in layout.cards]
    nodes = layout.nodes
    for node, room, card in zip(nodes, frames, cards, strict=True):
        if node.parent is not None:
            way = _Way(is_sideways=layout.is_sideways, is_dashed=node.is_dashed)
            yield from way.between(frames[node.parent], card or room, room)
    for node, room, card in zip(nodes, frames, cards, strict=True):
        if card is not None:
            yield _facts(node, card, "" if node.parent is None else nodes[node.parent].name)
        yield _frame(node, room)


class _Way:
    """Draws the line from a parent over a card to a frame."""

    def __init__(self, *, is_sideways: bool, is_dashed: bool) -> None:
        self._is_sideways = is_sideways
        self._is_dashed = is_dashed

    def between(self, parent: Rectangle, card: Rectangle, frame: Rectangle) -> Iterator[Shape]:
        begin, middle = self._end(parent), self._start(card)
        if self._is_sideways:
            half = (begin[0] + middle[0]) / 2
            pulls = ((half, begin[1]), (half, middle[1]))
        else:
            half = (begin[1] + middle[1]) / 2
            pulls = ((begin[0], half), (middle[0], half))
        yield Curve(points=(begin, *pulls, middle), color=_LINE, width=1.6, dashed=self._is_dashed)
        if card is not frame:
            yield from self._arrow(self._end(card), self._start(frame))

    def _arrow(self, begin: Point, end: Point) -> Iterator[Shape]:
        (x, y), long, half = end, 9.0, 4.0
        if self._is_sideways:
            neck = (x - long, y)
            corners = (end, (x - long, y - half), (x - long, y + half))
        else:
            neck = (x, y - long)
            corners = (end, (x - half, y - long), (x + half, y - long))
        yield Polyline(points=(begin, neck), color=_LINE, width=1.6, dashed=self._is_dashed)
        yield Area(points=corners, fill=_LINE)

    def _start(self, room: Rectangle) -> Point:
        return room.point(0, 0.5) if self._is_sideways else room.point(0.5, 0)

    def _end(self, room: Rectangle) -> Point:
        return room.point(1, 0.5) if self._is_sideways else room.point(0.5, 1)


def _frame(node: CardNode, room: Rectangle) -> Group:
    fill, edge, ink = _FRAME, _FRAME_EDGE, INK
    if node.is_echo:
        fill, edge, ink = _LOOP, _LOOP_INK, _LOOP_INK
    elif node.parent is None:
        fill, edge, ink = _ROOT, _ROOT, PAPER
    x, y = room.point(0.5, 0.5)
    name = Label(
        place=(x, y + 0.36 * NAME_SIZE),
        text=abbreviated(node.name, LONGEST),
        color=ink,
        size=NAME_SIZE,
        align="middle",
    )
    title = f"{node.name}, which is drawn elsewhere too" if node.is_echo else node.name
    return Group(
        title=title,
        shapes=(_box(room, fill, edge, radius=8.0, dashed=node.is_echo), name),
    )


def _facts(node: CardNode, room: Rectangle, parent: str) -> Group:
    left = room.left + CARD_PADDING
    column = column_of(node)
    lines = []
    for row, (name, value) in enumerate(node.facts):
        y = room.top + 5 + FACT_HEIGHT * (row + 0.75)
        shown = abbreviated(value, LONGEST)
        lines.append(Label(place=(left, y), text=name, color=GREY, size=FACT_SIZE))
        lines.append(Label(place=(left + column, y), text=shown, color=INK, size=FACT_SIZE))
    title = f"{parent} -> {node.name}: " + ", ".join(": ".join(fact) for fact in node.facts)
    return Group(title=title, shapes=(_box(room, _CARD, _CARD_EDGE, radius=4.0), *lines))


def _box(
    room: Rectangle, fill: str, edge: str, *, radius: float, dashed: bool = False
) -> RoundedBox:
    return RoundedBox(
        corner=(room.left, room.top),
        size=(room.width, room.height),
        fill=fill,
        edge=edge,
        radius=radius,
        dashed=dashed,
    )
