"""Where each node of a tree is drawn, and where its facts: rectangles, none on top of another.

Parents stand above the middle of their children.

Source: Reingold and Tilford 1981, with a breadth for each node.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from simkit.viz.draw.drawing import Point
from simkit.viz.draw.letters import abbreviated, text_width

NAME_SIZE: Final = 13.5
FACT_SIZE: Final = 11.0
FACT_HEIGHT: Final = 15.0
CARD_PADDING: Final = 9.0
LONGEST: Final = 44
"""Letters of a name that are shown; of a longer one the middle is left out."""

_NODE_HEIGHT = 30.0
_ARROW = 18.0
_BEND_DOWN, _BEND_SIDEWAYS = 28.0, 56.0
_PADDING, _GAP = 18.0, 22.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Rectangle:
    """Room for one thing."""

    left: float
    """Left edge [px]."""
    top: float
    """Upper edge [px]."""
    width: float
    """Width [px]."""
    height: float
    """Height [px]."""

    def point(self, x: float, y: float) -> Point:
        """The point at a share of the width and of the height; (0, 0) is the upper left corner."""
        return (self.left + x * self.width, self.top + y * self.height)

    def moved(self, by: Point) -> Rectangle:
        """The same room elsewhere."""
        left, top = self.left + by[0], self.top + by[1]
        return Rectangle(left=left, top=top, width=self.width, height=self.height)


@dataclass(frozen=True, slots=True, kw_only=True)
class CardNode:
    """A node of a tree, with the facts on the line to its parent."""

    name: str
    """Its name."""
    parent: int | None
    """Number of its parent in the tree; None for the root."""
    facts: tuple[tuple[str, str], ...] = ()
    """Names and values; none for the root."""
    is_dashed: bool = False
    """Whether the line to its parent is broken."""
    is_echo: bool = False
    """Whether it stands for a node that is drawn elsewhere too."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TreeLayout:
    """A tree with a place for everything in it."""

    nodes: tuple[CardNode, ...]
    """The tree: the root first, a parent before its children."""
    frames: tuple[Rectangle, ...]
    """Room of each node."""
    cards: tuple[Rectangle | None, ...]
    """Room for the facts of each node; None where there are none."""
    is_sideways: bool
    """Whether the tree grows to the right; else downwards."""
    size: Point
    """Width and height of the whole, with a border [px]."""


def tree_layout(nodes: Sequence[CardNode], *, is_sideways: bool) -> TreeLayout:
    """Places for a tree.

    Args:
        nodes: The tree: the root first, a parent before its children.
        is_sideways: Let it grow to the right rather than downwards.
    """
    parents = [node.parent for node in nodes]
    frames = [(_name_width(node), _NODE_HEIGHT) for node in nodes]
    cards = [_card_size(node) for node in nodes]
    along, across = (0, 1) if is_sideways else (1, 0)
    breadths = [max(f[across], c[across]) for f, c in zip(frames, cards, strict=True)]
    middles = [_PADDING + m for m in tidy_middles(parents, breadths=breadths, gap=_GAP)]
    card_starts, frame_starts = _starts(
        depths(parents),
        cards=[card[along] for card in cards],
        frames=[frame[along] for frame in frames],
        bend=_BEND_SIDEWAYS if is_sideways else _BEND_DOWN,
    )
    boxes = [
        _placed(start, middle, size, is_sideways=is_sideways)
        for start, middle, size in zip(frame_starts, middles, frames, strict=True)
    ]
    facts = [
        _placed(start, middle, size, is_sideways=is_sideways) if size[0] else None
        for start, middle, size in zip(card_starts, middles, cards, strict=True)
    ]
    rooms = [*boxes, *(card for card in facts if card is not None)]
    return TreeLayout(
        nodes=tuple(nodes),
        frames=tuple(boxes),
        cards=tuple(facts),
        is_sideways=is_sideways,
        size=(
            max(room.left + room.width for room in rooms) + _PADDING,
            max(room.top + room.height for room in rooms) + _PADDING,
        ),
    )


def column_of(node: CardNode) -> float:
    """From the left edge of the names of a node's facts to that of their values [px]."""
    return max(text_width(name, FACT_SIZE) for name, _ in node.facts) + 10


