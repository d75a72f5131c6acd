"""The functions that transform stamped messages of geometry_msgs.

Each takes a message and the geometry_msgs/TransformStamped T_ab, for a message in frame b; the
result is in frame a. Its header is that of the transform: frame a, and the transform's time.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from simkit.geometry import IDENTITY, Quaternion, Transform, Vector, canonical, rotate
from simkit.msgs import message_class

if TYPE_CHECKING:
    from simkit.ros1 import tf2_ros
else:
    import tf2_ros

_T = TypeVar("_T")


def do_transform_point(point: Any, transform: Any) -> Any:
    """A geometry_msgs/PointStamped in the frame of the transform: turned and moved."""
    result = _result("geometry_msgs/PointStamped", transform)
    _fill(result.point, _values(transform).apply(_xyz(point.point)))
    return result


def do_transform_vector3(vector3: Any, transform: Any) -> Any:
    """A geometry_msgs/Vector3Stamped in the frame of the transform: a vector turns, but does not move."""
    result = _result("geometry_msgs/Vector3Stamped", transform)
    _fill(result.vector, rotate(_values(transform).rotation, _xyz(vector3.vector)))
    return result


def do_transform_pose(pose: Any, transform: Any) -> Any:
    """A geometry_msgs/PoseStamped in the frame of the transform."""
    given = Transform(_xyz(pose.pose.position), _xyzw(pose.pose.orientation))
    moved = _values(transform) @ given
    result = _result("geometry_msgs/PoseStamped", transform)
    _fill(result.pose.position, moved.translation)
    _fill(result.pose.orientation, canonical(moved.rotation))
    return result


def do_transform_wrench(wrench: Any, transform: Any) -> Any:
    """A geometry_msgs/WrenchStamped in the frame of the transform: force and torque turn."""
    rotation = _values(transform).rotation
    result = _result("geometry_msgs/WrenchStamped", transform)
    _fill(result.wrench.force, rotate(rotation, _xyz(wrench.wrench.force)))
    _fill(result.wrench.torque, rotate(rotation, _xyz(wrench.wrench.torque)))
    return result


def to_msg_msg(msg: _T) -> _T:
    """The message itself."""
    return msg


def from_msg_msg(msg: _T) -> _T:
    """The message itself."""
    return msg


def _values(transform: Any) -> Transform:
    return Transform(_xyz(transform.transform.translation), _xyzw(transform.transform.rotation))


def _xyz(message: Any) -> Vector:
    return (message.x, message.y, message.z)


def _xyzw(message: Any) -> Quaternion:
    """The message's quaternion; all zeros, as in a new message, turn nothing."""
    q = (message.x, message.y, message.z, message.w)
    return q if any(q) else IDENTITY


def _result(message_type: str, transform: Any) -> Any:
    result: Any = message_class(message_type)()
    result.header = transform.header
    return result


def _fill(message: Any, values: tuple[float, ...]) -> None:
    for name, value in zip(message.__slots__, values, strict=True):
        setattr(message, name, value)


_FUNCTIONS: dict[str, Callable[[Any, Any], Any]] = {
    "PointStamped": do_transform_point,
    "Vector3Stamped": do_transform_vector3,
    "PoseStamped": do_transform_pose,
    "WrenchStamped": do_transform_wrench,
}
for _name, _function in _FUNCTIONS.items():
    _stamped = message_class(f"geometry_msgs/{_name}")
    tf2_ros.TransformRegistration().add(_stamped, _function)
    tf2_ros.ConvertRegistration().add_to_msg(_stamped, to_msg_msg)
    tf2_ros.ConvertRegistration().add_from_msg(_stamped, from_msg_msg)
