"""The way from a source to a target: its frames, and what adds up on it."""

from __future__ import annotations

import itertools
import math
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simkit.tf.errors import ConnectivityException, LookupException, TransformException
from simkit.tf.path import climbed_between, transform_between


def chain(tree, target, source, fixed, time=0):
    return tree.core.chain(target, source, target_time=time, source_time=time, fixed=fixed)


@pytest.fixture
def branches(tree):
    for parent, child in ("ab", "bc", "ad", "de"):
        tree.put(parent, child)
    return tree


@pytest.mark.parametrize(
    ("way", "expected"),
    [
        ("ccc", ""), ("acc", "cba"), ("cac", "abc"), ("aca", "cba"), ("caa", "abc"),
        ("cec", "edabc"), ("cea", "edabc"), ("cee", "edabc"),
    ],
)  # fmt: skip
def test_chain_over_a_fixed_frame(branches, way, expected):
    assert chain(branches, *way) == list(expected)


@pytest.mark.parametrize(
    ("target", "source", "expected"),
    [("e", "c", "cbade"), ("c", "e", "edabc"), ("a", "e", "eda"), ("e", "a", "ade"), ("e", "d", "de"), ("d", "e", "ed")],
)  # fmt: skip
def test_walk_over_branches(branches, target, source, expected):
    assert chain(branches, target, source, target) == list(expected)
    assert chain(branches, target, source, source) == list(expected)


def test_walk_along_a_line(tree):
    tree.chain_of(*"abcde", step=(1, 0, 0))
    assert chain(tree, "a", "e", "a") == list("edcba")
    assert chain(tree, "e", "a", "a") == list("abcde")


def test_walk_below_the_root(branches):
    branches.put("w", "a")
    assert chain(branches, "e", "c", "e") == list("cbade")


def test_no_way(branches):
    branches.put("x", "y")
    with pytest.raises(ConnectivityException):
        chain(branches, "a", "y", "a")
    with pytest.raises(LookupException):
        chain(branches, "a", "nope", "a")


# -- a way that is kept against the tree climbed link by link

FRAMES = "abcdefgh"


def asked(question, core, target, source, time):
    """The answer of a question, or the error's words."""
    numbers = [core.frames.number(name) for name in (target, source)]
    try:
        return question(core.frames, *numbers, time=time)
    except TransformException as error:
        return f"{type(error).__name__}: {error}"


@settings(max_examples=150, derandomize=True, database=None)
@given(st.integers(0, 10**6))
def test_a_kept_way_answers_as_the_tree_that_is_climbed(tools, seed):
    rng = random.Random(seed)
    tree = tools.Tree(cache_time=2.0)
    static = {frame for frame in FRAMES if rng.random() < 0.4}
    order = list(FRAMES)
    for step in range(60):
        rank = rng.randrange(1, len(order))
        # Now and then a frame changes its parent, also to one below it: a loop.
        parents = order[:rank] if rng.random() < 0.97 else order
        child, q = order[rank], [rng.gauss(0, 1) for _ in range(4)]
        norm = math.sqrt(sum(c * c for c in q))
        habitual = order[(rank * 7 + seed) % rank]
        parent = habitual if rng.random() < 0.95 else rng.choice(parents)
        xyz = tuple(rng.uniform(-1, 1) for _ in range(3))
        now = step * 0.1 - (rng.random() < 0.1)
        tree.put(parent, child, now, xyz, [c / norm for c in q], static=child in static)
        if rng.random() < 0.02:
            tree.core.clear()
        for _ in range(6):
            target, source = rng.choice(order), rng.choice(order)
            time = 0 if rng.random() < 0.3 else round((now - rng.uniform(-0.1, 2.0)) * 1e9)
            found = asked(transform_between, tree.core, target, source, time)
            expected = asked(climbed_between, tree.core, target, source, time)
            if isinstance(expected, str):
                assert found == expected
                continue
            assert found.stamp == expected.stamp
            assert found.translation == pytest.approx(expected.translation, abs=1e-12)
            assert found.rotation == pytest.approx(expected.rotation, abs=1e-12)


def test_without_static_links_a_kept_way_is_equal_to_the_last_bit(tree):
    rng = random.Random(3)
    for parent, child in ("ab", "bc", "cd", "ae", "ef"):
        for t in (1, 2, 3):
            angle = rng.uniform(-3, 3)
            q = (0.0, math.sin(angle / 2), 0.0, math.cos(angle / 2))
            tree.put(parent, child, t, [rng.uniform(-1, 1) for _ in range(3)], q)
    table = tree.core.frames
    for target, source in itertools.permutations("abcdef", 2):
        for time in (0, 10**9, 1_234_567_890, 2_999_999_999):
            numbers = (table.number(target), table.number(source))
            kept = transform_between(table, *numbers, time=time)
            assert table.paths[numbers] is not None
            assert kept == climbed_between(table, *numbers, time=time)


def test_a_static_link_that_is_sent_anew_moves_what_lies_behind_it(tree):
    tree.put("a", "b", static=True, xyz=(1, 0, 0))
    tree.put("b", "c", static=True, xyz=(1, 0, 0))
    assert tree.lookup("a", "c").translation == (2, 0, 0)
    tree.put("b", "c", static=True, xyz=(5, 0, 0))
    assert tree.lookup("a", "c").translation == (6, 0, 0)
    tree.put("x", "c", static=True)
    with pytest.raises(ConnectivityException):
        tree.lookup("a", "c")
