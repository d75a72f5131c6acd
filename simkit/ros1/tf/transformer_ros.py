"""Stamped messages from one frame into another."""

# ruff: noqa: N802 - the names are tf's

from __future__ import annotations

from typing import Any

from simkit.geometry import Quaternion, Transform, Vector, canonical, multiply
from simkit.msgs import message_class

from . import transformations
from .transformer import Transformer


class TransformerROS(Transformer):
    """Also takes the stamped messages of geometry_msgs, at the time of their header.

    A result carries the name of the frame as the caller wrote it, and the stamp of the input.
    """

    def asMatrix(self, target_frame: str, hdr: Any) -> Any:
        """Matrix (4, 4) from the frame and time of a std_msgs/Header to `target_frame`.

        Raises:
            TransformException: As `lookupTransform`.
        """
        return self.fromTranslationRotation(
            *self.lookupTransform(target_frame, hdr.frame_id, hdr.stamp)
        )

    def fromTranslationRotation(self, translation: Any, rotation: Any) -> Any:
        """Matrix (4, 4) of a translation (3,) [m] and a quaternion (4,)."""
        return transformations.concatenate_matrices(
            transformations.translation_matrix(translation),
            transformations.quaternion_matrix(rotation),
        )

    def transformPoint(self, target_frame: str, ps: Any) -> Any:
        """The geometry_msgs/PointStamped in another frame.

        Raises:
            TransformException: As `lookupTransform`.
        """
        transform = self._transform(target_frame, ps.header)
        result = _result("geometry_msgs/PointStamped", target_frame, ps)
        _fill(result.point, transform.apply(_values(ps.point)))
        return result

    def transformVector3(self, target_frame: str, v3s: Any) -> Any:
        """The geometry_msgs/Vector3Stamped in another frame: a vector turns, but does not move.

        Raises:
            TransformException: As `lookupTransform`.
        """
        transform = self._transform(target_frame, v3s.header)
        result = _result("geometry_msgs/Vector3Stamped", target_frame, v3s)
        _fill(result.vector, transform.rotate(_values(v3s.vector)))
        return result

    def transformQuaternion(self, target_frame: str, ps: Any) -> Any:
        """The geometry_msgs/QuaternionStamped in another frame.

        Raises:
            TransformException: As `lookupTransform`.
        """
        transform = self._transform(target_frame, ps.header)
        result = _result("geometry_msgs/QuaternionStamped", target_frame, ps)
        turned = multiply(transform.rotation, _rotation(ps.quaternion))
        _fill(result.quaternion, canonical(turned))
        return result

    def transformPose(self, target_frame: str, ps: Any) -> Any:
        """The geometry_msgs/PoseStamped in another frame.

        Raises:
            TransformException: As `lookupTransform`.
        """
        transform = self._transform(target_frame, ps.header)
        result = _result("geometry_msgs/PoseStamped", target_frame, ps)
        pose = Transform(_values(ps.pose.position), _rotation(ps.pose.orientation))
        moved = transform @ pose
        _fill(result.pose.position, moved.translation)
        _fill(result.pose.orientation, canonical(moved.rotation))
        return result

    def transformPointCloud(self, target_frame: str, point_cloud: Any) -> Any:
        """The sensor_msgs/PointCloud in another frame; its channels are those of the input.

        Raises:
            TransformException: As `lookupTransform`.
        """
        transform = self._transform(target_frame, point_cloud.header)
        result = _result("sensor_msgs/PointCloud", target_frame, point_cloud)
        result.channels = point_cloud.channels
        point_class = message_class("geometry_msgs/Point32")
        result.points = [
            point_class(*transform.apply(_values(point))) for point in point_cloud.points
        ]
        return result

    def _transform(self, target_frame: str, header: Any) -> Transform:
        """What tf's matrix does: the rotation has unit length."""
        (x, y, z), (qx, qy, qz, qw) = self.lookupTransform(
            target_frame, header.frame_id, header.stamp
        )
        return Transform((x, y, z), canonical((qx, qy, qz, qw)))


def _result(message_type: str, frame: str, given: Any) -> Any:
    result: Any = message_class(message_type)()
    result.header.stamp = given.header.stamp
    result.header.frame_id = frame
    return result


def _values(message: Any) -> Vector:
    return (message.x, message.y, message.z)


def _rotation(message: Any) -> Quaternion:
    """The message's quaternion with unit length; all zeros, as in a new message, turn nothing."""
    q = (message.x, message.y, message.z, message.w)
    return canonical(q) if any(q) else (0.0, 0.0, 0.0, 1.0)


def _fill(message: Any, values: tuple[float, ...]) -> None:
    for name, value in zip(message.__slots__, values, strict=True):
        setattr(message, name, value)
