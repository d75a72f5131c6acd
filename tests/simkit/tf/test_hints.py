"""What a learner is told when a lookup fails."""

from __future__ import annotations

import traceback

import pytest

from simkit.msgs import Time
from simkit.tf import Buffer, LookupException, TransformException
from simkit.tf.hints import attach, frames_in_loop, trees


@pytest.fixture
def buffer():
    return Buffer()


def hint(buffer, target, source, time=0.0):
    with pytest.raises(TransformException) as caught:
        buffer.lookup_transform(target, source, Time(time))
    return caught.value.hint


def test_nothing_has_arrived_yet(buffer):
    assert hint(buffer, "world", "turtle1") == (
        "No transform has arrived yet. Is a broadcaster running? "
        "A new listener needs about 0.1 s to hear it."
    )


def test_unknown_frame_with_a_near_name(buffer, stamped):
    buffer.set_transform(stamped("world", "turtle1", 1.0))
    assert hint(buffer, "world", "Turtel1") == (
        'No transform named the frame "Turtel1" so far; known: turtle1, world. '
        'Did you mean "turtle1"? Or is the node that broadcasts it not running yet?'
    )


def test_unknown_frame_without_a_near_name(buffer, stamped):
    buffer.set_transform(stamped("world", "turtle1", 1.0))
    assert hint(buffer, "base_link", "turtle1") == (
        'No transform named the frame "base_link" so far; known: turtle1, world. '
        "Is the node that broadcasts it not running yet?"
    )


def test_of_many_frames_some_are_named(buffer, stamped):
    for i in range(30):
        buffer.set_transform(stamped("world", f"link{i:02}", 1.0))
    assert "known: link00, link01, " in hint(buffer, "world", "arm")
    assert "link11 and 19 more. " in hint(buffer, "world", "arm")


def test_a_flood_of_frames_does_not_slow_a_hint(buffer, stamped):
    message = stamped("f0", "f1", 1.0)
    for i in range(1, 900):
        for name in (f"f{i}", f"a{i}", f"b{i}", f"c{i}"):
            message.header.frame_id, message.child_frame_id = f"f{i - 1}", name
            buffer.set_transform(message)
    buffer.set_transform(stamped("island", "palm", 1.0))
    steps = 0

    def counting(name, *, time=0, parent_of=buffer.core.parent_of):
        nonlocal steps
        steps += 1
        return parent_of(name, time=time)

    buffer.core.parent_of = counting
    assert "two trees" in hint(buffer, "palm", "f899")
    assert steps < 30_000


def test_into_the_future(buffer, stamped):
    for t in (5.0, 6.0):
        buffer.set_transform(stamped("world", "turtle1", t))
    assert hint(buffer, "world", "turtle1", 6.024) == (
        'The newest transform of "turtle1" is 0.024 s older than the time you ask for: data '
        "always arrives a little later. Ask for rospy.Time(0), the latest, or wait: "
        "waitForTransform in tf, a timeout in tf2."
    )


def test_into_the_past(buffer, stamped):
    for t in (5.0, 6.0):
        buffer.set_transform(stamped("world", "turtle1", t))
    assert hint(buffer, "world", "turtle1", 3.8) == (
        'The buffer knows "turtle1" from t = 5.000 s to 6.000 s; you ask for 1.200 s before that. '
        "Wait until it reaches back so far, or ask for a later time; after 10 s it forgets."
    )


@pytest.mark.parametrize(("asked", "known"), [(1574652168.0, 3.235), (3.235, 1574652168.0)])
def test_two_clocks(buffer, stamped, asked, known):
    buffer.set_transform(stamped("world", "turtle1", known))
    assert hint(buffer, "world", "turtle1", asked) == (
        f'You ask for t = {asked:.3f} s, but "turtle1" is known at t = {known:.3f} s: one stamp '
        "is wall-clock time, the other simulated time. Take all stamps from rospy.Time.now()."
    )


