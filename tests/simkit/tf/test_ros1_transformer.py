"""tf's own API, as a script sees it; rospy and its clock are played by a fake."""

from __future__ import annotations

import math

import pytest

from simkit.msgs import Duration, Time, message_class
from simkit.tf import TransformException

LATEST = Time(0)


@pytest.fixture
def transformer(tf, stamped):
    transformer = tf.TransformerROS()
    for t in (10.0, 11.0):
        transformer.setTransform(stamped("world", "turtle1", t, (t, 0, 0)), "/b")
    transformer.setTransform(stamped("turtle1", "carrot1", 10.5, (0, 2, 0)))
    return transformer


def test_module(tf):
    assert tf.Exception is TransformException
    assert issubclass(tf.LookupException, tf.Exception)
    assert issubclass(tf.ConnectivityException, tf.Exception)
    assert issubclass(tf.ExtrapolationException, tf.Exception)
    assert not hasattr(tf, "InvalidArgument")
    angles = tf.transformations.euler_from_quaternion((0, 0, 0, 1))
    assert angles == (0.0, 0.0, 0.0)


def test_it_works_in_nodes_only(rospy):
    import importlib

    with pytest.raises(ImportError):
        importlib.import_module("simkit.ros1.tf")


def test_lookup_gives_lists(transformer):
    found = transformer.lookupTransform("/world", "/turtle1", Time(10.5))
    assert found == ([10.5, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0])
    assert transformer.lookupTransform("world", "turtle1", LATEST)[0] == [11.0, 0.0, 0.0]


def test_lookup_full(transformer):
    args = ("/turtle1", Time(11), "/turtle1", Time(10), "/world")
    assert transformer.lookupTransformFull(*args)[0] == [-1.0, 0.0, 0.0]
    assert transformer.canTransformFull(*args)


def test_each_failure_lets_time_pass(transformer, tf):
    with pytest.raises(tf.LookupException):
        transformer.lookupTransform("world", "nobody", LATEST)
    with pytest.raises(tf.ExtrapolationException):
        transformer.lookupTransformFull("turtle1", Time(11), "turtle1", Time(5), "world")
    with pytest.raises(tf.LookupException):
        transformer.getLatestCommonTime("world", "nobody")
    assert not transformer.canTransform("world", "nobody", LATEST)
    assert not transformer.frameExists("nobody")
    transformer.lookupTransform("world", "turtle1", LATEST)
    assert len(tf.passed) == 5


def test_a_float_is_no_time(transformer):
    with pytest.raises(TypeError, match="time must have a to_sec method"):
        transformer.lookupTransform("world", "turtle1", 10.5)


def test_only_frames_with_a_parent_exist(transformer):
    assert transformer.getFrameStrings() == ["turtle1", "carrot1"]
    assert transformer.frameExists("turtle1")
    assert not transformer.frameExists("world")


def test_names_lose_one_slash_but_not_in_a_chain(transformer, tf):
    assert transformer.canTransform("/world", "/turtle1", LATEST)
    assert transformer.getLatestCommonTime("/world", "/turtle1") == Time(11)
    assert not transformer.canTransform("//world", "turtle1", LATEST)
    with pytest.raises(tf.Exception, match="cannot start with"):
        transformer.lookupTransform("//world", "turtle1", LATEST)
    assert transformer.chain("world", LATEST, "turtle1", LATEST, "world") == ["turtle1", "world"]
    with pytest.raises(tf.Exception):
        transformer.chain("/world", LATEST, "turtle1", LATEST, "world")


def test_reports(transformer):
    assert transformer.allFramesAsString() == (
        "Frame turtle1 exists with parent world.\nFrame carrot1 exists with parent turtle1.\n"
    )
    assert "sec old" not in transformer.allFramesAsDot()
    assert "( 1.000 sec old)" in transformer.allFramesAsDot(Time(12))
    assert transformer.getTFPrefix() == ""


def test_clear_and_cache_time(tf, stamped):
    transformer = tf.Transformer(True, Duration(2))
    for t in range(1, 10):
        transformer.setTransform(stamped("w", "a", t))
    assert not transformer.canTransform("w", "a", Time(6))
    assert transformer.canTransform("w", "a", Time(7))
    transformer.clear()
    assert not transformer.canTransform("w", "a", Time(7))


