"""The driven wheels of a model, and how it moved on the floor in the last looks."""

from __future__ import annotations

import itertools
import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass

from simkit.gazebo.models import Spawned
from simkit.geometry import Transform, Vector, roll_pitch_yaw
from simkit.physics import Model, ModelJoint
from simkit.plugins.registry import tags_of
from simkit.plugins.tags import DiffDriveParameters, SkidSteerDriveParameters
from simkit.urdf.model import Cylinder, Sphere
from simkit.urdf.wheel import round_part


@dataclass(frozen=True, slots=True, kw_only=True)
class DrivenWheels:
    """Wheels that a plugin drives."""

    model: Model
    """What they are on."""
    left: tuple[ModelJoint, ...]
    """Joints of the wheels on the left."""
    right: tuple[ModelJoint, ...]
    """Joints of the wheels on the right."""
    separation: float
    """Distance of left and right that the plugin believes in [m]."""
    diameter: float
    """Diameter of the wheels that it believes in [m]."""
    torque_tag: str
    """Tag of its torque."""

    @property
    def joints(self) -> tuple[ModelJoint, ...]:
        """All of them, the left ones first."""
        return (*self.left, *self.right)

    def command(self) -> tuple[float, float]:
        """What the motors are commanded now: speed forward [m/s], and turning to the left [rad/s]."""
        return self._twist([joint.command for joint in self.left], [joint.command for joint in self.right])  # fmt: skip

    def rolled(self) -> tuple[float, float]:
        """The same, of what the wheels do."""
        return self._twist([joint.velocity for joint in self.left], [joint.velocity for joint in self.right])  # fmt: skip

    def real_separation(self) -> float:
        """Distance of left and right [m]."""
        left, right = (
            _middle([self._hub(one) for one in side]) for side in (self.left, self.right)
        )
        return math.dist(left, right)

    def real_diameter(self) -> float | None:
        """Diameter of the wheels [m]; None if they are not round, or not alike."""
        found = {self._radius(joint) for joint in self.joints}
        radius = found.pop()
        return None if found or radius is None else 2.0 * radius

    def _twist(self, left: list[float], right: list[float]) -> tuple[float, float]:
        slow, fast = (self.diameter / 2.0 * sum(one) / len(one) for one in (left, right))
        return (slow + fast) / 2.0, (fast - slow) / self.separation

    def _radius(self, joint: ModelJoint) -> float | None:
        rolling = self._round_part(joint)
        return None if rolling is None else rolling[0].radius

    def _hub(self, joint: ModelJoint) -> Vector:
        """Middle of a wheel in the world [m]: that of its round shape, else its joint."""
        rolling = self._round_part(joint)
        middle = (0.0, 0.0, 0.0) if rolling is None else rolling[1].translation
        return self.model.link_pose(joint.plan.child).apply(middle)

    def _round_part(self, joint: ModelJoint) -> tuple[Cylinder | Sphere, Transform] | None:
        shapes = self.model.plan.bodies[joint.plan.child].shapes
        return round_part((shape.solid, shape.frame) for shape in shapes)


def drive_of(spawned: Spawned) -> DrivenWheels | None:
    """The driven wheels of a model; of several drives those of the first."""
    model = spawned.model
    for plugin in spawned.plugins:
        given = plugin.parameters
        if isinstance(given, DiffDriveParameters | SkidSteerDriveParameters):
            left, right = (
                tuple(model.joint(getattr(given, field)) for field in side) for side in given.SIDES
            )
            return DrivenWheels(
                model=model,
                left=left,
                right=right,
                separation=given.wheel_separation,
                diameter=given.wheel_diameter,
                torque_tag=tags_of(type(given))[given.TORQUE].name,
            )
    return None


def _middle(points: list[Vector]) -> Vector:
    x, y, z = (sum(values) / len(points) for values in zip(*points, strict=True))
    return (x, y, z)