def test_leading_slash_and_empty_name(buffer):
    assert hint(buffer, "/map", "a").startswith('Write "map": ')
    assert "needs a name" in hint(buffer, "", "a")


def test_two_trees_by_a_misspelt_parent(buffer, stamped):
    buffer.set_transform(stamped("world", "turtle1", 1.0))
    buffer.set_transform(stamped("Turtle1", "carrot1", 1.0))
    assert hint(buffer, "world", "carrot1") == (
        'There are two trees: "world" with turtle1, and "Turtle1" with carrot1. '
        'The parent "Turtle1" may be a misspelt "turtle1".'
    )


def test_two_trees_by_a_missing_link(buffer, stamped):
    buffer.set_transform(stamped("turtle2", "camera", 1.0))
    for child in ("turtle1", "carrot1"):
        buffer.set_transform(stamped("world", child, 1.0))
    assert hint(buffer, "turtle2", "turtle1") == (
        'There are two trees: "turtle2" with camera, and "world" with carrot1, turtle1. '
        'No transform joins them; a broadcast with parent "world" and child "turtle2" would.'
    )


def test_many_members_are_counted(buffer, stamped):
    for i in range(12):
        buffer.set_transform(stamped("world", f"link{i:02}", 1.0))
    buffer.set_transform(stamped("odom", "base", 1.0))
    assert '"world" with link00, ' in hint(buffer, "world", "base")
    assert "link07 and 4 more" in hint(buffer, "world", "base")


def test_loop(buffer, stamped):
    buffer.set_transform(stamped("b", "a", 1.0))
    buffer.set_transform(stamped("a", "b", 1.0))
    buffer.set_transform(stamped("world", "c", 1.0))
    assert hint(buffer, "world", "a") == (
        '"a" is its own ancestor: a -> b -> a (child -> parent). '
        "Two broadcasters disagree on which of them is the parent."
    )


def test_cleared(buffer, stamped):
    buffer.set_transform(stamped("world", "a", 1.0))
    buffer.clear()
    assert "cleared" in hint(buffer, "world", "a", 1.0)


def test_full_lookups_and_common_times_have_hints_too(buffer, stamped):
    buffer.set_transform(stamped("world", "turtle1", 1.0))
    with pytest.raises(TransformException) as caught:
        buffer.lookup_transform_full("turtle1", Time(1), "turtle1", Time(0.5), "world")
    assert "0.500 s before" in caught.value.hint
    with pytest.raises(TransformException) as caught:
        buffer.get_latest_common_time("turtle1", "turtle")
    assert "turtle1" in caught.value.hint
    with pytest.raises(TransformException) as caught:
        buffer._chain("turtle1", Time(0), "turtle", Time(0), "world")
    assert "turtle1" in caught.value.hint


def test_a_plain_traceback_ends_with_the_hint(buffer):
    with pytest.raises(LookupException) as caught:
        buffer.lookup_transform("world", "turtle1")
    lines = traceback.format_exception_only(caught.value)
    assert lines[-1] == f"hint: {caught.value.hint}\n"


def test_a_hint_is_attached_once():
    error = LookupException("text")
    for hint in ("", "do this", "do this"):
        attach(error, hint)
    assert error.hint == "do this"
    assert error.__notes__ == ["hint: do this"]


# -- the shape of what a buffer holds


def test_members_by_root(tree):
    tree.put("world", "a", 1.0)
    tree.put("a", "b", 1.0)
    tree.put("odom", "base", 1.0)
    assert trees(tree.core) == {"world": ["world", "a", "b"], "odom": ["odom", "base"]}
    assert frames_in_loop(tree.core) == []


def test_a_loop_has_no_root(tree):
    tree.put("b", "a", 1.0)
    tree.put("a", "b", 1.0)
    tree.put("a", "c", 1.0)
    tree.put("c", "d", 1.0)
    assert trees(tree.core) == {}
    assert frames_in_loop(tree.core) == ["a", "b"]
