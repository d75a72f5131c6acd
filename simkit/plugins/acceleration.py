"""How fast wheels may become faster."""

from __future__ import annotations

CLOSE = 0.01
"""A wheel that is as near to its target as that counts as being there [m/s]."""


class SpeedRamp:
    """What two motors are told on the way to the speeds that are asked for.

    As soon as one of the wheels is near its target, both are told theirs; so a wheel may jump, and if
    one has nothing to change, the other one does at once.

    Args:
        limit: Acceleration of a rim [m/s^2]; none if 0.

    Source:
        gazebo_ros_diff_drive `UpdateChild`.
    """

    def __init__(self, limit: float) -> None:
        self._limit = limit
        self._told = (0.0, 0.0)

    def next_speeds(
        self, targets: tuple[float, float], measured: tuple[float, float], seconds: float
    ) -> tuple[float, float]:
        """Speeds of the rims to tell the motors now, left and right [m/s].

        Args:
            targets: What is asked for [m/s].
            measured: What the wheels do [m/s].
            seconds: Time since the last call [s].
        """
        missing = (targets[0] - measured[0], targets[1] - measured[1])
        if self._limit == 0.0 or min(abs(missing[0]), abs(missing[1])) < CLOSE:
            return targets  # what was told stays as it was: the next ramp goes on from there
        most = self._limit * seconds
        left, right = (
            told + min(max(more, -most), most)
            for told, more in zip(self._told, missing, strict=True)
        )
        self._told = (left, right)
        return self._told

    def reset(self) -> None:
        """Forget what was told."""
        self._told = (0.0, 0.0)
