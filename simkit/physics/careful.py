"""Careful steps: a better integration for what swings fast.

The engine's step is the semi-implicit Euler method, as Gazebo's is: velocities with the forces at
the beginning of the step, then positions with the new velocities. Its error is of first order in
the step, and a chain of links that whirls gains and loses energy by it. So a model that swings
takes each step about the middle: positions go half a step ahead, the change that the forces make
on the way (those that depend on the velocity) is added, the engine makes its step with all contacts
and limits, and the positions go half a step back. That is a method of second order.

The free arm of exercise 3.9 in 2 s, steps of 1 ms, against a reference solution; it exchanges 3.9 J
between height and motion (`benchmarks/bench_physics.py` prints it anew):

| | energy is off by | hip, shoulder at 2 s are off by | cost of a step |
|---|---|---|---|
| plain steps | 0.11 J | 0.52, 0.17 rad | 1 |
| plain steps, 8 times as many | 0.014 J | 0.063, 0.021 rad | 8 |
| careful steps | 0.0004 J | 0.0001, 0.0001 rad | 4 |

What rolls, drives, stands or follows its commands does not swing, and is stepped plainly. What
falls is stepped carefully too: then it keeps to the parabola.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence

import numpy as np

from simkit.physics.plan import JointKind, JointPlan, ModelPlan
from simkit.physics.skeleton import Built
from simkit.urdf.frame import Frame
from simkit.urdf.inertia import Body, placed
from simkit.urdf.model import Vector

GRACE = 4
"""Looks at which it must have been slow before steps are plain again: a pendulum is slow where it turns."""
SWING = 0.05
"""A joint that is faster swings [rad/s or m/s]."""
TUMBLE = 3.0
"""A free body that turns faster tumbles [rad/s]."""


class Careful:
    """The careful steps of one model.

    Args:
        plan: What it is.
        built: What the engine made of it.
        led: Names of its joints that are on their way to a commanded position: their motion is not one
            that forces make, so that steps are plain while there are any.
    """

    def __init__(self, plan: ModelPlan, built: Built, led: Collection[str] = ()) -> None:
        self._swings = True
        self._led = led
        self._grace = GRACE
        self._skeleton = built.skeleton
        self._slowest = self._thresholds(plan, built)
        self._can_swing = min(self._slowest, default=math.inf) < math.inf

    @staticmethod
    def _thresholds(plan: ModelPlan, built: Built) -> list[float]:
        """The speed of each coordinate above which steps are careful [rad/s or m/s]."""
        found = [math.inf] * built.skeleton.getNumDofs()
        for name, joint in plan.joints.items():
            engine_joint = built.joints[name]
            slow = math.inf
            if joint.kind is JointKind.FREE:
                slow = TUMBLE
            elif joint.moves and not _is_wheel(joint, plan):
                slow = SWING
            for number in range(min(3, engine_joint.getNumDofs())):  # of six, those that turn
                found[engine_joint.getIndexInSkeleton(number)] = slow
        return found

    @property
    def is_on(self) -> bool:
        """Whether the next step is careful."""
        return self._can_swing and self._swings and not self._led

    def start(self) -> None:
        """Be careful from now on, until it has been slow for a while: it may begin to swing."""
        self._swings, self._grace = True, GRACE

    def look(self, velocities: Sequence[float]) -> None:
        """See whether it swings now.

        Args:
            velocities: Of all its coordinates [rad/s or m/s].
        """
        swings = any(abs(v) > slow for v, slow in zip(velocities, self._slowest, strict=True))
        self._grace = GRACE if swings else self._grace - 1
        self._swings = self._grace > 0

    def lean(self, step_s: float) -> None:
        """Go to the middle of the step, with the velocity that makes the engine's step end right."""
        skeleton = self._skeleton
        skeleton.integratePositions(step_s / 2.0)
        velocities = skeleton.getVelocities()
        skeleton.computeForwardDynamics()
        before = skeleton.getAccelerations()
        skeleton.integrateVelocities(step_s / 2.0)
        skeleton.computeForwardDynamics()
        change = skeleton.getAccelerations() - before
        skeleton.setVelocities(velocities + step_s * change)

    def straighten(self, step_s: float) -> None:
        """Come back from the middle of the next step to its beginning."""
        self._skeleton.integratePositions(-step_s / 2.0)


def _is_wheel(joint: JointPlan, plan: ModelPlan) -> bool:
    """Whether a joint carries one body that turns like a wheel, and nothing beyond it."""
    is_last = all(other.parent != joint.child for other in plan.joints.values())
    if joint.kind is not JointKind.REVOLUTE or not is_last or joint.stiffness > 0.0:
        return False
    return is_balanced(
        placed(plan.bodies[joint.child].body, joint.anchor.from_here(Frame())), joint.axis
    )


def is_balanced(body: Body, axis: Vector) -> bool:
    """Whether turning a body about an axis through its origin leaves its mass where it is.

    Its centre lies on the axis, to 1 mm, and its inertia is the same all round, to 1 %.
    """
    across = np.linalg.svd(np.array([axis]))[2][1:]
    low, high = np.linalg.eigvalsh(across @ np.array(body.tensor) @ across.T)
    offset = np.linalg.norm(np.cross(axis, body.centre))
    return bool(offset < 1e-3 and high - low <= 0.01 * high)
