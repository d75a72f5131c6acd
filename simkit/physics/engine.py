"""DART, the physics engine: dartpy is imported here and nowhere else, when a world is made.

Which collision detector? Measured with dartpy 6.20.0, steps of 1 ms, gravity 9.8, drift over 10 s at
rest (`benchmarks/bench_physics.py` measures two rows anew). DART offers four:

| at rest on the plane z = 0 | ode | bullet | fcl | dart |
|---|---|---|---|---|
| box 0.2 x 0.3 x 0.1 | 0.001 mm | 1.8 mm | 0.001 mm | sinks through it |
| cylinder, standing | 0.001 mm | 0.05 mm | 0.001 mm | 0.001 mm |
| cylinder, lying askew | 0.000 mm | 720 mm | 0.000 mm | sinks in by 69 mm |
| the same, 1.57 for pi/2 | 0.000 mm | 640 mm | sinks in by 69 mm | sinks in by 69 mm |
| cylinder on a cylinder | 0.000 mm | 0.000 mm | sinks in by 10 mm | sinks in by 23 mm |
| tower of four boxes | 0.000 mm | 0.000 mm | 0.2 mm | 1.5 mm |

Only `ode` gives flat faces as many points of contact as it takes to stand on them, so it is ours.
It casts no rays; `simkit.physics.rays` does, and faster. The ground is a plane without end.

Bodies at rest are not put to sleep: DART would also freeze what moves slower than 1 cm/s.
"""

from __future__ import annotations

import functools
import platform
import sys
from typing import Any

from simkit.geometry import Vector
from simkit.physics.errors import NoEngineError

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