def _name_width(node: CardNode) -> float:
    return max(text_width(abbreviated(node.name, LONGEST), NAME_SIZE) + 28, 64.0)


def _card_size(node: CardNode) -> Point:
    if not node.facts:
        return (0.0, 0.0)
    values = [text_width(abbreviated(v, LONGEST), FACT_SIZE) for _, v in node.facts]
    width = column_of(node) + max(values) + 2 * CARD_PADDING
    return (width, len(node.facts) * FACT_HEIGHT + 10)


def _starts(
    steps: Sequence[int], *, cards: Sequence[float], frames: Sequence[float], bend: float
) -> tuple[list[float], list[float]]:
    """Where the card and the frame of each node begin along the tree; a level begins together."""
    card_starts, frame_starts = [_PADDING], [_PADDING]
    for depth in range(max(steps) + 1):
        level = [node for node, step in enumerate(steps) if step == depth]
        frame_start = frame_starts[depth]
        if depth:
            frame_start = card_starts[depth] + max(cards[node] for node in level) + _ARROW
            frame_starts[depth] = frame_start
        following = frame_start + max(frames[node] for node in level) + bend
        card_starts.append(following)
        frame_starts.append(following)
    return [card_starts[step] for step in steps], [frame_starts[step] for step in steps]


def _placed(start: float, middle: float, size: Point, *, is_sideways: bool) -> Rectangle:
    width, height = size
    if is_sideways:
        return Rectangle(left=start, top=middle - height / 2, width=width, height=height)
    return Rectangle(left=middle - width / 2, top=start, width=width, height=height)


@dataclass(slots=True)
class _Outline:
    """The left and right edge of a subtree at each depth, seen from the middle of its root."""

    left: list[float]
    right: list[float]


def depths(parents: Sequence[int | None]) -> list[int]:
    """Steps from the root to each node.

    Args:
        parents: Parent of each node, by number; a parent comes before its children.
    """
    found: list[int] = []
    for parent in parents:
        found.append(0 if parent is None else found[parent] + 1)
    return found


def tidy_middles(
    parents: Sequence[int | None], *, breadths: Sequence[float], gap: float
) -> list[float]:
    """Middle of each node across the tree; the outermost edge is at 0.

    Args:
        parents: Parent of each node, by number; a parent comes before its children, the root first.
        breadths: Room that each node needs across the tree.
        gap: Least distance of neighbours of one depth.
    """
    children: list[list[int]] = [[] for _ in parents]
    for node, parent in enumerate(parents):
        if parent is not None:
            children[parent].append(node)
    outlines: dict[int, _Outline] = {}
    offsets = [0.0] * len(parents)
    for node in reversed(range(len(parents))):
        row = [outlines.pop(child) for child in children[node]]
        places = _side_by_side(row, gap)
        middle = (places[0] + places[-1]) / 2 if places else 0.0
        for child, place in zip(children[node], places, strict=True):
            offsets[child] = place - middle
        outlines[node] = _joined(breadths[node] / 2, row, [place - middle for place in places])
    middles: list[float] = []
    for node, parent in enumerate(parents):
        start = -min(outlines[0].left) if parent is None else middles[parent]
        middles.append(start + offsets[node])
    return middles


def _side_by_side(row: Sequence[_Outline], gap: float) -> list[float]:
    """Middles of subtrees that stand as close as `gap` allows."""
    places: list[float] = []
    edge: list[float] = []
    for outline in row:
        shared = zip(edge, outline.left, strict=False)
        place = max((right + gap - left for right, left in shared), default=0.0)
        places.append(place)
        edge[: len(outline.right)] = [place + right for right in outline.right]
    return places


def _joined(half: float, row: Sequence[_Outline], places: Sequence[float]) -> _Outline:
    """Outline of a node of half that breadth above its subtrees."""
    height = max((len(outline.left) for outline in row), default=0)
    left, right = [0.0] * height, [0.0] * height
    for outline, place in zip(reversed(row), reversed(places), strict=True):
        left[: len(outline.left)] = [place + edge for edge in outline.left]
    for outline, place in zip(row, places, strict=True):
        right[: len(outline.right)] = [place + edge for edge in outline.right]
    return _Outline([-half, *left], [half, *right])
