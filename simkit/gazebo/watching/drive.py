"""The driven wheels of a model, as its drive plugin believes them, and as they are."""

from __future__ import annotations

import math
from dataclasses import dataclass

from simkit.gazebo.models import Spawned
from simkit.geometry import Transform, Vector
from simkit.physics import Model, ModelJoint
from simkit.plugins.tags import DiffDriveParameters, SkidSteerDriveParameters
from simkit.urdf.model import Cylinder, Sphere
from simkit.urdf.wheel import round_part


@dataclass(frozen=True, slots=True, kw_only=True)
class Drive:
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
        """What the motors are told now: speed forward [m/s], and turning to the left [rad/s]."""
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


def drive_of(spawned: Spawned) -> Drive | None:
    """The driven wheels of a model; of several drives those of the first."""
    for plugin in spawned.plugins:
        given = plugin.parameters
        left: tuple[str, ...]
        right: tuple[str, ...]
        match given:
            case DiffDriveParameters():
                left, right, torque = (given.left_joint,), (given.right_joint,), "wheelTorque"
            case SkidSteerDriveParameters():
                left = (given.left_front_joint, given.left_rear_joint)
                right = (given.right_front_joint, given.right_rear_joint)
                torque = "torque"
            case _:
                continue
        model = spawned.model
        return Drive(
            model=model,
            left=tuple(model.joint(name) for name in left),
            right=tuple(model.joint(name) for name in right),
            separation=given.wheel_separation,
            diameter=given.wheel_diameter,
            torque_tag=torque,
        )
    return None


def _middle(points: list[Vector]) -> Vector:
    x, y, z = (sum(values) / len(points) for values in zip(*points, strict=True))
    return (x, y, z)
