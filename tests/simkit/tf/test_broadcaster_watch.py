"""Two nodes that broadcast one frame."""

from __future__ import annotations

from simkit.tf.broadcaster_watch import BroadcasterWatch


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