def test_cache_lengths_of_tfs_own_test(tf, stamped):
    for seconds in (2, 50, 97):
        transformer = tf.Transformer(True, Duration(seconds))
        for t in range(101):
            transformer.setTransform(stamped("PARENT", "THISFRAME", t))
        assert transformer.getLatestCommonTime("THISFRAME", "PARENT") == Time(100)
        for t in range(1, 100 - seconds):
            with pytest.raises(tf.ExtrapolationException):
                transformer.lookupTransform("THISFRAME", "PARENT", Time(t))
        for t in range(100 - seconds, 100):
            transformer.lookupTransform("THISFRAME", "PARENT", Time(t))


def test_stamps_of_tfs_own_test(tf, stamped):
    transformer = tf.Transformer()
    for t in (3, 5, 10, 11, 19, 20, 21):
        transformer.setTransform(stamped("PARENT", "THISFRAME", t))
        assert transformer.getLatestCommonTime("THISFRAME", "PARENT") == Time(t)
    with pytest.raises(tf.ExtrapolationException):
        transformer.lookupTransform("THISFRAME", "PARENT", Time(2))
    with pytest.raises(tf.LookupException):
        transformer.lookupTransform("THISFRAME", "nowhere", Time(4))


# -- waiting


def test_a_bare_transformer_cannot_wait(transformer, tf):
    with pytest.raises(tf.Exception) as caught:
        transformer.waitForTransform("a", "b", LATEST, Duration(1))
    assert str(caught.value) == (
        "cannot wait for transform without a dedicated thread that listens to incoming TF messages"
    )


@pytest.fixture
def listener(tf):
    return tf.TransformListener()


def hear(rospy, *transforms, topic="/tf"):
    message = message_class("tf2_msgs/TFMessage")(list(transforms))
    message._connection_header = {"callerid": "/somebody"}
    rospy.callbacks[topic](message)


def test_a_listener_hears_both_topics(rospy, listener, stamped):
    hear(rospy, stamped("world", "a", 100.0))
    hear(rospy, stamped("a", "b", 0.0), topic="/tf_static")
    assert listener.canTransform("world", "b", Time(100))
    assert "Broadcaster: /somebody" in listener.allFramesAsDot()


def test_a_listener_warns_and_clears(rospy, listener, stamped):
    hear(rospy, stamped("a", "a", 100.0))
    assert rospy.warnings[0].startswith("TF_SELF_TRANSFORM")
    hear(rospy, stamped("world", "a", 100.0))
    rospy.now_ns -= 10**10
    hear(rospy, stamped("world", "b", 90.0))
    assert rospy.warnings[1].startswith("Detected jump back in time of 10.0")
    assert not listener.canTransform("world", "a", LATEST)


def test_waiting_ends_when_the_transform_comes(rospy, listener, stamped):
    rospy.at(100.5, lambda: hear(rospy, stamped("world", "a", 100.5)))
    assert listener.waitForTransform("/world", "/a", LATEST, Duration(4)) is None
    assert rospy.now_ns == pytest.approx(100.52e9, abs=1e5)


def test_waiting_that_succeeds_at_once_takes_no_time(rospy, listener, stamped):
    hear(rospy, stamped("world", "a", 100.0))
    listener.waitForTransform("world", "a", LATEST, Duration(4))
    assert rospy.now_ns == 100 * 10**9


def test_waiting_in_vain(rospy, listener, stamped, tf):
    hear(rospy, stamped("world", "a", 100.0))
    with pytest.raises(tf.Exception) as caught:
        listener.waitForTransform("world", "/b", LATEST, Duration(2))
    assert str(caught.value) == "canTransform: source_frame b does not exist."
    assert rospy.now_ns == pytest.approx(102e9, abs=3e7)
    assert tf.passed


def test_waiting_for_a_name_that_is_none(listener, tf):
    with pytest.raises(tf.Exception) as caught:
        listener.waitForTransform("/world", "//b", LATEST, Duration(0))
    assert str(caught.value) == 'no such transformation: "//b" -> "/world"'


