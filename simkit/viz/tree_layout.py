"""Where each frame of a tree is drawn, and where its facts: rectangles, none on top of another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from simkit.viz.drawing import Point
from simkit.viz.forest import Tree, TreeNode
from simkit.viz.frames_dot import edge_facts
from simkit.viz.letters import shortened, text_width
from simkit.viz.tidy_tree import depths, tidy_middles

NAME_SIZE: Final = 13.5
FACT_SIZE: Final = 11.0
FACT_HEIGHT: Final = 15.0
CARD_PADDING: Final = 9.0
COLUMN: Final = text_width("Most recent transform", FACT_SIZE) + 10
"""From the left edge of the facts' names to that of their values [px]."""
LONGEST: Final = 44
"""Letters of a name that are shown; of a longer one the middle is left out."""

_FRAME_HEIGHT = 30.0
_CARD_HEIGHT = 5 * FACT_HEIGHT + 10
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
class TreeLayout:
    """A tree with a place for everything in it."""

    tree: Tree
    """The tree."""
    frames: tuple[Rectangle, ...]
    """Room of each node's frame."""
    cards: tuple[Rectangle | None, ...]
    """Room for the facts of each node; None where there are none."""
    is_sideways: bool
    """Whether the tree grows to the right; else downwards."""
    size: Point
    """Width and height of the whole, with a border [px]."""


def tree_layout(tree: Tree, *, is_sideways: bool) -> TreeLayout:
    """Places for a tree.

    Args:
        tree: The tree.
        is_sideways: Let it grow to the right rather than downwards.
    """
    parents = [node.parent for node in tree.nodes]
    frames = [(_frame_width(node), _FRAME_HEIGHT) for node in tree.nodes]
    cards = [_card_size(node) for node in tree.nodes]
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
        tree=tree,
        frames=tuple(boxes),
        cards=tuple(facts),
        is_sideways=is_sideways,
        size=(
            max(room.left + room.width for room in rooms) + _PADDING,
            max(room.top + room.height for room in rooms) + _PADDING,
        ),
    )


def _frame_width(node: TreeNode) -> float:
    return max(text_width(shortened(node.name, LONGEST), NAME_SIZE) + 28, 64.0)


def _card_size(node: TreeNode) -> Point:
    if node.report is None:
        return (0.0, 0.0)
    values = [text_width(shortened(v, LONGEST), FACT_SIZE) for _, v in edge_facts(node.report)]
    return (COLUMN + max(values) + 2 * CARD_PADDING, _CARD_HEIGHT)


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
