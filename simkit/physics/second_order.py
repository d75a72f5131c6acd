"""Second-order steps: a better integration for what swings fast.

The engine's step is the semi-implicit Euler method, as Gazebo's is: velocities with the forces at
the beginning of the step, then positions with the new velocities. Its error is of first order in
the step, and a chain of links that whirls gains and loses energy by it. Two things repair it:

- Positions that are half a step ahead (*hidden* ones, while the ones to be *shown* stay where they
  belong) make the method one of second order as long as forces do not depend on velocities.
- Forces that do are taken with the velocity of the beginning of the step, not of its middle. What
  that leaves out is kicked into the velocities, half of it before and half of it after a burst of
  a few steps. Dampers and springs, which the engine takes at the end of the step, are set right
  in the same way.

So a burst is made of the engine's own steps, with all contacts and limits, and costs little more.
Methods of this kind are called processed integrators, or methods of an effective order.

The free arm of exercise 3.9 in 2 s, steps of 1 ms, against a reference solution; it exchanges 3.9 J
between height and motion (`benchmarks/bench_physics.py` prints it anew):

| | energy is off by | hip, shoulder at 2 s are off by |
|---|---|---|
| plain steps | 0.11 J | 0.52, 0.17 rad |
| plain steps, 8 times as many | 0.014 J | 0.063, 0.021 rad |
| second-order steps | 0.0015 J | 0.00003, 0.00016 rad |

What rolls, drives, stands or follows its commands does not swing, and is stepped plainly. What
falls is stepped in second order too: then it keeps to the parabola.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from simkit.geometry import Transform, Vector
from simkit.physics.plan import JointKind, JointPlan, ModelPlan
from simkit.physics.skeleton import Built
from simkit.urdf.inertia import Body, placed_body

BURST = 8
"""Steps from one kick to the next, at most; `simkit.physics.stability.LOOK_EVERY` is a multiple of it."""
TURN = 0.2
"""No coordinate moves further in a burst [rad or m], if it is of more than one step."""
STIFF = 0.03
"""A spring whose force changes the velocity faster than this, in one step, is left to the engine."""
GRACE = 4
"""Looks at which it must have been slow before steps are plain again: a pendulum is slow where it turns."""
SWING = 0.05
"""A joint that is faster swings [rad/s or m/s]."""
TUMBLE = 3.0
"""A free body that turns faster tumbles [rad/s]."""


class SecondOrder:
    """The second-order steps of one model.

    Args:
        plan: What it is.
        built: What the engine made of it.
        tracking: Names of its joints that are on their way to a commanded position: their motion is not one
            that forces make, so that steps are plain while there are any.
        driven: Names of its joints whose motors hold a speed: they need no kick.
    """

    def __init__(
        self,
        plan: ModelPlan,
        built: Built,
        *,
        tracking: Collection[str] = (),
        driven: Collection[str] = (),
    ) -> None:
        self._swings = True
        self._tracking, self._driven = tracking, driven
        self._dofs = {
            name: built.joints[name].getIndexInSkeleton(0)
            for name, joint in plan.joints.items()
            if joint.moves
        }
        self._grace = GRACE
        self._skeleton = built.skeleton
        self._slowest = self._thresholds(plan, built)
        self._can_swing = min(self._slowest, default=math.inf) < math.inf
        dofs = [built.skeleton.getDof(number) for number in range(built.skeleton.getNumDofs())]
        self._damping = np.array([dof.getDampingCoefficient() for dof in dofs])
        self._stiffness = np.array([dof.getSpringStiffness() for dof in dofs])
        self._resists = bool(self._damping.any() or self._stiffness.any())
        self._lack = np.zeros(len(dofs))
        self._made = self._length = 0
        self._hidden: _Hidden | None = None

    @staticmethod
    def _thresholds(plan: ModelPlan, built: Built) -> list[float]:
        """The speed of each coordinate above which steps are of second order [rad/s or m/s]."""
        found = [math.inf] * built.skeleton.getNumDofs()
        for name, joint in plan.joints.items():
            engine_joint = built.joints[name]
            slow = math.inf
            if joint.kind is JointKind.FREE:
                slow = TUMBLE
            elif joint.moves and not _is_balanced_wheel(joint, plan):
                slow = SWING
            for number in range(min(3, engine_joint.getNumDofs())):  # of six, those that turn
                found[engine_joint.getIndexInSkeleton(number)] = slow
        return found

    @property
    def is_on(self) -> bool:
        """Whether the next step is of second order."""
        return self._can_swing and self._swings and not self._tracking

    def start(self) -> None:
        """Make second-order steps from now on, until it has been slow for a while: it may begin to swing."""
        self._swings, self._grace = True, GRACE

    def look(self, velocities: Sequence[float]) -> None:
        """See whether it swings now.

        Args:
            velocities: Of all its coordinates [rad/s or m/s].
        """
        swings = any(abs(v) > slow for v, slow in zip(velocities, self._slowest, strict=True))
        self._grace = GRACE if swings else self._grace - 1
        self._swings = self._grace > 0

    @property
    def left(self) -> int:
        """Steps to the end of the burst."""
        return self._length - self._made

    def enter(self, count: int, step_s: float) -> None:
        """Go from the state that is shown to the hidden one, in which the engine makes its steps.

        Args:
            count: How many steps its world has made.
            step_s: Time of a step [s].
        """
        hidden, self._hidden = self._hidden, None
        if hidden is not None and hidden.continues(self._skeleton, count):
            self._skeleton.setPositions(hidden.positions)
            self._skeleton.setVelocities(hidden.velocities)
        else:
            self._made = self._length = 0
            self._skeleton.integratePositions(step_s / 2.0)
        if not self.left:
            self.turn(count, step_s)

    def turn(self, count: int, step_s: float) -> None:
        """End a burst, if there was one, and begin the next one."""
        skeleton = self._skeleton
        velocities = skeleton.getVelocities()
        skeleton.computeForwardDynamics()
        before = skeleton.getAccelerations()
        skeleton.integrateVelocities(0.5 * step_s)
        skeleton.computeForwardDynamics()
        # The acceleration that a step of the engine lacks, since it does not look at its own middle.
        self._lack = skeleton.getAccelerations() - before
        if self._resists:
            self._lack += self._resistance(velocities, before, step_s)
        for name in self._driven:
            self._lack[self._dofs[name]] = 0.0
        longest, fastest = BURST, max(map(abs, velocities.tolist())) * step_s
        while longest > 1 and longest * fastest > TURN:
            longest //= 2
        length = longest - count % longest
        skeleton.setVelocities(velocities + (0.5 * (self._length + length) * step_s) * self._lack)
        self._made, self._length = 0, length

    def passed(self, steps: int) -> None:
        """The engine has made so many steps of the burst."""
        self._made += steps

    def leave(self, count: int, step_s: float) -> None:
        """Show the state, and keep the hidden one for the steps that follow.

        Args:
            count: How many steps its world has made.
            step_s: Time of a step [s].
        """
        skeleton = self._skeleton
        positions, velocities = skeleton.getPositions(), skeleton.getVelocities()
        share = (self._made - 0.5 * self._length) * step_s
        skeleton.setVelocities(velocities + share * self._lack)
        skeleton.integratePositions(-step_s / 2.0)
        self._hidden = _Hidden(count, positions, velocities, _state(skeleton))

    def _resistance(self, velocities: Any, accelerations: Any, step_s: float) -> Any:
        # The engine solves (M + h D + h^2 K) a = f - D v - K (q + h v); wanted is M a = f - D (v + h a / 2) - K q.
        mass = self._skeleton.getAugMassMatrix()
        stiffness = self._stiffness
        if (step_s**2 * stiffness > STIFF * mass.diagonal()).any():
            stiffness = np.zeros_like(stiffness)
        drag = self._damping * accelerations
        pull = stiffness * (velocities + 1.5 * step_s * accelerations)
        return np.linalg.solve(mass, step_s * (drag + pull))


@dataclass(slots=True)
class _Hidden:
    """The state that the engine goes on with, while another one is shown."""

    count: int
    positions: Any
    velocities: Any
    shown: tuple[bytes, bytes]

    def continues(self, skeleton: Any, count: int) -> bool:
        """Whether nobody has moved the skeleton since then."""
        return self.count == count and self.shown == _state(skeleton)


def _state(skeleton: Any) -> tuple[bytes, bytes]:
    return (skeleton.getPositions().tobytes(), skeleton.getVelocities().tobytes())


def _is_balanced_wheel(joint: JointPlan, plan: ModelPlan) -> bool:
    """Whether a joint carries one body that turns like a wheel, and nothing beyond it."""
    is_last = all(other.parent != joint.child for other in plan.joints.values())
    if joint.kind is not JointKind.REVOLUTE or not is_last or joint.stiffness > 0.0:
        return False
    return is_balanced(
        placed_body(plan.bodies[joint.child].body, joint.anchor.inverse() @ Transform()), joint.axis
    )


def is_balanced(body: Body, axis: Vector) -> bool:
    """Whether turning a body about an axis through its origin leaves its mass where it is.

    Its centre lies on the axis, to 1 mm, and its inertia is the same all round, to 1 %.
    """
    across = np.linalg.svd(np.array([axis]))[2][1:]
    low, high = np.linalg.eigvalsh(across @ np.array(body.tensor) @ across.T)
    offset = np.linalg.norm(np.cross(axis, body.centre))
    return bool(offset < 1e-3 and high - low <= 0.01 * high)
