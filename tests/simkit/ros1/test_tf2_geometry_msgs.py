"""tf2_geometry_msgs against numbers of its own tests and against a rotation matrix."""

from __future__ import annotations

import json

import numpy as np
import pytest

HEAD = """
    import json, rospy, tf2_py, tf2_ros, tf2_geometry_msgs
    from geometry_msgs.msg import (
        PointStamped, PoseStamped, TransformStamped, Vector3Stamped, WrenchStamped)

    buffer = tf2_ros.Buffer()
    t = TransformStamped()
    t.header.frame_id, t.child_frame_id = "a", "b"
    t.header.stamp = rospy.Time(2.0)
    t.transform.translation.x = 1.0
    r = t.transform.rotation
    r.x, r.y, r.z, r.w = ROTATION

    def xyz(m):
        return [m.x, m.y, m.z]

    def made(kind, frame, stamp=2.0):
        m = kind()
        m.header.frame_id, m.header.stamp = frame, rospy.Time(stamp)
        return m
"""


@pytest.fixture
def said(run_script):
    """What a script prints as JSON; it has the transform T_ab, not yet stored, as `t`."""

    def run(text, rotation=(1.0, 0.0, 0.0, 0.0)):
        node = run_script(HEAD.replace("ROTATION", str(rotation)) + text, seconds=0.1)
        assert node.failure is None, node.failure
        return json.loads(node.output)

    return run


def test_the_numbers_of_upstream(said):
    assert said(
        """
    buffer.set_transform(t, "me")
    p = made(PointStamped, "a")
    p.point.x, p.point.y, p.point.z = 1, 2, 3
    out = buffer.transform(p, "b")
    v = made(Vector3Stamped, "a")
    v.vector.x = 1
    print(json.dumps([xyz(out.point), out.header.frame_id, out.header.stamp.secs,
                      xyz(buffer.transform(v, "b").vector)]))"""
    ) == [[0.0, -2.0, -3.0], "b", 2, [1.0, 0.0, 0.0]]


def test_every_type_against_a_matrix(said):
    q = np.array([0.1, -0.2, 0.3, 0.9])
    q /= np.linalg.norm(q)
    x, y, z, w = q
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn = np.identity(3) + 2 * w * cross + 2 * cross @ cross
    found = said(
        """
    p = made(PointStamped, "b"); p.point.x, p.point.y, p.point.z = 1, 2, 3
    v = made(Vector3Stamped, "b"); v.vector.x, v.vector.y, v.vector.z = 1, 2, 3
    w = made(WrenchStamped, "b"); w.wrench.force = v.vector; w.wrench.torque.z = 4
    pose = made(PoseStamped, "b"); pose.pose.position = p.point; pose.pose.orientation.w = 1
    moved = tf2_geometry_msgs.do_transform_pose(pose, t)
    o = moved.pose.orientation
    wrench = tf2_geometry_msgs.do_transform_wrench(w, t).wrench
    print(json.dumps({
        "point": xyz(tf2_geometry_msgs.do_transform_point(p, t).point),
        "vector": xyz(tf2_geometry_msgs.do_transform_vector3(v, t).vector),
        "position": xyz(moved.pose.position),
        "orientation": [o.x, o.y, o.z, o.w],
        "force": xyz(wrench.force), "torque": xyz(wrench.torque)}))""",
        rotation=tuple(q.tolist()),
    )
    given = np.array([1.0, 2.0, 3.0])
    assert found["point"] == pytest.approx(turn @ given + [1, 0, 0])
    assert found["position"] == pytest.approx(found["point"])
    assert found["vector"] == pytest.approx(turn @ given)
    assert found["force"] == pytest.approx(found["vector"])
    assert found["torque"] == pytest.approx(turn @ [0, 0, 4])
    assert found["orientation"] == pytest.approx(q)


def test_the_core_alone(said):
    assert said(
        """
    core = tf2_py.BufferCore(rospy.Duration(5))
    print(json.dumps([
        core.set_transform(t, "me"),
        core.can_transform_core("a", "b", rospy.Time(2)),
        core.can_transform_core("a", "c", rospy.Time(2)),
        core.can_transform_full_core("a", rospy.Time(2), "b", rospy.Time(2), "a"),
        core.can_transform_core("", "b", rospy.Time(2)),
        core.lookup_transform_full_core(
            "a", rospy.Time(2), "b", rospy.Time(2), "a").transform.translation.x,
        core._chain("a", rospy.Time(2), "b", rospy.Time(2), "a"),
        core._allFramesAsDot().startswith("digraph G"),
    ]))"""
    ) == [
        None,
        [1, ""],
        [0, "canTransform: source_frame c does not exist."],
        [1, ""],
        [0, ""],
        1.0,
        ["b", "a"],
        True,
    ]


def test_a_cache_length_is_no_bare_number(run_script):
    node = run_script("import tf2_ros; tf2_ros.Buffer(20.0)", seconds=0.1)
    assert "TypeError: time must have a to_sec method" in node.failure.text


def test_types_are_registered_and_converted(said):
    assert said(
        """
    import tf2_ros.registration
    class Mine:
        def __init__(self, header, x):
            self.header, self.x = header, x
    tf2_ros.TransformRegistration().add(
        Mine, lambda mine, t: Mine(t.header, mine.x + t.transform.translation.x))
    tf2_ros.ConvertRegistration().add_to_msg(Mine, lambda mine: mine.x)
    tf2_ros.ConvertRegistration().add_from_msg(float, lambda x: float(x))
    tf2_ros.ConvertRegistration().add_convert((Mine, str), lambda mine: "x = %s" % mine.x)
    buffer.set_transform(t, "me")
    mine = Mine(made(PointStamped, "b").header, 5)
    same = tf2_ros.convert(mine, Mine)
    try:
        tf2_ros.convert(mine, list)
    except tf2_ros.TypeException as error:
        refused = error.errstr
    try:
        tf2_ros.BufferInterface().lookup_transform("a", "b", rospy.Time(0))
    except tf2_ros.NotImplementedException as error:
        missing = error.errstr
    print(json.dumps([tf2_ros.Stamped(mine, rospy.Time(3), "c").header.frame_id,
                      buffer.transform(same, "a", new_type=float),
                      buffer.transform(same, "a", new_type=str),
                      same is mine, same.x, refused, missing]))"""
    ) == [
        "c",
        6.0,
        "x = 6.0",
        False,
        5,
        "Type <class 'list'> if not loaded or supported",
        "CanTransform or LookupTransform not implemented",
    ]
