"""The buffer of messages: geometry_msgs/TransformStamped in and out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from simkit.msgs import Duration, Time, message_class
from simkit.tf.buffer_core import DEFAULT_CACHE_TIME, BufferCore
from simkit.tf.errors import TransformException
from simkit.tf.hints import teach
from simkit.tf.path import StampedTransform

LATEST: Final = Time(0)
"As a time: the latest at which the whole way has data."


class Buffer:
    """Transforms of the last seconds, as messages.

    `lookup_transform("a", "b")` is T_ab: it takes coordinates in b to coordinates in a, and is
    the pose of b seen from a. What it raises carries tf's text, and a hint in `error.hint`, with
    which its traceback ends.

    Args:
        cache_time: How long a moving frame is remembered; 10 s if None.
        on_warning: Is given tf's sentence for each transform or name that is refused.

    Attributes:
        core: The same buffer in integers and tuples.

    Source:
        `tf2_ros.Buffer` without its waiting, and `tf2.BufferCore`, whose names it also offers.
    """

    def __init__(
        self,
        cache_time: Duration | None = None,
        on_warning: Callable[[str], None] | None = None,
    ) -> None:
        length = DEFAULT_CACHE_TIME if cache_time is None else cache_time.to_nsec()
        self.core = BufferCore(length, on_warning)
        self._transform_stamped = message_class("geometry_msgs/TransformStamped")

    @property
    def on_warning(self) -> Callable[[str], None] | None:
        """Is given tf's sentence for each transform or name that is refused."""
        return self.core.on_warning

    @on_warning.setter
    def on_warning(self, callback: Callable[[str], None] | None) -> None:
        self.core.on_warning = callback

    def set_transform(self, transform: Any, authority: str = "default_authority") -> bool:
        """Store a geometry_msgs/TransformStamped.

        Args:
            transform: The message; frame_id is the parent, child_frame_id the frame it places.
            authority: Node that broadcast it.

        Returns:
            Whether it was stored; if not, `on_warning` was given the reason.
        """
        return self._store(transform, authority, static=False)

    def set_transform_static(self, transform: Any, authority: str = "default_authority") -> bool:
        """Store a geometry_msgs/TransformStamped that holds at every time."""
        return self._store(transform, authority, static=True)

    def lookup_transform(self, target: str, source: str, time: Time = LATEST) -> Any:
        """Transform that takes coordinates in `source` to coordinates in `target`.

        Args:
            target: Frame to express the result in (a).
            source: Frame the data is in (b).
            time: When; the latest common time if `Time(0)`.

        Returns:
            T_ab as a geometry_msgs/TransformStamped: translation [m], rotation xyzw.

        Raises:
            InvalidArgumentException: A name is empty or starts with a slash.
            LookupException: A name is unknown, or the tree has a loop.
            ConnectivityException: Both exist, in two trees.
            ExtrapolationException: `time` lies outside the stored data.
            TypeError: `time` is a bare number.
        """
        try:
            found = self.core.lookup(target, source, time=nanoseconds_of(time))
        except TransformException as error:
            teach(error, self.core)
            raise
        return self._message(found, target, source)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> Any:
        """Where `source` was at `source_time`, seen from where `target` was at `target_time`.

        Args:
            target_frame: Frame of the result (a).
            target_time: Time of the target.
            source_frame: Frame of the data (b).
            source_time: Time of the source.
            fixed_frame: Frame that is taken not to have moved in between.

        Returns:
            T_ab as a geometry_msgs/TransformStamped.

        Raises:
            TransformException: As `lookup_transform`.
        """
        try:
            found = self.core.lookup_full(
                target_frame,
                source_frame,
                target_time=nanoseconds_of(target_time),
                source_time=nanoseconds_of(source_time),
                fixed=fixed_frame,
            )
        except TransformException as error:
            teach(error, self.core)
            raise
        return self._message(found, target_frame, source_frame)

    def can_transform(self, target: str, source: str, time: Time = LATEST) -> bool:
        """Whether `lookup_transform` would answer."""
        return self.can_transform_core(target, source, time)[0]

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> bool:
        """Whether `lookup_transform_full` would answer."""
        return self.can_transform_full_core(
            target_frame, target_time, source_frame, source_time, fixed_frame
        )[0]

    def can_transform_core(self, target: str, source: str, time: Time) -> tuple[bool, str]:
        """Whether `lookup_transform` would answer, and if not, tf's reason (may be empty)."""
        return self.core.can_transform(target, source, time=nanoseconds_of(time))

    def can_transform_full_core(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> tuple[bool, str]:
        """Whether `lookup_transform_full` would answer, and if not, tf's reason."""
        return self.core.can_transform_full(
            target_frame,
            source_frame,
            target_time=nanoseconds_of(target_time),
            source_time=nanoseconds_of(source_time),
            fixed=fixed_frame,
        )

    lookup_transform_core = lookup_transform
    lookup_transform_full_core = lookup_transform_full

    def get_latest_common_time(self, target: str, source: str) -> Time:
        """Newest time at which the whole way between two frames has data; 0 if all is static.

        Raises:
            TransformException: As `lookup_transform`.
        """
        try:
            return Time.from_nsec(self.core.latest_common_time(target, source))
        except TransformException as error:
            teach(error, self.core)
            raise

    def all_frames_as_string(self) -> str:
        """One line per frame that ever had a parent."""
        return self.core.all_frames_as_string()

    def all_frames_as_yaml(self) -> str:
        """Parent, broadcaster, rate and stamps of each frame that has data."""
        return self.core.all_frames_as_yaml()

    def clear(self) -> None:
        """Forget the transforms of moving frames; names and static transforms stay."""
        self.core.clear()

    def _allFramesAsDot(self, time: Time = LATEST) -> str:  # noqa: N802 - tf2's name
        return self.core.all_frames_as_dot(nanoseconds_of(time) / 1e9)

    def _frameExists(self, frame: str) -> bool:  # noqa: N802 - tf2's name
        return self.core.frame_exists(frame)

    def _getFrameStrings(self) -> list[str]:  # noqa: N802 - tf2's name
        return self.core.frame_strings

    def _chain(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> list[str]:
        try:
            return self.core.chain(
                target_frame,
                source_frame,
                target_time=nanoseconds_of(target_time),
                source_time=nanoseconds_of(source_time),
                fixed=fixed_frame,
            )
        except TransformException as error:
            teach(error, self.core)
            raise

    def _store(self, transform: Any, authority: str, *, static: bool) -> bool:
        p, q = transform.transform.translation, transform.transform.rotation
        return self.core.set_transform(
            transform.header.frame_id,
            transform.child_frame_id,
            translation=(float(p.x), float(p.y), float(p.z)),
            rotation=(float(q.x), float(q.y), float(q.z), float(q.w)),
            stamp=nanoseconds_of(transform.header.stamp),
            authority=authority,
            static=static,
        )

    def _message(self, found: StampedTransform, target: str, source: str) -> Any:
        message: Any = self._transform_stamped()
        message.header.stamp = Time.from_nsec(found.stamp)
        message.header.frame_id = target
        message.child_frame_id = source
        p, q = message.transform.translation, message.transform.rotation
        p.x, p.y, p.z = found.translation
        q.x, q.y, q.z, q.w = found.rotation
        return message


def nanoseconds_of(time: object) -> int:
    """Nanoseconds of a Time, a Duration, or anything that has `to_sec`.

    Raises:
        TypeError: It is a bare number or no time at all.
    """
    if isinstance(time, Time | Duration):
        return time.to_nsec()
    to_sec = getattr(time, "to_sec", None)
    if to_sec is not None:
        return round(float(to_sec()) * 1e9)
    error = TypeError("time must have a to_sec method, e.g. rospy.Time or rospy.Duration")
    error.add_note(
        f"You gave {time!r}, a {type(time).__name__}; for seconds write rospy.Time(...)."
    )
    raise error
