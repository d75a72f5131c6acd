"""Message classes: defaults, constructor, comparison, copies."""

from __future__ import annotations

import copy
import io
import threading

import pytest

from simkit.msgs import Duration, Time, message_class, message_types, service_class, service_types

Twist = message_class("geometry_msgs/Twist")
Vector3 = message_class("geometry_msgs/Vector3")
Odometry = message_class("nav_msgs/Odometry")
Pose = message_class("turtlesim/Pose")


def test_class_attributes():
    assert Twist._type == "geometry_msgs/Twist"
    assert Twist.__slots__ == ["linear", "angular"]
    assert Twist._slot_types == ["geometry_msgs/Vector3", "geometry_msgs/Vector3"]
    assert Twist.__name__ == "Twist"
    assert Twist.__module__ == "geometry_msgs.msg._Twist"
    assert Odometry._has_header
    assert not Twist._has_header
    assert Odometry._slot_types[0] == "std_msgs/Header"


def test_a_class_is_made_once():
    assert message_class("geometry_msgs/Twist") is Twist
    assert type(Twist().linear) is Vector3
    assert message_class("Header") is message_class("std_msgs/Header")
    assert service_class("turtlesim/Spawn") is service_class("turtlesim/Spawn")


def test_threads_get_the_same_class():
    made: list[type] = []
    work = [
        threading.Thread(target=lambda: made.append(message_class("stereo_msgs/DisparityImage")))
        for _ in range(4)
    ]
    for thread in work:
        thread.start()
    for thread in work:
        thread.join()
    assert len(set(made)) == 1


def test_defaults():
    odometry = Odometry()
    assert odometry.header.stamp == Time()
    assert odometry.header.seq == 0
    assert odometry.child_frame_id == ""
    assert odometry.pose.covariance == [0.0] * 36
    assert message_class("sensor_msgs/Image")().data == b""
    assert message_class("sensor_msgs/LaserScan")().ranges == []
    assert message_class("std_msgs/Bool")().data is False
    assert message_class("std_msgs/Duration")().data == Duration()


def test_defaults_are_fresh():
    for made in (Odometry, message_class("sensor_msgs/JointState")):
        assert made().header is not made().header
        assert made().header.stamp is not made().header.stamp
    assert Odometry().pose.covariance is not Odometry().pose.covariance


def test_positional_and_keyword_arguments():
    assert Vector3(1, 2, 3).z == 3
    assert Twist(linear=Vector3(x=1.0)).angular == Vector3()
    assert Twist(None, Vector3(z=1)).linear == Vector3()


def test_wrong_arguments():
    with pytest.raises(TypeError, match="may only use args OR keywords, not both"):
        Vector3(1, 2, z=3)
    with pytest.raises(TypeError, match=r"Invalid number of arguments, args should be \['x', 'y'"):
        Vector3(1, 2)
    with pytest.raises(
        AttributeError, match="liner is not an attribute of Twist; did you mean lin"
    ):
        Twist(liner=Vector3())


def test_no_other_attributes():
    with pytest.raises(AttributeError):
        Twist().speed = 1.0
    message = Twist()
    message._connection_header = {"callerid": "/turtlesim"}
    assert message._connection_header["callerid"] == "/turtlesim"


def test_constants():
    marker = message_class("visualization_msgs/Marker")
    assert (marker.ARROW, marker.DELETEALL) == (0, 3)
    assert marker().ARROW == 0
    assert service_class("gazebo_msgs/GetJointProperties")._response_class.PRISMATIC == 2


def test_equality_is_by_value():
    assert Vector3(1, 2, 3) == Vector3(1.0, 2.0, 3.0)
    assert Vector3(1, 2, 3) != Vector3(1, 2, 4)
    assert Vector3() != message_class("geometry_msgs/Point")()
    scan = message_class("sensor_msgs/LaserScan")
    assert scan(ranges=(1.0, 2.0)) == scan(ranges=[1.0, 2.0])
    with pytest.raises(TypeError, match="unhashable"):
        hash(Vector3())


def test_copies_are_deep():
    message = Odometry(child_frame_id="base")
    other = copy.deepcopy(message)
    assert other == message
    other.pose.pose.position.x = 1.0
    assert message.pose.pose.position.x == 0.0


def test_serialize_and_deserialize_as_genpy():
    buffer = io.BytesIO()
    Pose(1, 2, 3, 4, 5).serialize(buffer)
    assert buffer.getvalue() == Pose(1, 2, 3, 4, 5).to_bytes()
    pose = Pose()
    assert pose.deserialize(buffer.getvalue() + b"more") is pose
    assert pose == Pose(1, 2, 3, 4, 5)


def test_service_classes():
    spawn = service_class("turtlesim/Spawn")
    assert spawn._type == "turtlesim/Spawn"
    request = spawn._request_class(1.0, 2.0, 0.5, "turtle2")
    assert type(request).__name__ == "SpawnRequest"
    assert request._type == "turtlesim/SpawnRequest"
    assert spawn._response_class(name="turtle2").name == "turtle2"


def test_every_type_has_defaults_that_can_be_sent(all_classes):
    assert len(all_classes) == len(message_types()) + 2 * len(service_types())
    for made in all_classes:
        message = made()
        assert made.from_bytes(message.to_bytes()) == message
        assert str(message) == repr(message)
