"""Angles that turn round: the short way from one to another."""

from __future__ import annotations

import math

TURN = 2.0 * math.pi


def shortest_angular_distance(start: float, end: float) -> float:
    """The short way from one angle to another [rad], more than -pi and at most pi.

    Source:
        `angles::shortest_angular_distance`; here without the rounding of its two divisions.
    """
    away = math.remainder(end - start, TURN)
    return math.pi if away == -math.pi else away


def distance_within_limits(start: float, end: float, lower: float, upper: float) -> float:
    """The shortest way to an angle, or to one that is whole turns away, without leaving the limits [rad].

    If no such angle is within the limits, it is the way to `end` itself.

    Source:
        `angles::shortest_angular_distance_with_limits`.
    """
    if not math.isfinite(lower) or not math.isfinite(upper):
        return shortest_angular_distance(start, end)
    first = math.ceil((lower - end) / TURN)
    last = math.floor((upper - end) / TURN)
    if first > last:
        return end - start
    turns = min(max(round((start - end) / TURN), first), last)
    return end + TURN * turns - start


def wraparound_offset(start: float, end: float) -> float:
    """What to add to a target angle, in whole turns, so that the way to it is the short one [rad].

    Of two ways of half a turn it is the one without an offset, towards the larger number or the smaller.

    Source:
        `wraparoundJointOffset` of joint_trajectory_controller.
    """
    way = shortest_angular_distance(start, end)
    if abs(abs(way) - math.pi) < 1e-9:
        way = abs(way) if end > start else -abs(way)
    return TURN * round((start + way - end) / TURN)


class ContinuousAngle:
    """An angle that is read again and again, and never jumps by more than half a turn.

    Args:
        first: The first reading is the one within half a turn of this [rad].

    Source:
        `DefaultRobotHWSim::readSim`, which adds the short way to what it had.
    """

    def __init__(self, first: float = 1.0) -> None:
        self.value = first
        self._turns = 0

    def read(self, angle: float) -> float:
        """The angle [rad], in the turn that continues what was read before."""
        value = angle + TURN * self._turns
        if abs(value - self.value) > math.pi:
            self._turns += round((self.value - value) / TURN)
            value = angle + TURN * self._turns
        self.value = value
        return value
