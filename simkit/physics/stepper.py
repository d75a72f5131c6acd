"""The loop that makes the steps of a world."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from simkit.physics.collision_filter import CollisionFilter
from simkit.physics.contact import Owner
from simkit.physics.errors import PhysicsError
from simkit.physics.joint import ModelJoint
from simkit.physics.model import Model
from simkit.physics.penetration import FALLING, LONGEST, lift
from simkit.physics.second_order import SecondOrder
from simkit.physics.stability import LOOK_EVERY, LostModelError, ModelWatch


class Stepper:
    """Makes steps, and everything around a step that the engine does not do by itself.

    While nothing needs attention, which is looked at every few steps, steps are made in a bare loop.

    Args:
        engine: The engine's world.
        step_ns: Time of one step [ns].
        models: The models of the world; it may change.
        owners: What the engine's shapes are; it may change.
        remove: Takes a model out of the world.
    """

    def __init__(
        self,
        engine: Any,
        *,
        step_ns: int,
        models: Mapping[str, Model],
        owners: Mapping[str, Owner],
        remove: Callable[[str], None],
    ) -> None:
        self.passed: Callable[[int], None] | None = None
        self.before: list[Callable[[], None]] = []
        self.after: list[Callable[[], None]] = []
        self.due: dict[Callable[[], None], Callable[[], int]] = {}
        self.busy: dict[int, ModelJoint] = {}
        self.watches: dict[str, ModelWatch] = {}
        self.pushed: list[Any] = []
        self.step_ns = step_ns
        self.time_ns = 0
        self.has_contacts = False
        self.collision_filter = CollisionFilter(engine, models, owners)
        self._engine = engine
        self._down = np.zeros(3)
        self._step_s = step_ns * 1e-9
        self._models = models
        self._owners = owners
        self._remove = remove
        self._count = 0
        self._to_lift = 0
        self._patience = LONGEST
        self._is_stepping = False
        self._is_touched = True
        self.read_gravity()

    def touched(self) -> None:
        """Something was set from outside: it may be fast, or stick in something."""
        self._to_lift, self._patience = LOOK_EVERY, LONGEST
        self._is_touched = True
        for watch in self.watches.values():
            watch.start()

    def read_gravity(self) -> None:
        """See which way things fall."""
        gravity = self._engine.getGravity()
        self._down = gravity / max(float(np.linalg.norm(gravity)), 1e-9)

    def changed(self) -> None:
        """Shapes come, go or jump: the contacts of the last step mean nothing any more."""
        self.has_contacts = False
        self._is_touched = True
        self._engine.getConstraintSolver().clearLastCollisionResult()

    def forget_pushes(self) -> None:
        """Let go of all bodies that are pushed."""
        for body in self.pushed:
            body.clearExternalForces()
        self.pushed.clear()

    def restart(self, *, time: bool) -> None:
        """Begin anew; the clock too if asked for."""
        self.time_ns = 0 if time else self.time_ns
        self._count = 0
        self.changed()
        self.touched()

    def make(self, steps: int, stop: Callable[[], bool] | None = None) -> None:
        """Make so many steps.

        Args:
            steps: How many.
            stop: Asked after each step in which a hook may have been called; True ends it.

        Raises:
            PhysicsError: It is called by something that is called in a step.
            LostModelError: The numbers of a model left all bounds; the model is gone, the rest goes on.
        """
        if self._is_stepping:
            raise PhysicsError("a step cannot be made while one is being made")
        self._is_stepping = True
        try:
            while steps > 0:
                if self._is_touched:
                    self._is_touched = False
                    self.collision_filter.refresh()
                if self._count % LOOK_EVERY == 0:
                    self._look()
                burst = self._burst(min(steps, LOOK_EVERY - self._count % LOOK_EVERY))
                if burst > 1:
                    self._engine_steps(burst)
                    self._call(self.after)
                else:
                    self._one_step()
                steps -= burst
                if stop is not None and stop():
                    break
        finally:
            self._is_stepping = False

    def _look(self) -> None:
        for watch in self.watches.values():
            watch.look()
            if watch.model.falls(self._down, FALLING):
                self._to_lift, self._patience = LOOK_EVERY + 1, LONGEST
                watch.second_order.start()

    def _burst(self, most: int) -> int:
        """How many of the next steps the engine can make in one go."""
        if self.busy or self.pushed or self._to_lift:
            return 1
        if not all(watch.is_quiet for watch in self.watches.values()):
            return 1
        for hook in self.before:
            most = min(most, self._steps_until(hook))
        for hook in self.after:
            most = min(most, self._steps_until(hook))
        return max(most, 1)

    def _steps_until(self, hook: Callable[[], None]) -> int:
        """Steps until a hook has something to do."""
        due = self.due.get(hook)
        return 0 if due is None else -((self.time_ns - due()) // self.step_ns)

    def _call(self, hooks: list[Callable[[], None]]) -> None:
        """Call the hooks that are due."""
        for hook in tuple(hooks):
            due = self.due.get(hook)
            if due is None or due() <= self.time_ns:
                hook()

    def _engine_steps(self, steps: int) -> None:
        """Steps that need nothing but the engine."""
        second_order = self._second_order()
        if second_order:
            self._second_order_steps(second_order, steps)
        else:
            engine_step = self._engine.step
            for _ in range(steps):
                engine_step(False)
        self._passed(steps)

    def _second_order(self) -> list[SecondOrder]:
        return [watch.second_order for watch in self.watches.values() if watch.second_order.is_on]

    def _second_order_steps(self, second_order: list[SecondOrder], steps: int) -> None:
        """Steps for models some of which are stepped in second order."""
        engine_step, step_s, count = self._engine.step, self._step_s, self._count
        for one in second_order:
            one.enter(count, step_s)
        end = count + steps
        while count < end:
            burst = min(end - count, *(one.left for one in second_order))
            for _ in range(burst):
                engine_step(False)
            count += burst
            for one in second_order:
                one.passed(burst)
                if not one.left and count < end:
                    one.turn(count, step_s)
        for one in second_order:
            one.leave(count, step_s)

    def _one_step(self) -> None:
        """One step, with all that belongs to it."""
        self._call(self.before)
        for joint in self.busy.values():
            joint.before_step(self._step_s)
        for watch in self.watches.values():
            watch.model.velocity_decay.act(self._step_s)
        self._engine_steps(1)
        self._finish_step()
        self._call(self.after)

    def _finish_step(self) -> None:
        for joint in tuple(self.busy.values()):
            joint.after_step()
        if self.pushed:
            self.forget_pushes()
        if self._to_lift:
            self._lift()
        for name, watch in self.watches.items():
            if not watch.model.is_calm and watch.is_lost():
                self._remove(name)
                raise LostModelError(name, self.time_ns)

    def _lift(self) -> None:
        """Take models out of what they stick in; after some time of it, leave them there."""
        self._to_lift -= 1
        if lift(self._engine.getLastCollisionResult(), self._owners, self._models):
            self._patience -= 1
            self._to_lift = max(self._to_lift, 1) if self._patience > 0 else 0

    def _passed(self, steps: int) -> None:
        self._count += steps
        self.time_ns += steps * self.step_ns
        self.has_contacts = True
        if self.passed is not None:
            self.passed(self.time_ns)
