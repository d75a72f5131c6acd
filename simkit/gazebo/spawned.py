"""A model in the world, with where it comes from and what works on it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from simkit.physics import Model
from simkit.physics.sdf import SdfModel
from simkit.plugins import Plugin
from simkit.urdf import Robot


@dataclass(frozen=True, slots=True, kw_only=True)
class Spawned:
    """One model."""

    name: str
    """Its name in the world."""
    model: Model
    """Its bodies and joints."""
    robot: Robot | None = None
    """The URDF that it was spawned from."""
    sdf: SdfModel | None = None
    """The SDF that it was spawned from, if it was no URDF."""
    plugins: tuple[Plugin[Any], ...] = ()
    """What works on it, in the order of the tags."""
    namespace: str | None = None
    """Namespace of the one who spawned it; None for a model of the world file."""
