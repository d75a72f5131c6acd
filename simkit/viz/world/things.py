"""What a view sees of Gazebo: a world, and where its models come from."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

from simkit.physics import Model, World
from simkit.physics.sdf import SdfModel
from simkit.urdf import Robot


class Thing(Protocol):
    """A model in the world, with the file that it comes from: `simkit.gazebo.Spawned` is one."""

    @property
    def model(self) -> Model:
        """Its bodies and joints."""

    @property
    def robot(self) -> Robot | None:
        """The URDF that it was made from."""

    @property
    def sdf(self) -> SdfModel | None:
        """The SDF that it was made from."""

    @property
    def plugins(self) -> tuple[Any, ...]:
        """What works on it."""


class WorldOfThings(Protocol):
    """A world with its models: `simkit.gazebo.Gazebo` is one."""

    @property
    def world(self) -> World:
        """The physics."""

    @property
    def spawned(self) -> Mapping[str, Thing]:
        """The models by name, the oldest first."""


def link_frame(model: str, link: str) -> str:
    """The name of a link among all of the world, as Gazebo writes it."""
    return f"{model}::{link}"
