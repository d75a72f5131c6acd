"""The world: models that move, and the clock that they move by."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from simkit.errors import UnknownNameError
from simkit.geometry import Transform, Vector
from simkit.physics.contact import Contact, Owner, read_contacts
from simkit.physics.engine import GRAVITY, STEP_NS, checked_pose, new_engine_world, vector
from simkit.physics.errors import ModelError, PhysicsError
from simkit.physics.model import Model
from simkit.physics.plan import ModelPlan
from simkit.physics.rays import Hits, RayShapes, cast
from simkit.physics.sdf.model_plan import ground_plan
from simkit.physics.skeleton import build, non_colliding_pairs
from simkit.physics.stability import ModelWatch
from simkit.physics.stepper import Stepper

ORIGIN = Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))
"""Where a model is added if nobody says where."""


class World:
    """A world with a clock of its own, in whole nanoseconds.

    The same models, commands and steps give the same numbers, bit by bit, however the steps are
    divided among calls.

    Args:
        gravity: Acceleration of all that falls [m/s^2].
        ground: Whether it has the model `ground_plane`.
        step_ns: Time of one step [ns].

    Raises:
        NoEngineError: dartpy is not there.
        PhysicsError: A number makes no sense.
    """

    def __init__(
        self, *, gravity: Vector = GRAVITY, ground: bool = True, step_ns: int = STEP_NS
    ) -> None:
        if step_ns <= 0 or not np.isfinite(gravity).all():
            raise PhysicsError(f"no world has steps of {step_ns} ns and a gravity of {gravity}")
        self._engine = new_engine_world(step_ns * 1e-9, gravity)
        self._models: dict[str, Model] = {}
        self._ray_shapes: dict[str, RayShapes] = {}
        self._owners: dict[str, Owner] = {}
        self._stepper = Stepper(
            self._engine,
            step_ns=step_ns,
            models=self._models,
            owners=self._owners,
            remove=self.remove,
        )
        if ground:
            self.add(ground_plan())

    @property
    def time_ns(self) -> int:
        """Time since its beginning [ns]."""
        return self._stepper.time_ns

    @property
    def step_ns(self) -> int:
        """Time of one step [ns]."""
        return self._stepper.step_ns

    @property
    def before_step(self) -> list[Callable[[], None]]:
        """Called before each step in which they are `due`, in this order, with the clock at its beginning."""
        return self._stepper.before

    @property
    def after_step(self) -> list[Callable[[], None]]:
        """Called after each step in which they are `due`, in this order, with the clock at its end."""
        return self._stepper.after

    @property
    def due(self) -> dict[Callable[[], None], Callable[[], int]]:
        """Of hooks that need not be called in each step: the time from which on they have something to do [ns].

        Where all hooks name it, the engine makes the steps in between without Python.
        """
        return self._stepper.due

    @property
    def models(self) -> Mapping[str, Model]:
        """Its models by name, the oldest first."""
        return MappingProxyType(self._models)

    @property
    def gravity(self) -> Vector:
        """Acceleration of all that falls [m/s^2]."""
        x, y, z = self._engine.getGravity().tolist()
        return (x, y, z)

    @gravity.setter
    def gravity(self, gravity: Vector) -> None:
        if not np.isfinite(gravity).all():
            raise PhysicsError(f"a gravity of {gravity} is no number")
        self._engine.setGravity(list(gravity))
        self._stepper.read_gravity()

    def model(self, name: str) -> Model:
        """A model by name.

        Raises:
            UnknownNameError: There is none of that name; lists those that are there.
        """
        if name not in self._models:
            raise UnknownNameError("model", name, self._models)
        return self._models[name]

    def add(self, plan: ModelPlan, *, name: str | None = None, pose: Transform = ORIGIN) -> Model:
        """Add a model, at rest.

        Args:
            plan: What it is: `plan_robot` makes it from a URDF, `plan_model` from SDF.
            name: Its name in this world; that of the plan if None.
            pose: Where its frame is in the world.

        Raises:
            ModelError: There is a model of that name.
            PhysicsError: A number of the pose is NaN or infinite.
        """
        name = plan.name if name is None else name
        if name in self._models:
            raise ModelError(
                f"a model named {name} is already there: delete it, or choose another name"
            )
        pose = checked_pose(pose)
        built = build(plan, name=name, pose=pose)
        self._engine.addSkeleton(built.skeleton)
        stepper = self._stepper
        model = Model(
            plan,
            built,
            name=name,
            pose=pose,
            busy=stepper.busy,
            pushed=stepper.pushed,
            touched=stepper.touched,
        )
        self._models[name] = model
        self._enlist(model)
        stepper.changed()
        stepper.touched()
        return model

    def remove(self, name: str) -> None:
        """Take a model out; what is left of it in Python moves no more.

        Raises:
            UnknownNameError: There is none of that name.
        """
        model = self.model(name)
        self._stepper.changed()
        for joint in model.joints.values():
            joint.release()
        bodies = model.built.bodies
        for one, other in non_colliding_pairs(model.plan):
            self._filter().removeBodyNodePairFromBlackList(bodies[one], bodies[other])
        self._stepper.collision_filter.forget(model)
        self._engine.removeSkeleton(model.built.skeleton)
        for label in self._ray_shapes.pop(name).labels:
            del self._owners[label]
        self._stepper.watches.pop(name, None)
        del self._models[name]

    def step(self) -> None:
        """Make one step.

        Raises:
            LostModelError: The numbers of a model left all bounds; the model is gone, the rest goes on.
        """
        self._stepper.make(1)

    def run(self, duration_ns: int) -> None:
        """Make steps for a time.

        Args:
            duration_ns: A whole number of steps [ns].

        Raises:
            PhysicsError: It is negative, or not a whole number of steps.
            LostModelError: As `step`.
        """
        steps, rest = divmod(duration_ns, self.step_ns)
        if steps < 0 or rest:
            raise PhysicsError(f"{duration_ns} ns is no whole number of steps of {self.step_ns} ns")
        self._stepper.make(steps)

    def run_until(self, time_ns: int, *, stop: Callable[[], bool] | None = None) -> None:
        """Make all steps that end at a time or before; none if it is past.

        Args:
            time_ns: Time on the clock of this world [ns].
            stop: Asked after each step, or after a few in which nothing was called; True ends it.

        Raises:
            LostModelError: As `step`.
        """
        self._stepper.make(max(0, (time_ns - self.time_ns) // self.step_ns), stop)

    def tell_time(self, passed: Callable[[int], None] | None) -> None:
        """Call back with the time [ns] whenever steps were made, before the hooks that follow; None: no more."""
        self._stepper.passed = passed

    def reset(self, *, time: bool = True) -> None:
        """Put each model back where it was added, at rest, with nothing commanded.

        Args:
            time: Whether the clock goes back to 0 as well.
        """
        self._stepper.forget_pushes()
        for model in self._models.values():
            model.reset()
        self._stepper.restart(time=time)

    def contacts(self) -> tuple[Contact, ...]:
        """What touched in the last step; nothing if models came or went since."""
        if not self._stepper.has_contacts:
            return ()
        found = read_contacts(self._engine.getLastCollisionResult(), self._owners)
        return found + self._stepper.collision_filter.still

    def overlaps(self) -> tuple[Contact, ...]:
        """What touches as things stand now, without a step; the forces are zero."""
        return self._stepper.collision_filter.all_contacts()

    def cast_rays(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        reach: float = float("inf"),
        start: float = 0.0,
    ) -> Hits:
        """How far rays go before they hit a collision shape, also one of the robot that sends them.

        Args:
            origins: Where they come from in the world [m], (n, 3), or (3,) for all, which is quicker.
            directions: Unit vectors in the world, (n, 3).
            reach: What is farther away from the origin is not hit [m].
            start: They begin so far from their origin [m].

        Returns:
            Distances, and numbers of what is hit: places in `targets`.
        """
        targets = [target for shapes in self._ray_shapes.values() for target in shapes.targets()]
        points, ways = np.asarray(origins, float), np.asarray(directions, float)
        if points.ndim == 1:
            return cast(vector(points), ways, targets=targets, reach=reach, start=start)
        rays = zip(points, ways[:, None], strict=True)
        found = [
            cast(vector(point), way, targets=targets, reach=reach, start=start)
            for point, way in rays
        ]
        return Hits(
            np.array([float(one.distances[0]) for one in found]),
            np.array([int(one.targets[0]) for one in found], dtype=np.intp),
        )

    @property
    def targets(self) -> tuple[Owner, ...]:
        """What rays can hit, in the order of the numbers that `cast_rays` gives."""
        return tuple(
            self._owners[label] for shapes in self._ray_shapes.values() for label in shapes.labels
        )

    def _enlist(self, model: Model) -> None:
        """Let all parts of the world know of a new model."""
        name, plan, built = model.name, model.plan, model.built
        self._ray_shapes[name] = RayShapes(model)
        for label, (node, shape) in built.shapes.items():
            self._owners[label] = Owner(name, node.getBodyNodePtr().getName(), shape)
        if built.skeleton.getNumDofs() and not plan.is_static:
            self._stepper.watches[name] = ModelWatch(model)
        for one, other in non_colliding_pairs(plan):
            self._filter().addBodyNodePairToBlackList(built.bodies[one], built.bodies[other])

    def _filter(self) -> Any:
        return self._engine.getConstraintSolver().getCollisionOption().collisionFilter
