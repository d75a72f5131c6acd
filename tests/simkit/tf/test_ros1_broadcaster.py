"""tf.TransformBroadcaster, as a script sees it."""

from __future__ import annotations

import pytest

from simkit.msgs import Time

NOW = Time(5, 6)
GOOD = ((1, 2, 3), (0, 0, 0, 1), NOW, "turtle1", "world")


@pytest.fixture
def broadcaster(tf):
    return tf.TransformBroadcaster()


def test_what_is_sent(rospy, broadcaster):
    broadcaster.sendTransform(*GOOD)
    ((topic, message),) = rospy.published
    assert topic == "/tf"
    (sent,) = message.transforms
    assert (sent.header.frame_id, sent.child_frame_id) == ("world", "turtle1")
    assert sent.header.stamp == NOW
    p, q = sent.transform.translation, sent.transform.rotation
    assert (p.x, p.y, p.z, q.x, q.y, q.z, q.w) == (1, 2, 3, 0, 0, 0, 1)
    assert message.to_bytes()


def test_numpy_is_welcome(rospy, broadcaster, tf):
    rotation = tf.transformations.quaternion_from_euler(0, 0, 1.0)
    broadcaster.sendTransform((1, 2, 0), rotation, NOW, "a", "b")
    assert rospy.published[0][1].to_bytes()


def test_nonsense_is_sent_as_it_is(rospy, broadcaster):
    broadcaster.sendTransform((0, 0, 0), (0, 0, 1.57, 7), NOW, "", "")
    assert rospy.published[0][1].transforms[0].transform.rotation.z == 1.57


def test_a_message_can_be_sent(rospy, broadcaster, stamped):
    transform = stamped("world", "a", 1.0)
    broadcaster.sendTransformMessage(transform)
    assert rospy.published[0][1].transforms == [transform]


@pytest.mark.parametrize(
    ("place", "value", "error", "words"),
    [
        (0, (1, 2), IndexError, r"translation must be \(x, y, z\)"),
        (0, 5.0, IndexError, r"translation must be \(x, y, z\)"),
        (1, (0, 0, 1.57), IndexError, "quaternion_from_euler"),
        (2, 5.0, AttributeError, r"has no attribute 'secs': time must be a rospy\.Time, not 5\.0"),
        (3, NOW, TypeError, "child must be the name of a frame"),
        (4, None, TypeError, "parent must be the name of a frame, not None"),
    ],
)
def test_slips_are_named(broadcaster, place, value, error, words):
    arguments = list(GOOD)
    arguments[place] = value
    with pytest.raises(error, match=words) as caught:
        broadcaster.sendTransform(*arguments)
    assert "sendTransform(translation, rotation, time, child, parent)" in str(caught.value)
