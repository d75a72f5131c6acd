"""The latest common time."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simkit.tf.errors import ConnectivityException, LookupException

NS = 1e-9


def common(tree, a, b):
    return tree.core.latest_common_time(a, b)


def test_of_tfs_own_test(tree):
    tree.put("parent", "a", 1_000 * NS)
    tree.put("grandparent", "parent", 2_000 * NS)
    assert common(tree, "a", "grandparent") == 1_000
    with pytest.raises(LookupException):
        common(tree, "a", "not there")
    tree.put("parent", "a", 3_000 * NS)
    assert common(tree, "a", "grandparent") == 2_000
    tree.put("parent", "b", 4_000 * NS)
    tree.put("b", "c", 3_000 * NS)
    tree.put("c", "d", 9_000 * NS)
    tree.put("f", "e", 5_000 * NS)
    assert common(tree, "a", "b") == 3_000
    for pair in (("a", "c"), ("a", "d"), ("b", "c")):
        assert common(tree, *pair) == common(tree, *reversed(pair)) == 3_000
    assert common(tree, "b", "d") == 3_000
    assert common(tree, "e", "f") == common(tree, "f", "e") == 5_000


def test_of_a_frame_with_itself(tree):
    tree.put("w", "a", 3.0)
    tree.put("w", "s", 3.0, static=True)
    assert common(tree, "a", "a") == 3 * 10**9
    assert common(tree, "w", "w") == 0
    assert common(tree, "s", "s") == 0


def test_static_frames_do_not_count(tree):
    tree.put("w", "a", 3.0)
    tree.put("a", "s", 1.0, static=True)
    tree.put("w", "s2", 1.0, static=True)
    assert common(tree, "w", "s") == 3 * 10**9
    assert common(tree, "s2", "w") == 0
    assert tree.lookup("s2", "w").stamp == 0


def test_text_for_an_unknown_frame(tree):
    tree.put("w", "a", 3.0)
    with pytest.raises(LookupException) as caught:
        common(tree, "w", "x")
    assert str(caught.value) == '"x" passed to get_latest_common_time does not exist. '


@st.composite
def forests(draw):
    """Frames f0, f1, ...: each but some has an earlier one as parent; some stamps each."""
    frames = []
    for i in range(draw(st.integers(2, 9))):
        parent = draw(st.integers(-1, i - 1))
        stamps = draw(st.lists(st.integers(0, 9), min_size=1, max_size=3, unique=True))
        frames.append((parent, sorted(stamps), draw(st.booleans())))
    return frames


@settings(max_examples=300, derandomize=True, database=None)
@given(forests())
def test_agrees_with_brute_force(tools, forest):
    tree, oracle, static = tools.Tree(), tools.Oracle(), set()
    for i, (parent, stamps, is_static) in enumerate(forest):
        if parent < 0:
            continue
        if is_static:
            static.add(f"f{i}")
        for t in stamps:
            tree.put(f"f{parent}", f"f{i}", t, static=is_static)
            oracle.put(f"f{parent}", f"f{i}", t, (0, 0, 0), (0, 0, 0, 1))
    names = tree.core.frame_strings
    for a in names:
        for b in names:
            if a == b:
                continue
            expected = oracle.common_time(a, b, static)
            if expected is None:
                with pytest.raises(ConnectivityException):
                    common(tree, a, b)
            else:
                assert common(tree, a, b) == round(expected * 10**9)
