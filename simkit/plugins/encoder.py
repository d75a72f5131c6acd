"""Odometry of two wheels: where a robot would be if no wheel ever slipped."""

from __future__ import annotations

import math

from simkit.geometry import Transform
from simkit.plugins.odometry import Motion


class EncoderOdometry:
    """Adds up what two wheels roll; it begins at the origin, wherever the robot stands.

    Args:
        separation: Distance of the wheels that it believes in [m].

    Source:
        gazebo_ros_diff_drive `UpdateOdometryEncoder`, which follows Siegwart, Nourbakhsh and Scaramuzza,
        Introduction to Autonomous Mobile Robots.
    """

    def __init__(self, separation: float) -> None:
        self._separation = separation
        self._x, self._y, self._yaw = 0.0, 0.0, 0.0
        self._speed, self._turning = 0.0, 0.0

    def advance(self, left: float, right: float, seconds: float) -> None:
        """Take account of a step.

        Args:
            left: How far the rim of the left wheel has turned in it [m].
            right: The same of the right wheel.
            seconds: Time of the step [s].
        """
        way, turn = (left + right) / 2.0, (right - left) / self._separation
        dx = way * math.cos(self._yaw + turn / 2.0)
        dy = way * math.sin(self._yaw + turn / 2.0)
        self._x += dx
        self._y += dy
        self._yaw += turn
        # Gazebo's is a length as well: going backwards, it is not negative.
        self._speed = math.sqrt(dx * dx + dy * dy) / seconds
        self._turning = turn / seconds

    def reset(self) -> None:
        """Back to the origin, at rest."""
        self._x, self._y, self._yaw = 0.0, 0.0, 0.0
        self._speed, self._turning = 0.0, 0.0

    @property
    def motion(self) -> Motion:
        """Where the robot should be by now, and how fast."""
        half = self._yaw / 2.0
        rotation = (0.0, 0.0, math.sin(half), math.cos(half))
        return Motion(
            pose=Transform((self._x, self._y, 0.0), rotation),
            linear=(self._speed, 0.0),
            turning=self._turning,
        )
