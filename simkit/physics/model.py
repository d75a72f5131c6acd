"""Models: robots and things in a world."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from simkit.errors import UnknownNameError
from simkit.geometry import Transform, Vector
from simkit.physics.engine import checked_pose, isometry, transform_of, vector
from simkit.physics.errors import PhysicsError
from simkit.physics.joint import FARTHEST, STRONGEST, ModelJoint, Ties
from simkit.physics.plan import JointKind, ModelPlan
from simkit.physics.skeleton import Built, place_joint
from simkit.physics.velocity_decay import VelocityDecay

REST: Vector = (0.0, 0.0, 0.0)
"""No velocity."""


class Model:
    """One model in a world; `World.add` makes it.

    Its frame is that of the file: of a robot whose root link is `world` that one, otherwise that of
    its root link, with which it moves.
    """

    def __init__(
        self,
        plan: ModelPlan,
        built: Built,
        *,
        name: str,
        pose: Transform,
        busy: dict[int, ModelJoint],
        pushed: list[Any],
        touched: Callable[[], None],
    ) -> None:
        self.name = name
        self.plan = plan
        self.tracking: set[str] = set()
        """Names of the joints that are on their way to a commanded position."""
        self.driven: set[str] = set()
        """Names of the joints whose motors hold a speed."""
        self.is_calm = False
        """Whether it was slow at the last look, and nothing was done to it since."""
        ties = Ties(
            busy=busy,
            tracking=self.tracking,
            driven=self.driven,
            on_command=self._on_command,
            touched=touched,
        )
        self.joints: Mapping[str, ModelJoint] = {
            one.name: ModelJoint(one, built.joints[one.name], ties)
            for one in plan.joints.values()
            if one.moves
        }
        self.start = pose
        self.built = built
        self._touched = touched
        self._mounts = _mounts(plan, built)
        roots = [one for one in plan.joints.values() if one.parent is None]
        self._roots = [(one, built.joints[one.name]) for one in roots]
        is_loose = bool(roots) and all(one.kind is JointKind.FREE for one in roots)
        self.is_free = is_loose and not plan.is_static
        """Whether it can go anywhere."""
        self._pose = pose
        self._to_model = Transform(REST, (0.0, 0.0, 0.0, 1.0))
        if roots:
            self._to_model = roots[0].frame.inverse()
        self._pushed = pushed
        self.velocity_decay = VelocityDecay(plan, built, pushed)
        """What takes velocity from its bodies."""
        self.placings = 0
        """How often it was put somewhere."""

    @property
    def notes(self) -> tuple[str, ...]:
        """What is not as its file says, and why."""
        return self.plan.notes

    @property
    def links(self) -> tuple[str, ...]:
        """The links that are simulated, by name."""
        return tuple(self._mounts)

    def falls(self, down: Any, speed: float) -> bool:
        """Whether it moves faster than a speed [m/s] in the direction of a unit vector of the world."""
        if not self.is_free:
            return False
        for plan, joint in self._roots:
            x, y, z = joint.getVelocities().tolist()[3:]
            if x * x + y * y + z * z > speed * speed:  # to ask in which direction takes longer
                return bool(self.built.bodies[plan.child].getLinearVelocity() @ down > speed)
        return False

    @property
    def mass(self) -> float:
        """Mass of all of it [kg]."""
        return sum(body.body.mass for body in self.plan.bodies.values())

    @property
    def centre_of_mass(self) -> Vector:
        """Its centre of mass in the world [m]; the origin of a model without a body."""
        return vector(self.built.skeleton.getCOM()) if self._roots else self._pose.translation

    @property
    def kinetic_energy(self) -> float:
        """[J]."""
        return float(self.built.skeleton.computeKineticEnergy()) if self._roots else 0.0

    @property
    def potential_energy(self) -> float:
        """In gravity, 0 with the centre of mass at the origin of the world, and in springs [J]."""
        return float(self.built.skeleton.computePotentialEnergy()) if self._roots else 0.0

    @property
    def pose(self) -> Transform:
        """Where its frame is in the world."""
        if not self._roots:
            return self._pose
        body = self.built.bodies[self._roots[0][0].child]
        return transform_of(body.getWorldTransform()) @ self._to_model

    @property
    def base(self) -> Transform:
        """Where its frame was when all its joints were at 0: for what is fixed to the world that frame itself."""
        if not self._roots:
            return self._pose
        plan, joint = self._roots[0]
        is_free = plan.kind is JointKind.FREE
        at = joint.getRelativeTransform() if is_free else joint.getTransformFromParentBodyNode()
        return transform_of(at) @ (plan.frame @ plan.anchor).inverse()

    @property
    def twist(self) -> tuple[Vector, Vector]:
        """How its root link moves in the world: velocity of its origin [m/s], angular velocity [rad/s]."""
        if not self._roots:
            return (REST, REST)
        body = self.built.bodies[self._roots[0][0].child]
        return vector(body.getLinearVelocity()), vector(body.getAngularVelocity())

    def joint(self, name: str) -> ModelJoint:
        """A joint by name.

        Raises:
            UnknownNameError: It has no such joint, or one that does not move; lists those that do.
        """
        if name not in self.joints:
            raise UnknownNameError(f"moving joint in {self.name!r}", name, self.joints)
        return self.joints[name]

    def link_pose(self, link: str) -> Transform:
        """Where a link is in the world.

        Raises:
            UnknownNameError: It has no such link, or one without mass, which is not simulated.
        """
        body, mount = self._mount(link)
        return transform_of(body.getWorldTransform()) @ mount

    def link_twist(self, link: str) -> tuple[Vector, Vector]:
        """How a link moves in the world: velocity of its origin [m/s], angular velocity [rad/s].

        Raises:
            UnknownNameError: As `link_pose`.
        """
        body, mount = self._mount(link)
        offset = np.array(mount.translation)
        return vector(body.getLinearVelocity(offset)), vector(body.getAngularVelocity())

    def set_pose(self, pose: Transform) -> None:
        """Put it somewhere at once; its joints and its velocities, seen from itself, stay.

        Args:
            pose: Where its frame shall be in the world.

        Raises:
            PhysicsError: A number is NaN or infinite.
        """
        moved = checked_pose(pose)
        motion = moved @ self.pose.inverse()
        self._pose = pose
        self._move(motion)
        self._touched()

    def shift(self, by: Any) -> None:
        """Move it, as it stands, by a vector of the world [m]."""
        self._move(Transform(vector(np.asarray(by))))

    def set_twist(self, linear: Vector, angular: Vector) -> None:
        """Give it a velocity at once; its joints keep theirs. What is fixed to the world stays.

        Args:
            linear: Velocity of the origin of its root link in the world [m/s].
            angular: Angular velocity in the world [rad/s].

        Raises:
            PhysicsError: A number is NaN or infinite.
        """
        if not all(abs(v) <= FARTHEST for v in (*linear, *angular)):
            raise PhysicsError(
                f"{self.name} is given a velocity that it cannot have: {linear}, {angular}"
            )
        for plan, joint in self._roots:
            if plan.kind is JointKind.FREE:
                joint.setLinearVelocity(list(linear))
                joint.setAngularVelocity(list(angular))
        self._touched()

    def set_joint_positions(self, positions: Mapping[str, float]) -> None:
        """Put joints somewhere at once, within their limits.

        Args:
            positions: By name [rad or m].

        Raises:
            UnknownNameError: It has no such joint.
        """
        joints = {name: self.joint(name) for name in positions}
        for name, joint in joints.items():
            joint.set_position(positions[name])

    def push(
        self,
        link: str,
        *,
        force: Vector = REST,
        torque: Vector = REST,
        point: Vector = (0.0, 0.0, 0.0),
    ) -> None:
        """Push a link during the next step.

        Args:
            link: The link.
            force: In the world [N].
            torque: In the world [N m].
            point: Where the force acts, in the frame of the link [m].

        Raises:
            UnknownNameError: As `link_pose`.
            PhysicsError: A number is NaN or infinite.
        """
        body, mount = self._mount(link)
        if not all(abs(x) <= STRONGEST for x in (*force, *torque, *point)):
            raise PhysicsError(f"link {link} cannot be pushed by {force} and {torque} at {point}")
        at = (mount @ Transform(point, (0.0, 0.0, 0.0, 1.0))).translation
        body.addExtForce(list(force), list(at), False, True)
        body.addExtTorque(list(torque), False)
        self._pushed.append(body)

    def reset(self) -> None:
        """Back to where it was added: pose, joints at rest, nothing commanded."""
        for plan, joint in self._roots:
            place_joint(joint, plan, self.start)
            if plan.kind is JointKind.FREE:
                joint.setVelocities(np.zeros(6))
        for one in self.joints.values():
            one.reset()
        self._pose = self.start
        self.placings += 1
        self._touched()

    def _on_command(self) -> None:
        self.is_calm = False

    def _mount(self, link: str) -> tuple[Any, Transform]:
        found = self._mounts.get(link)
        if found is None:
            raise UnknownNameError(f"link in {self.name!r}", link, self._mounts)
        return found

    def _move(self, motion: Transform) -> None:
        """Move all of it by T_world_world."""
        self.placings += 1
        turn = isometry(motion)
        for plan, joint in self._roots:
            if plan.kind is JointKind.FREE:
                joint.setRelativeTransform(turn.multiply(joint.getRelativeTransform()))
            else:
                at = turn.multiply(joint.getTransformFromParentBodyNode())
                joint.setTransformFromParentBodyNode(at)


def _mounts(plan: ModelPlan, built: Built) -> dict[str, tuple[Any, Transform]]:
    """The body that each link is on, and where it is there."""
    return {link: (built.bodies[mount.body], mount.frame) for link, mount in plan.mounts.items()}
