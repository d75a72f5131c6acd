"""The engine, DART: its world, and poses and vectors on their way between it and us."""

from __future__ import annotations

import functools
import math
import platform
import sys
from typing import Any

import numpy as np

from simkit.geometry import Transform, Vector
from simkit.physics.errors import NoEngineError, PhysicsError

STEP_NS = 1_000_000
"""Time of one step [ns], as Gazebo's."""
GRAVITY: Vector = (0.0, 0.0, -9.8)
"""Acceleration of all that falls [m/s^2], as Gazebo's."""
WHEELS = "Linux with Python 3.10 to 3.14; Windows, and macOS 15 or newer on Apple silicon, with Python 3.12 to 3.14"
"""Where pip finds dartpy ready to use."""


@functools.cache
def dart() -> Any:
    """The module dartpy.

    Raises:
        NoEngineError: It is not installed, or does not load.
    """
    try:
        import dartpy  # type: ignore[import-not-found, unused-ignore]
    except ImportError as error:
        here = f"{platform.system()} {platform.machine()}, Python {sys.version_info[0]}.{sys.version_info[1]}"
        raise NoEngineError(
            f"the simulator needs dartpy, which does not load here ({error}): pip install dartpy. "
            f"There are wheels for {WHEELS}; this is {here}. Everything without physics works without it."
        ) from None
    return dartpy


def new_engine_world(step_s: float, gravity: Vector) -> Any:
    """An empty `dartpy.simulation.World` as we use it.

    Args:
        step_s: Time of one step [s].
        gravity: Acceleration of all that falls [m/s^2].
    """
    simulation = dart().simulation
    world = simulation.World()
    world.setTimeStep(step_s)
    world.setGravity(list(gravity))
    world.setCollisionDetector(simulation.CollisionDetectorType.ODE)
    sleep = world.getDeactivationOptions()
    sleep.mEnabled = False
    world.setDeactivationOptions(sleep)
    return world


FARTHEST = 1e6
"""Nothing is put farther from the origin of the world [m]."""


def isometry(transform: Transform) -> Any:
    """T_ab as the engine takes it."""
    return dart().math.Isometry3(np.array(transform.matrix), np.array(transform.translation))


def transform_of(isometry: Any) -> Transform:
    """T_ab of an `Isometry3` of the engine."""
    (a, b, c, x), (d, e, f, y), (g, h, i, z), _ = isometry.matrix().tolist()
    return Transform.from_matrix((x, y, z), ((a, b, c), (d, e, f), (g, h, i)))


def checked_pose(pose: Transform) -> Transform:
    """A pose with its quaternion at unit length.

    Raises:
        PhysicsError: A number is NaN, the quaternion is zero, or it is farther than `FARTHEST`.
    """
    length = math.hypot(*pose.rotation)
    if not 1e-9 < length < math.inf or not all(abs(x) <= FARTHEST for x in pose.translation):
        raise PhysicsError(f"this is no pose: {pose.translation} with quaternion {pose.rotation}")
    return pose.normalised()


def vector(array: Any) -> Vector:
    """Three numbers of the engine as a tuple."""
    x, y, z = array.tolist()
    return (x, y, z)
