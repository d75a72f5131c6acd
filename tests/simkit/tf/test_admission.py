"""Which transforms a buffer takes, and what it says of the others."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.tf.admission import BroadcasterWatch, is_admissible, objections, rotation_advice

NAN = math.nan
HALF = math.sqrt(0.5)


def test_a_transform_without_anything_is_refused(tree):
    assert not tree.put("", "", q=(0, 0, 0, 0))
    kinds = [text.split(":")[0] for text in tree.warnings]
    assert kinds == [
        "TF_SELF_TRANSFORM",
        "TF_NO_CHILD_FRAME_ID",
        "TF_NO_FRAME_ID",
        "TF_DENORMALIZED_QUATERNION",
    ]


def test_a_good_transform_is_taken_silently(tree):
    assert tree.put("foo", "child", 1.0)
    assert tree.warnings == []


def test_a_rotation_of_zeros_is_refused(tree):
    assert not tree.put("foo", "child", 1.0, q=(0, 0, 0, 0))


def test_a_frame_in_itself_is_refused(tree):
    assert not tree.put("same", "same", 1.0)
    assert tree.warnings == [
        'TF_SELF_TRANSFORM: Ignoring transform from authority "me" with frame_id and '
        'child_frame_id  "same" because they are the same'
    ]


def test_the_slash_is_dropped_before_names_are_compared(tree):
    assert not tree.put("/same", "same", 1.0)


def test_nan_is_refused_although_the_transform_before_was_good(tree):
    assert tree.put("parent", "child", 1.0)
    assert not tree.put("parent", "child", 2.0, xyz=(NAN, 0, 0))
    assert tree.warnings == [
        'TF_NAN_INPUT: Ignoring transform for child_frame_id "child" from authority "me" because '
        "of a nan value in the transform (nan 0.000000 0.000000) "
        "(0.000000 0.000000 0.000000 1.000000)"
    ]


def test_nan_in_the_rotation_is_two_faults(tree):
    assert not tree.put("parent", "child", q=(0, 0, 0, NAN))
    assert [text.split(":")[0] for text in tree.warnings] == [
        "TF_NAN_INPUT",
        "TF_DENORMALIZED_QUATERNION",
    ]


@pytest.mark.parametrize("name", ["", "/"])
def test_a_child_needs_a_name(tree, name):
    assert not tree.put("parent", name, 1.0)
    assert tree.warnings == [
        'TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "me" because '
        "child_frame_id not set "
    ]


@pytest.mark.parametrize("name", ["", "/"])
def test_a_parent_needs_a_name(tree, name):
    assert not tree.put(name, "child", 1.0)
    assert tree.warnings == [
        'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "child"  from authority "me" '
        "because frame_id not set"
    ]


@pytest.mark.parametrize("w", [0.995, 0.99499, 1.00498, -1.0])
def test_nearly_normalised_rotations_are_taken_as_they_are(tree, w):
    assert tree.put("a", "b", 1.0, q=(0, 0, 0, w))
    assert tree.lookup("a", "b", 1.0).rotation == (0, 0, 0, w)


@pytest.mark.parametrize("w", [0.994, 1.005, 0.0])
def test_other_rotations_are_refused(tree, w):
    assert not tree.put("a", "b", 1.0, q=(0, 0, 0, w))
    assert tree.warnings == [
        'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "b" from authority '
        f'"me" because of an invalid quaternion in the transform (0.000000 0.000000 0.000000 {w:f})'
    ]


@pytest.mark.parametrize(
    ("q", "valid"),
    [
        ((1, 0, 0, 0), True),
        ((0, 1, 0, 0), True),
        ((0, 0, 1, 0), True),
        ((0, 0, 0, 1), True),
        ((0, 0, HALF, HALF), True),
        ((0, 0, HALF + 0.01, HALF), False),
        ((0, 0, HALF - 0.01, HALF), False),
        ((0, 0, NAN, HALF), False),
    ],
)
def test_quaternion_validity(tree, q, valid):
    assert tree.put("a", "b", 1.0, q=q) is valid


def test_infinite_translations_are_taken(tree):
    assert tree.put("a", "b", 1.0, xyz=(math.inf, 0, 0))
    assert tree.lookup("a", "b", 1.0).translation[0] == math.inf


def test_a_refused_transform_leaves_no_trace(tree):
    tree.put("a", "b", 1.0, q=(0, 0, 0, 0))
    assert tree.core.frame_strings == []


def test_old_data_is_refused_with_tfs_words(tree):
    tree.put("w", "a", 20.0)
    assert tree.put("w", "a", 10.0)
    assert not tree.put("w", "a", 9.999, authority="/node")
    assert tree.warnings == [
        "TF_OLD_DATA ignoring data from the past (Possible reasons are listed at "
        "http://wiki.ros.org/tf/Errors%20explained) for frame a (parent w) at time 9.999000 "
        "according to authority /node"
    ]


def test_repeated_data_is_refused_with_tfs_words(tree):
    tree.put("w", "a", 2.0, (1, 0, 0))
    assert not tree.put("w", "a", 2.0, (5, 0, 0))
    assert tree.lookup("w", "a", 2.0).translation == (1, 0, 0)
    assert tree.warnings == [
        "TF_REPEATED_DATA ignoring data with redundant timestamp for frame a (parent w) "
        "at time 2.000000 according to authority me"
    ]


def test_only_one_slash_is_dropped(tree):
    tree.put("//w", "/a", 1.0)
    assert tree.core.frame_strings == ["a", "/w"]


numbers = (
    st.sampled_from([0.0, 1.0, -0.5, HALF, 1e300, -1e300, math.inf, -math.inf, NAN]) | st.floats()
)
names = st.sampled_from(["", "a", "b"])


@given(names, names, st.tuples(*[numbers] * 3), st.tuples(*[numbers] * 4))
def test_the_quick_answer_is_never_better_than_the_objections(parent, child, place, turn):
    faults = list(objections(parent, child, translation=place, rotation=turn, authority="somebody"))
    quick = is_admissible(parent, child, translation=place, rotation=turn)
    assert not (quick and faults)
    if all(map(math.isfinite, (*place, *turn))) and math.isfinite(sum(map(abs, place))):
        assert quick == (not faults)


# -- what a learner is told about a rotation that is none


def test_a_rotation_needs_no_advice():
    assert rotation_advice("a", (0.0, 0.0, 0.0, 1.0)) == ""


@pytest.mark.parametrize(
    ("rotation", "words"),
    [
        ((0.0, 0.0, 1.57, 0.0), "norm 1.57 instead of 1. If these are angles"),
        ((0.0, 0.0, 0.0, 0.0), "all zeros"),
        ((0.0, 0.0, math.nan, 1.0), "NaN"),
    ],
)
def test_advice(rotation, words):
    assert words in rotation_advice("carrot1", rotation)


# -- two nodes that broadcast one frame


def test_alternation_is_told_once():
    watch = BroadcasterWatch()
    said = []
    for _ in range(3):
        said.append(watch.note("carrot1", "turtle1", authority="/a"))
        said.append(watch.note("carrot1", "world", authority="/b"))
    assert [text for text in said if text] == [
        'Frame "carrot1" has 2 broadcasters: /a (parent turtle1) and /b (parent world). '
        "A frame has one parent and one broadcaster; it jumps between them."
    ]


def test_a_successor_is_no_rival():
    watch = BroadcasterWatch()
    senders = ["/a", "/a", "/b", "/b", "/c"]
    assert not any(watch.note("f", "w", authority=sender) for sender in senders)


def test_one_node_may_change_the_parent():
    watch = BroadcasterWatch()
    assert not any(watch.note("f", parent, authority="/a") for parent in "wvwv")
