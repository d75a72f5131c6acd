"""Velocity decay: a share of their velocity that bodies lose by themselves, whatever they do."""

from __future__ import annotations

from typing import Any

from simkit.physics.plan import ModelPlan
from simkit.physics.skeleton import Built

DECAY_STEP_S = 1e-3
"""The step that a decay is a share of [s]."""


class VelocityDecay:
    """The bodies of one model that lose velocity by themselves.

    Args:
        plan: The model.
        built: What the engine has made of it.
        pushed: Where bodies are entered that are pushed in the next step.

    Source:
        `dampingFactor` of URDF, which is `velocity_decay` of SDF and, for ODE, a share of a step of 1 ms.
    """

    def __init__(self, plan: ModelPlan, built: Built, pushed: list[Any]) -> None:
        self._bodies = [
            (built.bodies[one.name], one.decay) for one in plan.bodies.values() if one.decay > 0.0
        ]
        self._pushed = pushed

    @property
    def is_on(self) -> bool:
        """Whether a body of the model loses velocity."""
        return bool(self._bodies)

    def act(self, step_s: float) -> None:
        """Take from each body its share of velocity, in the next step of `step_s` seconds."""
        for body, decay in self._bodies:
            share = (1.0 - (1.0 - decay) ** (step_s / DECAY_STEP_S)) / step_s
            inertia, turn = body.getInertia(), body.getWorldTransform().rotation()
            moment = turn @ inertia.getMoment() @ turn.T
            linear, angular = body.getCOMLinearVelocity(), body.getAngularVelocity()
            drag = -share * inertia.getMass() * linear
            body.addExtForce(drag, inertia.getLocalCOM(), False, True)
            body.addExtTorque(-share * moment @ angular, False)
            self._pushed.append(body)
