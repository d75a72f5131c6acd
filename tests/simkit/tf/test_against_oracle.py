"""Random trees, times and chains against an oracle of 4x4 matrices."""

from __future__ import annotations

import itertools
import math
import random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simkit.tf.errors import TransformException

SETTINGS = settings(max_examples=60, derandomize=True, database=None)


def rotation(rng):
    values = [rng.gauss(0.0, 1.0) for _ in range(4)]
    norm = math.sqrt(sum(v * v for v in values))
    return tuple(v / norm for v in values)


def fill(tools, seed):
    """The same random tree, with every frame known from 0.5 to 9.5 s, in both."""
    rng = random.Random(seed)
    tree, oracle = tools.Tree(), tools.Oracle()
    count = rng.randint(2, 12)
    for i in range(1, count):
        stamps = sorted({0.5, 9.5, *(round(rng.uniform(0.6, 9.4), 3) for _ in range(6))})
        parent = f"f{rng.randrange(i)}"
        for t in stamps:
            xyz, q = tuple(rng.uniform(-5, 5) for _ in range(3)), rotation(rng)
            assert tree.put(parent, f"f{i}", t, xyz, q)
            oracle.put(parent, f"f{i}", t, xyz, q)
    return tree, oracle, [f"f{i}" for i in range(count)], rng


def as_matrix(tools, transform):
    return tools.matrix(transform.translation, transform.rotation)


@SETTINGS
@given(st.integers(0, 10**6))
def test_lookup(tools, seed):
    tree, oracle, frames, rng = fill(tools, seed)
    for _ in range(8):
        a, b = rng.choice(frames), rng.choice(frames)
        t = round(rng.uniform(0.5, 9.5), 3)
        found = tree.lookup(a, b, t)
        assert np.allclose(as_matrix(tools, found), oracle.lookup(a, b, t), atol=1e-9)
        assert found.stamp == round(t * 10**9)


@SETTINGS
@given(st.integers(0, 10**6))
def test_lookup_over_a_fixed_frame(tools, seed):
    tree, oracle, frames, rng = fill(tools, seed)
    for _ in range(5):
        a, b, fixed = (rng.choice(frames) for _ in range(3))
        t1, t2 = (round(rng.uniform(0.5, 9.5), 3) for _ in range(2))
        found = tree.full(a, t1, b, t2, fixed)
        expected = oracle.lookup(a, fixed, t1) @ oracle.lookup(fixed, b, t2)
        assert np.allclose(as_matrix(tools, found), expected, atol=1e-9)


@SETTINGS
@given(st.integers(0, 10**6))
def test_there_and_back_is_the_identity(tools, seed):
    tree, _, frames, rng = fill(tools, seed)
    a, b, t = rng.choice(frames), rng.choice(frames), rng.uniform(0.5, 9.5)
    there, back = (as_matrix(tools, tree.lookup(*pair, t)) for pair in ((a, b), (b, a)))
    assert np.allclose(there @ back, np.identity(4), atol=1e-9)


@SETTINGS
@given(st.integers(0, 10**6))
def test_a_way_is_the_product_of_its_parts(tools, seed):
    tree, _, frames, rng = fill(tools, seed)
    a, b, c = (rng.choice(frames) for _ in range(3))
    t = rng.uniform(0.5, 9.5)
    ab, bc, ac = (as_matrix(tools, tree.lookup(*pair, t)) for pair in ((a, b), (b, c), (a, c)))
    assert np.allclose(ab @ bc, ac, atol=1e-9)


@SETTINGS
@given(st.integers(0, 10**6))
def test_latest_is_the_lookup_at_the_latest_common_time(tools, seed):
    tree, _, frames, rng = fill(tools, seed)
    a, b = rng.sample(frames, 2)
    time = tree.core.latest_common_time(a, b)
    assert tree.core.lookup(a, b) == tree.core.lookup(a, b, time=time)


@SETTINGS
@given(st.integers(0, 10**6), st.floats(-1.0, 12.0))
def test_can_transform_is_whether_lookup_answers(tools, seed, t):
    tree, _, frames, rng = fill(tools, seed)
    tree.put("other", "island", 1.0)
    t = max(t, 1e-9)
    for _ in range(5):
        a, b = (rng.choice([*frames, "other", "island", "nobody"]) for _ in range(2))
        possible, reason = tree.core.can_transform(a, b, time=round(t * 10**9))
        if possible:
            tree.lookup(a, b, t)
            assert reason == ""
            continue
        with pytest.raises(TransformException) as caught:
            tree.lookup(a, b, t)
        if "nobody" not in (a, b):
            assert reason == str(caught.value)


@pytest.mark.parametrize("seed", range(20))
def test_between_two_stamps_a_frame_moves_evenly(tools, seed):
    rng = random.Random(seed)
    tree = tools.Tree()
    start, end = rotation(rng), rotation(rng)
    tree.put("w", "a", 1.0, (0, 0, 0), start)
    tree.put("w", "a", 2.0, (8, 0, 0), end)
    steps = [as_matrix(tools, tree.lookup("w", "a", 1.0 + k / 8)) for k in range(9)]
    turns = [np.linalg.inv(p)[:3, :3] @ q[:3, :3] for p, q in itertools.pairwise(steps)]
    for turn in turns:
        assert np.allclose(turn, turns[0], atol=1e-9)
    assert [step[0, 3] for step in steps] == pytest.approx(range(9))
