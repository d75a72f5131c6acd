"""Lookups in the form of tf, over the buffer of tf2_ros: lists of numbers, and names that may start with a slash."""

# ruff: noqa: N802 - the names are tf's

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simkit.geometry import Vector
from simkit.graph.process.client import let_time_pass
from simkit.msgs import Duration, Time
from simkit.tf.admission import without_slash
from simkit.tf.errors import TransformException
from simkit.tf.frame_report import frame_reports
from simkit.tf.hints import attach

from .twist import twist_between

if TYPE_CHECKING:
    from simkit.ros1 import tf2_ros
    from simkit.ros1.tf2_py.buffer_core import time_passes_on_failure
else:
    import tf2_ros
    from tf2_py.buffer_core import time_passes_on_failure


class Transformer:
    """A buffer of transforms under tf's names.

    Each failed question lets a millisecond pass, so that a loop of `except: continue` ends.

    Args:
        interpolate: Accepted as in tf; transforms are always interpolated.
        cache_time: How long a moving frame is remembered; 10 s if None.
    """

    def __init__(self, interpolate: bool = True, cache_time: Duration | None = None) -> None:
        self._buffer = tf2_ros.Buffer(cache_time, debug=False)
        self._using_dedicated_thread = False

    def lookupTransform(
        self, target_frame: str, source_frame: str, time: Time
    ) -> tuple[list[float], list[float]]:
        """Pose of `source_frame` seen from `target_frame`.

        Args:
            target_frame: Frame of the observer.
            source_frame: Frame that is observed.
            time: When; `rospy.Time(0)` for the latest.

        Returns:
            Translation [x, y, z] [m], and rotation [x, y, z, w].

        Raises:
            LookupException: A name is unknown.
            ConnectivityException: The frames lie in two trees.
            ExtrapolationException: `time` lies outside the stored data.
        """
        question = _without_slashes(target_frame, source_frame, time)
        return _as_lists(self._buffer.lookup_transform_core(*question))

    def lookupTransformFull(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> tuple[list[float], list[float]]:
        """Where `source_frame` was at `source_time`, seen from `target_frame` at `target_time`.

        `fixed_frame` is a frame that did not move in between, mostly the world.

        Returns:
            Translation [x, y, z] [m], and rotation [x, y, z, w].

        Raises:
            TransformException: As `lookupTransform`.
        """
        question = _without_slashes(
            target_frame, target_time, source_frame, source_time, fixed_frame
        )
        return _as_lists(self._buffer.lookup_transform_full_core(*question))

    def canTransform(self, target_frame: str, source_frame: str, time: Time) -> bool:
        """Whether `lookupTransform` would answer."""
        question = _without_slashes(target_frame, source_frame, time)
        return bool(self._buffer.can_transform_core(*question)[0])

    def canTransformFull(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> bool:
        """Whether `lookupTransformFull` would answer."""
        question = _without_slashes(
            target_frame, target_time, source_frame, source_time, fixed_frame
        )
        return bool(self._buffer.can_transform_full_core(*question)[0])

    def waitForTransform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration,
        polling_sleep_duration: Duration | None = None,
    ) -> None:
        """Block until `lookupTransform` would answer.

        Args:
            target_frame: Frame of the observer.
            source_frame: Frame that is observed.
            time: When.
            timeout: How long to wait at most.
            polling_sleep_duration: Accepted as in tf.

        Raises:
            TransformException: It did not come in time; the text says what was missing.
        """
        question = _without_slashes(target_frame, source_frame, time)
        self._wait(self._buffer.can_transform, question, timeout, (source_frame, target_frame))

    def waitForTransformFull(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration,
        polling_sleep_duration: Duration | None = None,
    ) -> None:
        """Block until `lookupTransformFull` would answer.

        Raises:
            TransformException: It did not come in time; the text says what was missing.
        """
        question = _without_slashes(
            target_frame, target_time, source_frame, source_time, fixed_frame
        )
        self._wait(self._buffer.can_transform_full, question, timeout, (source_frame, target_frame))

    def getLatestCommonTime(self, source_frame: str, dest_frame: str) -> Time:
        """Newest time at which a lookup between two frames would answer.

        Raises:
            TransformException: A name is unknown, or no way joins the frames.
        """
        return self._buffer.get_latest_common_time(*_without_slashes(source_frame, dest_frame))

    def chain(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
    ) -> list[str]:
        """Frames on the way from source over fixed to target; no slash is dropped here."""
        return self._buffer._chain(
            target_frame, target_time, source_frame, source_time, fixed_frame
        )

    def frameExists(self, frame_id: str) -> bool:
        """Whether a frame has a parent and data: a root does not exist for tf."""
        exists = frame_id in self.getFrameStrings()
        if not exists:
            let_time_pass()
        return exists

    def getFrameStrings(self) -> list[str]:
        """Frames that have a parent and data."""
        return [report.name for report in frame_reports(self._buffer._buffer.core.frames)]

    def allFramesAsString(self) -> str:
        """One line per frame that ever had a parent."""
        return self._buffer.all_frames_as_string()

    def allFramesAsDot(self, current_time: Time | None = None) -> str:
        """The tree in graphviz' language."""
        return self._buffer._allFramesAsDot(current_time)

    def setTransform(self, transform: Any, authority: str = "default_authority") -> None:
        """Store a geometry_msgs/TransformStamped."""
        self._buffer.set_transform(transform, authority)

    def setTransformStatic(self, transform: Any, authority: str = "default_authority") -> None:
        """Store a geometry_msgs/TransformStamped that holds at every time."""
        self._buffer.set_transform_static(transform, authority)

    def lookupTwist(
        self,
        tracking_frame: str,
        observation_frame: str,
        time: Time,
        averaging_interval: Duration,
    ) -> tuple[Vector, Vector]:
        """Velocity of the origin of `tracking_frame`; as `lookupTwistFull`."""
        return self.lookupTwistFull(
            tracking_frame,
            observation_frame,
            observation_frame,
            (0, 0, 0),
            tracking_frame,
            time,
            averaging_interval,
        )

    def lookupTwistFull(
        self,
        tracking_frame: str,
        observation_frame: str,
        reference_frame: str,
        ref_point: Vector,
        reference_point_frame: str,
        time: Time,
        averaging_interval: Duration,
    ) -> tuple[Vector, Vector]:
        """Velocity of a point that moves with `tracking_frame`, seen from `observation_frame`.

        Args:
            tracking_frame: Frame that moves.
            observation_frame: Frame of the observer.
            reference_frame: Frame in whose axes the result is given.
            ref_point: The point (3,) [m].
            reference_point_frame: Frame in which the point is given.
            time: Middle of the interval; `rospy.Time(0)` for the latest.
            averaging_interval: Span over which positions are compared.

        Returns:
            Linear [m/s] and angular [rad/s] velocity.

        Raises:
            TransformException: As `lookupTransform`.
        """
        names = (tracking_frame, observation_frame, reference_frame, reference_point_frame)
        with time_passes_on_failure():
            return twist_between(
                self._buffer._buffer.core,
                *map(without_slash, names),
                point=ref_point,
                time=time.to_nsec(),
                interval=averaging_interval.to_nsec(),
            )

    def clear(self) -> None:
        """Forget the transforms of moving frames."""
        self._buffer.clear()

    def setUsingDedicatedThread(self, value: bool) -> None:
        """Whether transforms arrive while `waitForTransform` waits."""
        self._using_dedicated_thread = value

    def getTFPrefix(self) -> str:
        """Empty: tf2 knows no prefixes."""
        return ""

    def _wait(
        self,
        can_transform: Callable[..., Any],
        question: tuple[Any, ...],
        timeout: Duration,
        frames: tuple[str, str],
    ) -> None:
        """Wait for a yes; the hint of the error is that of the lookup, which fails as well."""
        if not self._using_dedicated_thread:
            raise TransformException(
                "cannot wait for transform without a dedicated thread that listens to incoming "
                "TF messages"
            )
        possible, reason = can_transform(*question, timeout, return_debug_tuple=True)
        if possible:
            return
        source, target = frames
        error = TransformException(reason or f'no such transformation: "{source}" -> "{target}"')
        buffer = self._buffer._buffer
        lookup = buffer.lookup_transform if len(question) == 3 else buffer.lookup_transform_full
        try:
            lookup(*question)
        except TransformException as failure:
            attach(error, failure.hint)
        raise error


def _without_slashes(*question: Any) -> tuple[Any, ...]:
    """The arguments of a question, one leading slash dropped from each frame name."""
    return tuple(without_slash(part) if isinstance(part, str) else part for part in question)


def _as_lists(transform: Any) -> tuple[list[float], list[float]]:
    p, q = transform.transform.translation, transform.transform.rotation
    return [p.x, p.y, p.z], [q.x, q.y, q.z, q.w]