def test_waiting_over_a_fixed_frame(rospy, listener, stamped, tf):
    hear(rospy, stamped("world", "a", 95.0))
    args = ("/a", Time(100), "/a", Time(95), "/world")
    with pytest.raises(tf.Exception, match="but only time"):
        listener.waitForTransformFull(*args, Duration(1))
    rospy.at(101.5, lambda: hear(rospy, stamped("world", "a", 101.4)))
    listener.waitForTransformFull(*args, Duration(1))


def test_a_timeout_is_a_duration(listener):
    with pytest.raises(TypeError, match=r"timeout must be a rospy\.Duration, not 4\.0"):
        listener.waitForTransform("a", "b", LATEST, 4.0)


# -- messages in another frame


@pytest.fixture
def half_turn(tf, stamped):
    """Frame a in b: turned half about x, and moved by 1 along x."""
    transformer = tf.TransformerROS()
    transformer.setTransform(stamped("b", "a", 2.0, (1, 0, 0), (1, 0, 0, 0)))
    return transformer


def message(type_name, frame="a", time=2):
    result = message_class(type_name)()
    result.header.frame_id = frame
    result.header.stamp = Time(time)
    return result


def fields(part):
    return tuple(getattr(part, name) for name in part.__slots__)


def test_point(half_turn):
    given = message("geometry_msgs/PointStamped")
    given.point.x, given.point.y, given.point.z = 1.0, 2.0, 3.0
    found = half_turn.transformPoint("b", given)
    assert fields(found.point) == pytest.approx((2, -2, -3))
    assert (found.header.frame_id, found.header.stamp) == ("b", Time(2))
    back = half_turn.transformPoint("a", message("geometry_msgs/PointStamped", "b"))
    assert fields(back.point) == pytest.approx((-1, 0, 0))


def test_point_with_the_inverse_of_tf2s_test(tf, stamped):
    transformer = tf.TransformerROS()
    transformer.setTransform(stamped("a", "b", 2.0, (1, 0, 0), (1, 0, 0, 0)))
    given = message("geometry_msgs/PointStamped")
    given.point.x, given.point.y, given.point.z = 1.0, 2.0, 3.0
    assert fields(transformer.transformPoint("b", given).point) == pytest.approx((0, -2, -3))


def test_vector_ignores_the_translation(tf, stamped):
    transformer = tf.TransformerROS()
    transformer.setTransform(stamped("b", "a", 2.0, (9, 9, 9), (0, 1, 0, 0)))
    given = message("geometry_msgs/Vector3Stamped")
    given.vector.x = 1.0
    assert fields(transformer.transformVector3("b", given).vector) == pytest.approx((-1, 0, 0))


def test_quaternion_and_pose(half_turn):
    turned = message("geometry_msgs/QuaternionStamped")
    turned.quaternion.w = 1.0
    found = half_turn.transformQuaternion("b", turned)
    assert fields(found.quaternion) == pytest.approx((1, 0, 0, 0))
    pose = message("geometry_msgs/PoseStamped")
    pose.pose.position.y = 1.0
    found = half_turn.transformPose("b", pose)
    assert fields(found.pose.position) == pytest.approx((1, -1, 0))
    assert fields(found.pose.orientation) == pytest.approx((1, 0, 0, 0))


def test_point_cloud(half_turn):
    cloud = message("sensor_msgs/PointCloud")
    cloud.points = [message_class("geometry_msgs/Point32")(1.0, 2.0, 3.0)]
    found = half_turn.transformPointCloud("b", cloud)
    assert [fields(point) for point in found.points] == [pytest.approx((2, -2, -3))]


def test_matrices(half_turn):
    matrix = half_turn.asMatrix("b", message("geometry_msgs/PointStamped").header)
    assert matrix @ (1, 2, 3, 1) == pytest.approx((2, -2, -3, 1))
    matrix = half_turn.fromTranslationRotation((1, 2, 3), (0, 0, 0, 1))
    assert matrix[:3, 3] == pytest.approx((1, 2, 3))


def test_unknown_frames_are_refused(half_turn, tf):
    with pytest.raises(tf.LookupException):
        half_turn.transformPoint("nowhere", message("geometry_msgs/PointStamped"))


# -- velocities


