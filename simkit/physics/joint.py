"""Joints of a model: where they stand, and what drives them."""

from __future__ import annotations

import enum
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from simkit.physics.engine import dart
from simkit.physics.errors import PhysicsError
from simkit.physics.plan import JointPlan
from simkit.physics.skeleton import start_position

JUMP = 100.0
"""A commanded position that would take a faster motion [rad/s or m/s] is jumped to, without one."""

FARTHEST = 1e6
"""No position or velocity that is asked for is beyond this [rad or m, and per second]."""
STRONGEST = 1e9
"""No effort is stronger [N m or N]."""


class Mode(enum.Enum):
    """What drives a joint."""

    FREE = "free"
    """Nothing: it hangs, with its damping, friction and spring."""
    EFFORT = "effort"
    """A torque or force."""
    VELOCITY = "velocity"
    """A motor that holds a speed, as far as its effort goes."""
    POSITION = "position"
    """A position is held exactly, whatever it takes."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Ties:
    """What a joint reaches of its model and world."""

    busy: dict[int, ModelJoint]
    """The joints of the world that need attention in every step."""
    tracking: set[str]
    """Names of the joints of the model that are on their way to a position."""
    driven: set[str]
    """Names of the joints of the model whose motors hold a speed."""
    on_command: Callable[[], None]
    """To be called when it is driven in another way."""
    touched: Callable[[], None]
    """To be called when it is put somewhere."""


class ModelJoint:
    """A joint that turns or slides.

    A command holds until the next one. Positions are counted on through whole turns.

    Args:
        plan: What it is.
        joint: The engine's joint.
        ties: What it reaches of its model and world.
    """

    def __init__(self, plan: JointPlan, joint: Any, ties: Ties) -> None:
        self.plan = plan
        self.mode = Mode.FREE
        self.start = start_position(plan)
        self._joint = joint
        self._ties = ties
        self._target = 0.0
        self._bound = math.inf

    @property
    def name(self) -> str:
        """Its name."""
        return self.plan.name

    @property
    def position(self) -> float:
        """Where it stands [rad or m]."""
        return float(self._joint.getPosition(0))

    @property
    def velocity(self) -> float:
        """How fast it moves [rad/s or m/s]."""
        return float(self._joint.getVelocity(0))

    @property
    def command(self) -> float:
        """The effort, velocity or position that is commanded, within its limits; 0 if nothing is."""
        return self._target

    @property
    def effort(self) -> float:
        """What its drive did in the last step [N m or N]; 0 if nothing drives it.

        Of a motor that holds a speed this includes what the stops of the joint did.
        """
        match self.mode:
            case Mode.FREE:
                return 0.0
            case Mode.VELOCITY:
                return float(self._joint.getConstraintImpulse(0)) / self._step_s()
            case _:
                return float(self._joint.getForce(0))

    @property
    def is_saturated(self) -> bool:
        """Whether its drive gives all that it has."""
        if self.mode not in (Mode.EFFORT, Mode.VELOCITY) or math.isinf(self._bound):
            return False
        return abs(self.effort) >= self._bound * (1.0 - 1e-9)

    def set_position(self, position: float) -> None:
        """Put it somewhere at once, within its limits, without changing its velocity.

        Args:
            position: Where to [rad or m].
        """
        self._joint.setPosition(0, self._within(position))
        if self.mode is Mode.POSITION:
            self._target = self.position
        self._ties.touched()

    def set_velocity(self, velocity: float) -> None:
        """Give it a velocity at once [rad/s or m/s]."""
        self._joint.setVelocity(0, self._checked(velocity))
        self._ties.touched()

    def command_effort(self, effort: float) -> None:
        """Drive it by a torque or force, up to its limit; in the direction in which it is too fast by none.

        Args:
            effort: Torque or force [N m or N].

        Source:
            Gazebo's `Joint::CheckAndTruncateForce`.
        """
        self._switch(Mode.EFFORT, dart().dynamics.ActuatorType.FORCE)
        self._bound = self.plan.effort
        bound = min(self._bound, STRONGEST)
        self._target = min(max(_number(effort, self.name), -bound), bound)
        self._joint.setCommand(0, self._target)
        self._ties.on_command()
        if math.isfinite(self.plan.velocity):
            self._ties.busy[id(self)] = self

    def command_velocity(self, velocity: float, *, effort: float | None = None) -> None:
        """Let a motor hold a speed, as Gazebo's joint motor does.

        Args:
            velocity: Speed [rad/s or m/s].
            effort: Largest torque or force of the motor [N m or N]; the joint's own limit if None.
        """
        bound = self.plan.effort if effort is None else abs(_number(effort, self.name))
        wanted = (Mode.VELOCITY, bound, self._checked(velocity))
        if wanted == (self.mode, self._bound, self._target):
            return  # as it is: nothing stirs
        self._switch(Mode.VELOCITY, dart().dynamics.ActuatorType.SERVO)
        self._ties.driven.add(self.name)
        if bound != self._bound:
            self._bound = bound
            self._joint.setForceLowerLimit(0, -bound)
            self._joint.setForceUpperLimit(0, bound)
        self._target = wanted[2]
        self._joint.setCommand(0, self._target)
        self._ties.on_command()

    def command_position(self, position: float) -> None:
        """Hold a position, within its limits: it is there after the next step, and stays.

        Neither weight nor effort matter. On the way it has the velocity that takes it there in one
        step, so that it pushes what it touches; a jump that is too long for that has none.

        Args:
            position: Where to [rad or m].
        """
        target = self._within(position)
        if (
            self.mode is Mode.POSITION
            and target == self.position
            and self.name not in self._ties.tracking
        ):
            return  # it is there, and at rest
        self._switch(Mode.POSITION, dart().dynamics.ActuatorType.VELOCITY)
        self._target = target
        self._ties.busy[id(self)] = self
        self._ties.tracking.add(self.name)

    def release(self) -> None:
        """Let it go."""
        self._switch(Mode.FREE, dart().dynamics.ActuatorType.FORCE)
        self._ties.touched()

    def before_step(self, step_s: float) -> None:
        """Prepare the step that follows."""
        if self.mode is Mode.POSITION:
            away = self._target - self._joint.getPosition(0)
            if abs(away) > JUMP * step_s:
                self._joint.setPosition(0, self._target)
                self._joint.setVelocity(0, 0.0)
                away = 0.0
            self._joint.setCommand(0, away / step_s)
        elif self.mode is Mode.EFFORT:
            velocity, limit = self._joint.getVelocity(0), self.plan.velocity
            is_too_fast = velocity * self._target > 0.0 and abs(velocity) > limit
            self._joint.setCommand(0, 0.0 if is_too_fast else self._target)

    def after_step(self) -> None:
        """Take away what is left of rounding; a position that is reached needs no more attention."""
        if self.mode is Mode.POSITION:
            self._joint.setPosition(0, self._target)
            if self._joint.getCommand(0) == 0.0:
                self._joint.setVelocity(0, 0.0)
                self._rest()

    def reset(self) -> None:
        """Let it go, and put it where it stood first, at rest."""
        self.release()
        self._joint.setPosition(0, self.start)
        self._joint.setVelocity(0, 0.0)

    def _switch(self, mode: Mode, actuator: Any) -> None:
        self._rest()
        if mode is self.mode:
            return
        self.mode = mode
        self._target, self._bound = 0.0, math.nan
        self._joint.setForceLowerLimit(0, -math.inf)
        self._joint.setForceUpperLimit(0, math.inf)
        self._joint.setActuatorType(actuator)
        self._joint.setCommand(0, 0.0)
        self._joint.setForce(0, 0.0)
        # The engine keeps what it computed for the old kind of actuator, until something moves.
        self._joint.getSkeleton().dirtyArticulatedInertia(self._joint.getTreeIndex())

    def _rest(self) -> None:
        self._ties.busy.pop(id(self), None)
        self._ties.tracking.discard(self.name)
        self._ties.driven.discard(self.name)

    def _within(self, position: float) -> float:
        return min(max(self._checked(position), self.plan.lower), self.plan.upper)

    def _checked(self, value: float) -> float:
        """A position or velocity of this world."""
        value = _number(value, self.name)
        if abs(value) > FARTHEST:
            raise PhysicsError(
                f"joint {self.name} is asked for {value:g}: that is beyond {FARTHEST:g}"
            )
        return value

    def _step_s(self) -> float:
        return float(self._joint.getSkeleton().getTimeStep())


def _number(value: float, name: str) -> float:
    """A number that may reach the engine."""
    value = float(value)
    if not math.isfinite(value):
        raise PhysicsError(f"joint {name} is asked for {value}: that is no number")
    return value
