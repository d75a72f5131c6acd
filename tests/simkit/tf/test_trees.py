"""The shape of what a buffer holds."""

from __future__ import annotations

from simkit.tf.trees import find_loop, trees


def test_members_by_root(tree):
    tree.put("world", "a", 1.0)
    tree.put("a", "b", 1.0)
    tree.put("odom", "base", 1.0)
    assert trees(tree.core) == {"world": ["world", "a", "b"], "odom": ["odom", "base"]}
    assert find_loop(tree.core) == []


def test_a_loop_has_no_root(tree):
    tree.put("b", "a", 1.0)
    tree.put("a", "b", 1.0)
    tree.put("a", "c", 1.0)
    tree.put("c", "d", 1.0)
    assert trees(tree.core) == {}
    assert find_loop(tree.core) == ["a", "b"]
