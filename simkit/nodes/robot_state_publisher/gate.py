"""Which JointState messages become transforms: those that bring something new, not too often."""

from __future__ import annotations

from collections.abc import Sequence


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
    """Lets something be said at most once in a while.

    Args:
        seconds: How long it is silent after it was said.
    """

    def __init__(self, seconds: int) -> None:
        self._pause_ns = seconds * 10**9
        self._said_ns: int | None = None

    def permits(self, now_ns: int) -> bool:
        """Whether it may be said now; if so, it counts as said."""
        said = self._said_ns
        if said is not None and said <= now_ns < said + self._pause_ns:
            return False
        self._said_ns = now_ns
        return True
