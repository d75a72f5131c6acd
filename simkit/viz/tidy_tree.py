"""Where the nodes of a tree go: parents above the middle of their children, nothing on top of anything.

Source: Reingold and Tilford 1981, with a breadth for each node.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


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
