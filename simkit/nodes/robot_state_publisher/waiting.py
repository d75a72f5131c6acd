"""A note of the kit's own: after two seconds, which joints still have no position, and why.

The original is silent here, and RViz then shows "No transform from [torso]". The note is a warning
on rosout that begins with `hint:`; it comes once.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from simkit.msgs import Duration

PATIENCE = Duration(2)
"""How long the node waits before it gives the hint, in virtual time."""


class Waiting:
    """Notes which joints have had a position.

    Args:
        joints: Names of the joints that move.
    """

    def __init__(self, joints: Iterable[str]) -> None:
        self._joints = tuple(joints)
        self._moved: set[str] = set()
        self._heard = 0
        self._unstamped = 0

    def heard(self, *, stamped: bool) -> None:
        """A message has come."""
        self._heard += 1
        self._unstamped += not stamped

    def moved(self, joints: Iterable[str]) -> None:
        """These joints have a position now."""
        self._moved.update(joints)

    def hint(self, topic: str, publishers: Sequence[str]) -> str | None:
        """What is missing, in a sentence; None if nothing is.

        Args:
            topic: Resolved name of the topic with the joints' positions.
            publishers: Names of the nodes that publish on it.
        """
        left = [name for name in self._joints if name not in self._moved]
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
        if not self._heard:
            return f"hint: {who} has not said anything on {topic} yet, so {lost}"
        if self._unstamped == self._heard:
            return (
                f"hint: the messages of {who} on {topic} have no time stamp, so {lost}: "
                "set header.stamp to rospy.Time.now()"
            )
        return f"hint: {who} on {topic} gives no position for some joints: {lost}"