LOOK_S = 0.1
"""Time between two looks [s]."""
KEPT = 60
"""So many intervals are remembered."""
STEEP = 0.1
"""What moves faster up or down [m/s] falls or jumps."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Moment:
    """One look."""

    place: Vector
    """Where the model is in the world [m]."""
    yaw: float
    """Which way it looks [rad]."""
    speed: float
    """How fast it moves [m/s]."""
    spin: float
    """How fast it turns [rad/s]."""
    command: tuple[float, float]
    """The command of the wheels: speed forward [m/s], turning to the left [rad/s]."""
    rolled: tuple[float, float]
    """What they do."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Means:
    """Means over some looks, each as speed forward [m/s] and turning to the left [rad/s]."""

    command: tuple[float, float]
    """The command of the wheels."""
    rolled: tuple[float, float]
    """What they did."""
    moved: tuple[float, float]
    """What the model did."""


class Motion:
    """The last looks at a model; it forgets them when the model falls, or is put somewhere.

    Args:
        drive: Its wheels.
    """

    def __init__(self, drive: DrivenWheels) -> None:
        self.drive = drive
        """Its wheels."""
        self._moments: deque[Moment] = deque(maxlen=KEPT + 1)

    def look(self) -> None:
        """Look once more."""
        pose, (linear, angular) = self.drive.model.pose, self.drive.model.twist
        moment = Moment(
            place=pose.translation,
            yaw=roll_pitch_yaw(pose.rotation)[2],
            speed=math.hypot(*linear),
            spin=math.hypot(*angular),
            command=self.drive.command(),
            rolled=self.drive.rolled(),
        )
        if self._moments and _jumps(self._moments[-1], moment):
            self._moments.clear()
        self._moments.append(moment)

    def last(self, looks: int) -> list[Moment]:
        """The moments around the last so many intervals, the oldest first; none if there were not as many."""
        if len(self._moments) <= looks:
            return []
        return [self._moments[number] for number in range(-looks - 1, 0)]


def means(moments: Sequence[Moment]) -> Means:
    """What the time between some moments was like."""
    seconds = (len(moments) - 1) * LOOK_S
    ways = [_step(one, other) for one, other in itertools.pairwise(moments)]
    return Means(
        command=_mean([one.command for one in moments[:-1]]),
        rolled=_mean([one.rolled for one in moments[1:]]),
        moved=(sum(way for way, _ in ways) / seconds, sum(turn for _, turn in ways) / seconds),
    )


def turn_between(start: float, end: float) -> float:
    """The smallest turn from one angle to another [rad]."""
    return math.remainder(end - start, math.tau)


def signed(value: float) -> str:
    """A speed for people, with its sign, which is + for nothing."""
    return f"{round(value, 2) + 0.0:+.2f}"


def _step(one: Moment, other: Moment) -> tuple[float, float]:
    """Way forward [m] and turn [rad] between two looks."""
    turn = turn_between(one.yaw, other.yaw)
    heading = one.yaw + turn / 2.0
    dx, dy = other.place[0] - one.place[0], other.place[1] - one.place[1]
    return dx * math.cos(heading) + dy * math.sin(heading), turn


def _jumps(one: Moment, other: Moment) -> bool:
    """Whether a model fell between two looks, or moved farther than its velocities can tell."""
    is_steep = abs(other.place[2] - one.place[2]) > STEEP * LOOK_S
    reach = 0.05 + 2.0 * LOOK_S * max(one.speed, other.speed)
    swing = 0.1 + 2.0 * LOOK_S * max(one.spin, other.spin)
    is_far = math.dist(one.place, other.place) > reach
    return is_steep or is_far or abs(turn_between(one.yaw, other.yaw)) > swing


def _mean(twists: list[tuple[float, float]]) -> tuple[float, float]:
    first, second = (sum(values) / len(twists) for values in zip(*twists, strict=True))
    return first, second
