"""The buffer of a node: lookups that can wait for their transform, in virtual time."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simkit.graph.process.client import looking
from simkit.msgs import Duration, Time

from .buffer_interface import NO_TIMEOUT, BufferInterface

if TYPE_CHECKING:
    from simkit.ros1 import rospy
    from simkit.ros1.tf2_py.buffer_core import BufferCore, require_names
else:
    import rospy
    from tf2_py.buffer_core import BufferCore, require_names

_POLLS = 0.01
"Share of the timeout between two looks."
_BACKWARD_JUMP = Duration(3)
"A clock that jumps back further than this ends a wait."


class Buffer(BufferCore, BufferInterface):
    """Transforms of the last seconds; a `TransformListener` fills it.

    Args:
        cache_time: How long a moving frame is remembered; 10 s if None.
        debug: Taken for tf2_ros' sake: the service `~tf2_frames` is not offered here, and
            view_frames listens to the topics.

    Source:
        `tf2_ros.Buffer`: a wait looks every hundredth of its timeout.
    """

    def __init__(self, cache_time: Duration | None = None, debug: bool = True) -> None:
        BufferCore.__init__(self, cache_time)
        BufferInterface.__init__(self)

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = NO_TIMEOUT
    ) -> Any:
        """Pose of `source_frame` seen from `target_frame`.

        Args:
            target_frame: Frame of the observer.
            source_frame: Frame that is observed.
            time: When; `rospy.Time(0)` for the latest.
            timeout: How long to wait for the transform at most.

        Returns:
            A geometry_msgs/TransformStamped: translation [m], rotation xyzw.

        Raises:
            InvalidArgumentException: A name is empty or starts with a slash.
            LookupException: A name is unknown, or the tree has a loop.
            ConnectivityException: The frames lie in two trees.
            ExtrapolationException: `time` lies outside the stored data.
            TypeError: A time is a bare number.
        """
        self._wait(self._buffer.can_transform_core, (target_frame, source_frame, time), timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
    ) -> Any:
        """Where `source_frame` was at `source_time`, seen from `target_frame` at `target_time`.

        `fixed_frame` is a frame that did not move in between, mostly the world.

        Raises:
            TransformException: As `lookup_transform`.
        """
        question = (target_frame, target_time, source_frame, source_time, fixed_frame)
        self._wait(self._buffer.can_transform_full_core, question, timeout)
        return self.lookup_transform_full_core(*question)

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = NO_TIMEOUT,
        return_debug_tuple: bool = False,
    ) -> Any:
        """Whether `lookup_transform` would answer, within the timeout.

        Args:
            target_frame: Frame of the observer.
            source_frame: Frame that is observed.
            time: When.
            timeout: How long to wait at most.
            return_debug_tuple: Give (0 or 1, reason) instead.
        """
        self._wait(self._buffer.can_transform_core, (target_frame, source_frame, time), timeout)
        answer = self.can_transform_core(target_frame, source_frame, time)
        return answer if return_debug_tuple else answer[0]

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = NO_TIMEOUT,
        return_debug_tuple: bool = False,
    ) -> Any:
        """Whether `lookup_transform_full` would answer, within the timeout."""
        question = (target_frame, target_time, source_frame, source_time, fixed_frame)
        self._wait(self._buffer.can_transform_full_core, question, timeout)
        answer = self.can_transform_full_core(*question)
        return answer if return_debug_tuple else answer[0]

    def _wait(
        self,
        can_transform: Callable[..., tuple[bool, str]],
        question: tuple[Any, ...],
        timeout: Duration,
    ) -> None:
        """Ask again and again until the answer is yes or the time is up.

        Raises:
            TypeError: `timeout` is a bare number, or a name is no text.
        """
        if not isinstance(timeout, Duration):
            raise TypeError(
                f"timeout must be a rospy.Duration, not {timeout!r}: rospy.Duration({timeout!r})"
            )
        if timeout == NO_TIMEOUT:
            return
        require_names(*question[::2] if len(question) == 5 else question[:2])
        start, period = rospy.Time.now(), timeout * _POLLS
        with looking(period.to_nsec(), (start + timeout).to_nsec()):
            while not can_transform(*question)[0]:
                now = rospy.Time.now()
                if now >= start + timeout or start > now + _BACKWARD_JUMP:
                    return
                rospy.sleep(period)
