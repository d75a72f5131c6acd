"""What is remembered of JointState messages: which become transforms, and which joints have no position yet.

The original is silent about the latter, and RViz then shows "No transform from [torso]". The note of the kit's
own is a warning on rosout that begins with `hint:`; it comes once, after two seconds.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from simkit.msgs import Duration

PATIENCE = Duration(2)
"""How long the node waits before it gives the hint, in virtual time."""


class PublishGate:
    """Keeps the pace of /tf.

    A message counts if its stamp is at least one interval later than the last message that counted
    for that one of its joints which has waited longest. So 60 messages a second become 30 with the
    usual interval of 20 ms; 100 become 50, and fewer (about 39) if their stamps jitter.

    Args:
        interval_ns: Time between two messages that count [ns].
        ignore_stamps: Whether every message counts.
    """

    def __init__(self, interval_ns: int, *, ignore_stamps: bool = False) -> None:
        self._interval_ns = interval_ns
        self._ignore_stamps = ignore_stamps
        self._last_ns: dict[str, int] = {}

    def counts(self, joints: Sequence[str], *, stamp_ns: int, now_ns: int) -> bool:
        """Whether a message becomes transforms; if so, it is noted.

        Args:
            joints: The joints that it names.
            stamp_ns: Its stamp [ns]; without one (0) it never counts once time has begun.
            now_ns: Virtual time [ns].
        """
        oldest = min([now_ns, *(self._last_ns.get(name, 0) for name in joints)])
        if not self._ignore_stamps and stamp_ns < oldest + self._interval_ns:
            return False
        self._last_ns.update(dict.fromkeys(joints, stamp_ns))
        return True

    def forget(self) -> None:
        """Let the next message count: the clock was set back."""
        self._last_ns.clear()


class Throttle:
    """Lets a line be logged at most once in a while.

    Args:
        seconds: Least time between two lines [s].
    """

    def __init__(self, seconds: int) -> None:
        self._pause_ns = seconds * 10**9
        self._last_ns: int | None = None

    def permits(self, now_ns: int) -> bool:
        """Whether the line may be logged now; if so, it counts as logged."""
        last = self._last_ns
        if last is not None and last <= now_ns < last + self._pause_ns:
            return False
        self._last_ns = now_ns
        return True


class MissingJoints:
    """Notes which joints have had a position.

    Args:
        joints: Names of the joints that move.
    """

    def __init__(self, joints: Iterable[str]) -> None:
        self._joints = tuple(joints)
        self._positioned: set[str] = set()
        self._messages = 0
        self._unstamped = 0

    def count_message(self, *, stamped: bool) -> None:
        """A message has come."""
        self._messages += 1
        self._unstamped += not stamped

    def note_positions(self, joints: Iterable[str]) -> None:
        """These joints have a position now."""
        self._positioned.update(joints)

    def hint(self, topic: str, publishers: Sequence[str]) -> str | None:
        """What is missing, in a sentence; None if nothing is.

        Args:
            topic: Resolved name of the topic with the joints' positions.
            publishers: Names of the nodes that publish on it.
        """
        left = [name for name in self._joints if name not in self._positioned]
        if not left:
            return None
        names = ", ".join(left)
        lost = f"{names} {'has' if len(left) == 1 else 'have'} no position, and no transform"
        who = ", ".join(publishers)
        if not publishers:
            return (
                f"hint: nobody publishes {topic}, so {lost}: "
                "start joint_state_publisher, or joint_state_publisher_gui for sliders"
            )
        if not self._messages:
            return f"hint: {who} has not said anything on {topic} yet, so {lost}"
        if self._unstamped == self._messages:
            return (
                f"hint: the messages of {who} on {topic} have no time stamp, so {lost}: "
                "set header.stamp to rospy.Time.now()"
            )
        return f"hint: {who} on {topic} gives no position for some joints: {lost}"
