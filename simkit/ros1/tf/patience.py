"""How a question that has no answer yet lets virtual time pass."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from simkit.graph.process.client import let_time_pass, looking
from simkit.msgs import Duration
from simkit.tf.errors import TransformException
from simkit.tf.hints import attach

if TYPE_CHECKING:
    from simkit.ros1 import rospy
else:
    import rospy

_POLLS = 0.01
"Share of the timeout between two looks."


@contextmanager
def time_passes_on_failure() -> Iterator[None]:
    """Let a millisecond pass when the lookup inside fails: a loop may try until it succeeds."""
    try:
        yield
    except TransformException:
        let_time_pass()
        raise


def noticing(answer: bool) -> bool:
    """The answer; a "no" lets a millisecond pass, as a loop may ask until it is a "yes"."""
    if not answer:
        let_time_pass()
    return answer


def wait_until(
    question: Callable[[], tuple[bool, str]],
    timeout: Duration,
    *,
    frames: tuple[str, str],
    lookup: Callable[[], object],
) -> None:
    """Ask again and again until the answer is yes.

    Args:
        question: Gives the answer, and tf's reason if it is no.
        timeout: How long to wait at most.
        frames: Target and source as the caller wrote them.
        lookup: The lookup that would succeed after a yes; what it says else is the hint.

    Raises:
        TransformException: The answer stayed no; the text is the last reason.
        TypeError: `timeout` is no duration.

    Source:
        tf2_ros `Buffer.can_transform`: it looks every hundredth of the timeout.
    """
    if not isinstance(timeout, Duration):
        raise TypeError(f"timeout must be a rospy.Duration, not {timeout!r}")
    end = rospy.get_rostime() + timeout
    possible, reason = question()
    period = timeout * _POLLS
    with looking(period.to_nsec(), end.to_nsec()):
        while not possible and rospy.get_rostime() < end:
            rospy.sleep(period)
            possible, reason = question()
    if not possible:
        target, source = frames
        let_time_pass()
        error = TransformException(reason or f'no such transformation: "{source}" -> "{target}"')
        attach(error, _hint_of(lookup))
        raise error


def _hint_of(lookup: Callable[[], object]) -> str:
    try:
        lookup()
    except TransformException as error:
        return error.hint
    return ""
