from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simkit.viz.trees.layout import CardNode, depths, tidy_middles, tree_layout

NAMES = st.text(min_size=1, max_size=80)
FACTS = st.lists(st.tuples(NAMES, NAMES), min_size=1, max_size=7).map(tuple)


@st.composite
def trees(draw):
    nodes = [CardNode(name=draw(NAMES), parent=None)]
    for number in range(1, draw(st.integers(1, 16))):
        parent = draw(st.integers(0, number - 1))
        nodes.append(CardNode(name=draw(NAMES), parent=parent, facts=draw(FACTS)))
    return nodes


@pytest.mark.parametrize("is_sideways", [False, True])
@given(trees())
@settings(max_examples=40)
def test_nothing_lies_on_anything_else(is_sideways, tree):
    layout = tree_layout(tree, is_sideways=is_sideways)
    rooms = [*layout.frames, *(card for card in layout.cards if card)]
    for a, b in combinations(rooms, 2):
        assert (
            a.left + a.width <= b.left + 1e-6
            or b.left + b.width <= a.left + 1e-6
            or a.top + a.height <= b.top + 1e-6
            or b.top + b.height <= a.top + 1e-6
        )


@pytest.mark.parametrize("is_sideways", [False, True])
@given(trees())
@settings(max_examples=40)
def test_everything_lies_inside_and_children_after_parents(is_sideways, tree):
    layout = tree_layout(tree, is_sideways=is_sideways)
    for room in [*layout.frames, *(card for card in layout.cards if card)]:
        assert room.left >= 0
        assert room.top >= 0
        assert room.left + room.width <= layout.size[0]
        assert room.top + room.height <= layout.size[1]
    for node, room, card in zip(tree, layout.frames, layout.cards, strict=True):
        if node.parent is None:
            assert card is None
            continue
        parent = layout.frames[node.parent]
        if is_sideways:
            assert parent.left + parent.width < card.left < card.left + card.width < room.left
        else:
            assert parent.top + parent.height < card.top < card.top + card.height < room.top


GAP = 10.0


@st.composite
def trees(draw):
    """Parents and breadths of the nodes of a tree, parents first."""
    size = draw(st.integers(1, 40))
    parents = [None] + [draw(st.integers(0, node - 1)) for node in range(1, size)]
    breadths = draw(st.lists(st.floats(1, 200), min_size=size, max_size=size))
    return parents, breadths


@given(trees())
def test_neighbours_of_one_depth_keep_their_distance(tree):
    parents, breadths = tree
    middles, steps = tidy_middles(parents, breadths=breadths, gap=GAP), depths(parents)
    for a, b in combinations(range(len(parents)), 2):
        if steps[a] == steps[b]:
            assert abs(middles[a] - middles[b]) >= (breadths[a] + breadths[b]) / 2 + GAP - 1e-6


@given(trees())
def test_parents_are_above_the_middle_of_their_children(tree):
    parents, breadths = tree
    middles = tidy_middles(parents, breadths=breadths, gap=GAP)
    for node in range(len(parents)):
        below = [middles[child] for child, parent in enumerate(parents) if parent == node]
        if below:
            assert middles[node] == pytest.approx((below[0] + below[-1]) / 2, abs=1e-6)
            assert below == sorted(below)


@given(trees())
def test_the_outermost_edge_is_zero(tree):
    parents, breadths = tree
    middles = tidy_middles(parents, breadths=breadths, gap=GAP)
    edges = [middle - breadth / 2 for middle, breadth in zip(middles, breadths, strict=True)]
    assert min(edges) == pytest.approx(0.0, abs=1e-6)


def test_a_long_chain_is_straight():
    size = 3000
    middles = tidy_middles([None, *range(size - 1)], breadths=[8.0] * size, gap=GAP)
    assert set(middles) == {4.0}
    assert depths([None, *range(size - 1)])[-1] == size - 1


def test_a_deep_subtree_slides_under_a_shallow_one():
    #      0
    #   1     2
    #        3 4 5   the wide row below 2 may reach under 1
    middles = tidy_middles([None, 0, 0, 2, 2, 2], breadths=[10.0] * 6, gap=GAP)
    assert middles[2] - middles[1] == 20.0
    assert middles[3] == middles[1]
