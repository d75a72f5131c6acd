"""The arm of the book as a double pendulum, integrated without an engine: what a simulation of it is compared with.

The torso turns about z by the hip, the upper arm about y by the shoulder, which stands beside the
torso. Source: Lagrange's equations of the two angles; the hip's momentum is conserved.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias

State: TypeAlias = tuple[float, float, float, float]
"""Hip and shoulder [rad], and their velocities [rad/s]."""

STEP = 5e-4
"""Step of the integration [s]; its error is far below what a check looks at."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SwingingArm:
    """An arm on a torso, without friction; the numbers are the book's."""

    mass: float = 1.0
    """Of the upper arm [kg]."""
    lever: float = 0.2
    """From the shoulder to the middle of the arm [m]."""
    offset: float = -0.1
    """Where the shoulder is along y of the torso [m]."""
    torso: float = 0.00125
    """Inertia of the torso about its length [kg m^2]."""
    across: float = (3 * 0.05**2 + 0.4**2) / 12
    """Inertia of the arm about an axis across it, through its middle [kg m^2]."""
    along: float = 0.05**2 / 2
    """Inertia of the arm about its length [kg m^2]."""
    gravity: float = 9.8
    """[m/s^2]."""

    @property
    def inertia(self) -> float:
        """Of the arm about the shoulder [kg m^2]."""
        return self.mass * self.lever**2 + self.across

    def swing(self, hip: float, shoulder: float, seconds: float) -> tuple[float, float]:
        """Where hip and shoulder are after a time [rad], from rest."""
        state: State = (hip, shoulder, 0.0, 0.0)
        steps = round(seconds / STEP)
        for _ in range(steps):
            state = self._step(state, seconds / steps)
        return state[0], state[1]

    def _step(self, state: State, dt: float) -> State:
        """One step of Runge and Kutta, of fourth order."""
        a = self._rate(state)
        b = self._rate(_moved(state, a, dt / 2))
        c = self._rate(_moved(state, b, dt / 2))
        d = self._rate(_moved(state, c, dt))
        mean = tuple((p + 2 * q + 2 * r + s) / 6 for p, q, r, s in zip(a, b, c, d, strict=True))
        return _moved(state, mean, dt)

    def _rate(self, state: State) -> State:
        _, s, hip_speed, shoulder_speed = state
        sin, cos = math.sin(s), math.cos(s)
        moment = self.mass * self.lever
        cross = self.offset * moment * sin  # couples the two, since the arm is beside the torso
        swung = moment * self.lever + self.across - self.along
        about_hip = self.torso + self.mass * self.offset**2 + self.along + swung * cos * cos
        change = -2 * swung * sin * cos  # of about_hip, with the shoulder's angle
        pull = 0.5 * change * hip_speed**2 + moment * self.gravity * cos
        drag = -(
            change * shoulder_speed * hip_speed + self.offset * moment * cos * shoulder_speed**2
        )
        whole = about_hip * self.inertia - cross * cross
        return (
            hip_speed,
            shoulder_speed,
            (self.inertia * drag - cross * pull) / whole,
            (about_hip * pull - cross * drag) / whole,
        )


def _moved(state: State, rate: tuple[float, ...], dt: float) -> State:
    a, b, c, d = (x + dt * v for x, v in zip(state, rate, strict=True))
    return (a, b, c, d)
