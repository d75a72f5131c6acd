from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simkit.viz.tree_layout import CardNode, tree_layout

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
