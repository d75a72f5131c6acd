from __future__ import annotations

from simkit.viz.trees.forest import forest_of


def shape(tree):
    """Names with the names of their parents."""
    return [(n.name, None if n.parent is None else tree.nodes[n.parent].name) for n in tree.nodes]


def test_a_tree_is_listed_from_its_root(turtles):
    (tree,) = forest_of(turtles.core).trees
    assert shape(tree) == [
        ("world", None),
        ("turtle1", "world"),
        ("carrot1", "turtle1"),
        ("turtle2", "world"),
    ]
    assert tree.nodes[0].report is None
    assert tree.nodes[1].report.broadcaster == "/turtle1_tf_broadcaster"


def test_two_trees_are_told_apart_with_a_remedy(two_trees):
    forest = forest_of(two_trees.core)
    assert [tree.nodes[0].name for tree in forest.trees] == ["world", "map"]
    assert forest.frame_count == 8
    (warning,) = forest.warnings
    assert warning.startswith("These trees are not connected.")
    assert 'a broadcast with parent "world" and child "map" would' in warning


def test_a_slip_in_a_name_is_pointed_out(buffer):
    buffer.put("world", "turtle1")
    buffer.put("turtel1", "carrot1")
    (warning,) = forest_of(buffer.core).warnings
    assert 'may be a misspelt "turtle1"' in warning


def test_many_trees_name_their_roots(buffer):
    for number in range(9):
        buffer.put(f"root{number}", f"leaf{number}")
    (warning,) = forest_of(buffer.core).warnings
    assert "These 9 trees are not connected" in warning
    assert '"root0", "root1"' in warning
    assert "and 3 more" in warning


def test_static_frames_are_marked(two_trees):
    nodes = {node.name: node for tree in forest_of(two_trees.core).trees for node in tree.nodes}
    assert nodes["laser"].is_static
    assert not nodes["odom"].is_static


def test_a_loop_is_cut_open_and_explained(buffer):
    for parent, child in (("a", "b"), ("b", "c"), ("c", "a"), ("c", "d")):
        buffer.put(parent, child)
    forest = forest_of(buffer.core)
    (tree,) = forest.trees
    assert tree.nodes[0].is_echo
    assert forest.frame_count == 4
    assert sorted(node.name for node in tree.nodes if node.report) == ["a", "b", "c", "d"]
    for name, parent in shape(tree)[1:]:
        assert (parent, name) in {("a", "b"), ("b", "c"), ("c", "a"), ("c", "d")}
    assert "is its own ancestor" in forest.warnings[0]


def test_a_frame_in_itself_is_refused_and_nothing_is_drawn(buffer):
    assert not buffer.put("a", "a")
    assert forest_of(buffer.core).frame_count == 0


def test_a_cleared_frame_stands_alone(turtles):
    turtles.clear()
    forest = forest_of(turtles.core)
    assert all(len(tree.nodes) == 1 for tree in forest.trees)
    assert forest.frame_count == 4


def test_nothing(buffer):
    forest = forest_of(buffer.core)
    assert forest.trees == ()
    assert forest.warnings == ()
