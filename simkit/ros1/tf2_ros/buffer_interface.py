"""What every buffer can do with stamped data, once it can look transforms up."""

# ruff: noqa: N802 - the names are tf2_ros'

from __future__ import annotations

from typing import Any

from simkit.msgs import Duration, Time, message_class

from .registration import ConvertRegistration, TransformRegistration, TypeException, convert

__all__ = [
    "NO_TIMEOUT",
    "BufferInterface",
    "ConvertRegistration",
    "NotImplementedException",
    "Stamped",
    "TransformRegistration",
    "TypeException",
    "convert",
]

NO_TIMEOUT = Duration(0)
"""As a timeout: do not wait."""


class NotImplementedException(Exception):
    """A subclass of `BufferInterface` lacks a method."""

    def __init__(self) -> None:
        self.errstr = "CanTransform or LookupTransform not implemented"
        super().__init__(self.errstr)


class BufferInterface:
    """Transforms stamped data by the lookups that a subclass offers."""

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(
        self,
        object_stamped: Any,
        target_frame: str,
        timeout: Duration = NO_TIMEOUT,
        new_type: Any = None,
    ) -> Any:
        """The same data in another frame, at the time of its own header.

        Args:
            object_stamped: A stamped message; `import tf2_geometry_msgs` for those of geometry_msgs.
            target_frame: Frame of the result.
            timeout: How long to wait for the transform at most.
            new_type: Type of the result; that of the input if None.

        Raises:
            TypeException: No function is registered for this type.
            TransformException: As `lookup_transform`.
        """
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        found = self.lookup_transform(target_frame, header.frame_id, header.stamp, timeout)
        return _as_type(do_transform(object_stamped, found), new_type)

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
        new_type: Any = None,
    ) -> Any:
        """The same data in another frame at another time; `fixed_frame` did not move in between.

        Raises:
            TypeException: No function is registered for this type.
            TransformException: As `lookup_transform_full`.
        """
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        found = self.lookup_transform_full(
            target_frame, target_time, header.frame_id, header.stamp, fixed_frame, timeout
        )
        return _as_type(do_transform(object_stamped, found), new_type)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_TIMEOUT
    ) -> Any:
        """Pose of `source_frame` seen from `target_frame`; a subclass offers it."""
        raise NotImplementedException()

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
    ) -> Any:
        """Pose between two frames at two times; a subclass offers it."""
        raise NotImplementedException()

    def can_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_TIMEOUT
    ) -> Any:
        """Whether `lookup_transform` would answer; a subclass offers it."""
        raise NotImplementedException()

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
    ) -> Any:
        """Whether `lookup_transform_full` would answer; a subclass offers it."""
        raise NotImplementedException()


def Stamped(obj: Any, stamp: Time, frame_id: str) -> Any:
    """The object itself, with a header of this time and frame."""
    obj.header = message_class("std_msgs/Header")(frame_id=frame_id, stamp=stamp)
    return obj


def _as_type(result: Any, new_type: Any) -> Any:
    return result if new_type is None else convert(result, new_type)
