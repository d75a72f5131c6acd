"""What checks of the turtle exercises ask again and again: where a turtle is, and which transforms were heard."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from simkit import Simulation

TURTLE_STEP = 0.016
"""Virtual time between two poses of turtlesim [s]."""
_TF_TOPICS = ("/tf", "/tf_static")


@dataclass(frozen=True, slots=True, kw_only=True)
class TurtlePose:
    """Where turtlesim had a turtle, in the frame world."""

    time: float
    """Virtual time [s]."""
    x: float
    """[m]"""
    y: float
    """[m]"""
    theta: float
    """Heading from the x axis, counter-clockwise [rad]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeardTransform:
    """One transform as it was heard on /tf or /tf_static."""

    time: float
    """Virtual time at which it was heard [s]."""
    stamp: float
    """Its own stamp [s]."""
    parent: str
    """Parent frame, without a leading slash."""
    child: str
    """Child frame, without a leading slash."""
    translation: tuple[float, float, float]
    """Position of the child in the parent [m]."""
    rotation: tuple[float, float, float, float]
    """Quaternion xyzw."""


class TurtleWatch:
    """Records the poses of turtlesim, and all transforms, from its creation on.

    Args:
        sim: A simulation in which turtlesim runs.
        turtles: Names of the turtles.
    """

    def __init__(self, sim: Simulation, turtles: Sequence[str] = ("turtle1",)) -> None:
        topics = {f"/{turtle}/pose": "turtlesim/Pose" for turtle in turtles}
        self._recording = sim.record({**topics, **dict.fromkeys(_TF_TOPICS, "tf2_msgs/TFMessage")})

    def poses(self, turtle: str = "turtle1") -> list[TurtlePose]:
        """Every pose that turtlesim published of a turtle."""
        return [
            TurtlePose(time=time.to_sec(), x=pose.x, y=pose.y, theta=pose.theta)
            for time, pose in _messages(self._recording, f"/{turtle}/pose")
        ]

    def transforms(self) -> list[HeardTransform]:
        """Every transform that was heard, moving ones and static ones, in order."""
        heard = [
            _heard(time.to_sec(), transform)
            for topic in _TF_TOPICS
            for time, message in _messages(self._recording, topic)
            for transform in message.transforms
        ]
        return sorted(heard, key=lambda transform: transform.time)

    def of_frame(self, child: str) -> list[HeardTransform]:
        """The transforms of one child frame."""
        return [transform for transform in self.transforms() if transform.child == child]

    def pose_at(self, time: float, turtle: str = "turtle1") -> TurtlePose | None:
        """The pose that turtlesim had published last at a time [s]; None before the first."""
        return last_before(self.poses(turtle), time)


def last_before(poses: Sequence[TurtlePose], time: float) -> TurtlePose | None:
    """The last of some poses at a time [s]; None before the first.

    Args:
        poses: Poses of one turtle, oldest first.
        time: Virtual time [s].
    """
    index = bisect_right([pose.time for pose in poses], time + 1e-6)
    return poses[index - 1] if index else None


def yaw_of(rotation: Sequence[float]) -> float:
    """Heading of a quaternion xyzw, normalised first [rad]."""
    x, y, z, w = rotation
    return math.atan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z)


def turned(angle: float, other: float) -> float:
    """How far apart two angles are, full turns left out [rad]."""
    return abs(math.remainder(angle - other, math.tau))


def _messages(recording: Any, topic: str) -> list[Any]:
    return list(recording[topic])


def _heard(time: float, transform: Any) -> HeardTransform:
    move, turn = transform.transform.translation, transform.transform.rotation
    return HeardTransform(
        time=time,
        stamp=transform.header.stamp.to_sec(),
        parent=transform.header.frame_id.removeprefix("/"),
        child=transform.child_frame_id.removeprefix("/"),
        translation=(move.x, move.y, move.z),
        rotation=(turn.x, turn.y, turn.z, turn.w),
    )