def moving(tf, stamped, pose):
    """A transformer that knows `foo` in `bar` from 0.5 s on, every tenth of a second."""
    transformer = tf.Transformer(True, Duration(20))
    for k in range(5, 80):
        xyz, q = pose(k / 10)
        transformer.setTransform(stamped("bar", "foo", k / 10, xyz, q))
        transformer.setTransform(stamped("foo", "offset_child", k / 10, (0, 1, 0)))
        transformer.setTransform(stamped("offset_parent", "bar", k / 10, (0, 1, 0)))
    return transformer


def zigzag(t):
    """One second of 1 m/s along +x, +y, -x, -y, +z, -z in turn."""
    xyz = [0.0, 0.0, 0.0]
    legs = [(0, 1), (1, 1), (0, -1), (1, -1), (2, 1), (2, -1)]
    for leg, (axis, sign) in enumerate(legs):
        xyz[axis] += sign * min(1.0, max(0.0, t - 1.0 - leg))
    return tuple(xyz), (0, 0, 0, 1)


@pytest.mark.parametrize("tracking", ["foo", "offset_child"])
@pytest.mark.parametrize("observation", ["bar", "offset_parent"])
@pytest.mark.parametrize("leg", range(6))
def test_velocity_of_a_zigzag(tf, stamped, tracking, observation, leg):
    transformer = moving(tf, stamped, zigzag)
    expected = [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)][leg]
    linear, angular = transformer.lookupTwist(tracking, observation, Time(leg + 1.5), Duration(0.1))
    assert linear == pytest.approx(expected, abs=1e-6)
    assert angular == pytest.approx((0, 0, 0), abs=1e-6)


def test_velocity_at_the_end_of_the_data(tf, stamped):
    transformer = moving(tf, stamped, lambda t: ((3 * t, 0, 0), (0, 0, 0, 1)))
    linear, _ = transformer.lookupTwist("foo", "bar", LATEST, Duration(0.4))
    assert linear == pytest.approx((3, 0, 0))
    linear, _ = transformer.lookupTwist("/foo", "/bar", Time(7.8), Duration(1))
    assert linear == pytest.approx((3, 0, 0))


def circle(t):
    angle = 0.5 * t
    return (2 * math.cos(angle), 2 * math.sin(angle), 0), (
        0, 0, math.sin(angle / 2 + math.pi / 4), math.cos(angle / 2 + math.pi / 4),
    )  # fmt: skip


def test_velocity_on_a_circle(tf, stamped):
    transformer = moving(tf, stamped, circle)
    linear, angular = transformer.lookupTwist("foo", "bar", Time(4), Duration(0.2))
    assert linear == pytest.approx((-math.sin(2), math.cos(2), 0), abs=2e-3)
    assert angular == pytest.approx((0, 0, 0.5), abs=1e-6)


def test_velocity_in_the_bodys_own_axes_and_of_another_point(tf, stamped):
    transformer = moving(tf, stamped, circle)
    linear, angular = transformer.lookupTwistFull(
        "foo", "bar", "foo", (0, 0, 0), "foo", Time(4), Duration(0.2)
    )
    assert linear == pytest.approx((1, 0, 0), abs=2e-3)
    assert angular == pytest.approx((0, 0, 0.5), abs=1e-6)
    # The centre of the circle lies 2 m to the left, and stands still.
    linear, _ = transformer.lookupTwistFull(
        "foo", "bar", "foo", (0, 2, 0), "foo", Time(4), Duration(0.2)
    )
    assert linear == pytest.approx((0, 0, 0), abs=2e-3)


@pytest.mark.parametrize(
    ("speed", "seen"),
    [(0.7, 0.7), (-2.0, -2.0), (3.5, 3.5 - 2 * math.pi), (-3.5, 2 * math.pi - 3.5)],
)
def test_turns_go_the_shorter_way(tf, stamped, yaw, speed, seen):
    transformer = moving(tf, stamped, lambda t: ((0, 0, 0), yaw(math.pi + speed * (t - 4))))
    _, angular = transformer.lookupTwist("foo", "bar", Time(4), Duration(1))
    assert angular == pytest.approx((0, 0, seen), abs=1e-6)
