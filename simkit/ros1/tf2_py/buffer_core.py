"""tf2's BufferCore: lookups at once, without waiting, with names that have no leading slash."""

# ruff: noqa: N802 - the names are tf2's

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from simkit.graph.process.client import let_time_pass
from simkit.msgs import Duration, Time
from simkit.tf.buffer import Buffer, nanoseconds_of
from simkit.tf.errors import TransformException

if TYPE_CHECKING:
    from simkit.ros1 import rospy
else:
    import rospy

_BAD_NAME = "Invalid argument"
"Beginning of tf2's warning of an invalid frame name."


class BufferCore:
    """Stores stamped transforms between frames, and answers what lies between any two.

    Each failed lookup lets a millisecond pass, so that a loop of `except: continue` ends.

    Args:
        cache_time: How long a moving frame is remembered; 10 s if None.

    Raises:
        TypeError: `cache_time` is a bare number.
    """

    def __init__(self, cache_time: Duration | None = None) -> None:
        length = None if cache_time is None else Duration.from_nsec(nanoseconds_of(cache_time))
        self._warned: set[str] = set()
        self._buffer = Buffer(length, on_warning=self._warn)

    def set_transform(self, transform: Any, authority: str) -> None:
        """Store a geometry_msgs/TransformStamped; an invalid one is refused with a warning."""
        self._buffer.set_transform(transform, authority)

    def set_transform_static(self, transform: Any, authority: str) -> None:
        """Store a geometry_msgs/TransformStamped that holds at every time."""
        self._buffer.set_transform_static(transform, authority)

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Time) -> Any:
        """Pose of `source_frame` seen from `target_frame`.

        Args:
            target_frame: Frame of the observer.
            source_frame: Frame that is observed.
            time: When; `rospy.Time(0)` for the latest.

        Returns:
            A geometry_msgs/TransformStamped: translation [m], rotation xyzw.

        Raises:
            InvalidArgumentException: A name is empty or starts with a slash.
            LookupException: A name is unknown, or the tree has a loop.
            ConnectivityException: The frames lie in two trees.
            ExtrapolationException: `time` lies outside the stored data.
            TypeError: `time` is a bare number, or a name is no text.
        """
        require_names(target_frame, source_frame)
        with time_passes_on_failure():
            return self._buffer.lookup_transform(target_frame, source_frame, time)

    def lookup_transform_full_core(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> Any:
        """Where `source_frame` was at `source_time`, seen from `target_frame` at `target_time`.

        `fixed_frame` is a frame that did not move in between, mostly the world.

        Raises:
            TransformException: As `lookup_transform_core`.
        """
        require_names(target_frame, source_frame, fixed_frame)
        with time_passes_on_failure():
            return self._buffer.lookup_transform_full(
                target_frame, target_time, source_frame, source_time, fixed_frame
            )

    def can_transform_core(
        self, target_frame: str, source_frame: str, time: Time
    ) -> tuple[int, str]:
        """1 if `lookup_transform_core` would answer, else 0 and the reason."""
        require_names(target_frame, source_frame)
        return _noticed(self._buffer.can_transform_core(target_frame, source_frame, time))

    def can_transform_full_core(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> tuple[int, str]:
        """1 if `lookup_transform_full_core` would answer, else 0 and the reason."""
        require_names(target_frame, source_frame, fixed_frame)
        return _noticed(
            self._buffer.can_transform_full_core(
                target_frame, target_time, source_frame, source_time, fixed_frame
            )
        )

    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Time:
        """Newest time at which the whole way between two frames has data; 0 if all is static.

        Raises:
            TransformException: A name is unknown, or no way joins the frames.
        """
        require_names(target_frame, source_frame)
        with time_passes_on_failure():
            common = self._buffer.get_latest_common_time(target_frame, source_frame)
        return rospy.Time(common.secs, common.nsecs)

    def all_frames_as_string(self) -> str:
        """One line per frame that ever had a parent."""
        return self._buffer.all_frames_as_string()

    def all_frames_as_yaml(self) -> str:
        """Parent, broadcaster, rate and stamps of each frame that has data."""
        return self._buffer.all_frames_as_yaml()

    def clear(self) -> None:
        """Forget the transforms of moving frames; names and static transforms stay."""
        self._buffer.clear()

    def _chain(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> list[str]:
        with time_passes_on_failure():
            return self._buffer._chain(
                target_frame, target_time, source_frame, source_time, fixed_frame
            )

    def _frameExists(self, frame: str) -> bool:
        return self._buffer._frameExists(frame)

    def _getFrameStrings(self) -> list[str]:
        return self._buffer._getFrameStrings()

    def _allFramesAsDot(self, time: Time | None = None) -> str:
        return self._buffer._allFramesAsDot(Time(0) if time is None else time)

    def _warn(self, text: str) -> None:
        # A wait asks a hundred times: an invalid name is warned of once.
        if not text.startswith(_BAD_NAME) or text not in self._warned:
            self._warned.add(text)
            rospy.logwarn(text)


@contextmanager
def time_passes_on_failure() -> Iterator[None]:
    """Let a millisecond pass when the lookup inside fails: a loop may try until it succeeds."""
    try:
        yield
    except TransformException:
        let_time_pass()
        raise


def _noticed(answer: tuple[bool, str]) -> tuple[int, str]:
    """The answer as tf2 gives it; a "no" lets a millisecond pass, as a loop may ask until it is a "yes"."""
    possible, reason = answer
    if not possible:
        let_time_pass()
    return int(possible), reason


def require_names(*frames: object) -> None:
    """Refuse a frame name that is not text.

    Raises:
        TypeError: Says which, and the order of the arguments.
    """
    for number, frame in enumerate(frames, start=1):
        if not isinstance(frame, str):
            raise TypeError(
                f"frame {number} must be str, not {type(frame).__name__}: {frame!r}; the order is "
                "(target_frame, source_frame, time), or with two times "
                "(target_frame, target_time, source_frame, source_time, fixed_frame)"
            )
