"""The frames on the way from a source to a target, over a fixed frame."""

from __future__ import annotations

import pytest

from simkit.tf.errors import ConnectivityException, LookupException


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
