"""Recordings: of topics, of a model, of the whole world."""

from __future__ import annotations

import weakref
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from simkit.errors import UnknownNameError
from simkit.graph.recording import Recording
from simkit.simulation.world_window import world_to_see

if TYPE_CHECKING:
    from simkit.physics import Model
    from simkit.simulation.simulation import Simulation
    from simkit.viz import ModelRecording, WorldTape


class Recorder:
    """The part of a `Simulation` that records.

    Args:
        sim: The simulation.
    """

    def __init__(self, sim: Simulation) -> None:
        self._sim: Simulation = weakref.proxy(sim)

    def record(self, topics: Iterable[str] | Mapping[str, str]) -> Recording:
        """Record topics from now on.

        Args:
            topics: Names of topics in use, or names with types for topics that are still to come.

        Raises:
            UnknownNameError: A topic is not in use and no type is given.
        """
        return Recording(self._sim.node, self._sim.graph_client.message_classes(topics))

    def record_model(self, name: str, *, rate: float = 100.0) -> ModelRecording:
        """Record a model of the world from now on: its true pose; position, velocity, effort of its joints.

        Args:
            name: Name of the model in the world.
            rate: Samples a second of virtual time.

        Raises:
            UnknownNameError: No such model is in the world.
            SimkitError: The rate is out of range.
        """
        from simkit.viz import ModelRecording

        gazebo = self._sim.gazebo
        if name not in gazebo.spawned:
            raise UnknownNameError("model in the world", name, gazebo.spawned)
        recorded = gazebo.spawned[name]

        def find() -> Model | None:
            # Another model of the same name is another model.
            return recorded.model if gazebo.spawned.get(name) is recorded else None

        return ModelRecording(self._sim.node, name, find, rate=rate)

    def record_world(self, *, rate: float = 30.0) -> WorldTape:
        """Record where all links and joints are from now on, what touches, and what lasers see.

        Args:
            rate: How often to look [Hz of virtual time], rounded to whole milliseconds.

        Returns:
            A recording with `link(model, link)`, `joint(model, joint)`, `contacts`, `scans`, `stop()`.

        Raises:
            SimkitError: There is no world, or the rate makes no sense.
        """
        from simkit.viz import WorldTape

        gazebo = world_to_see(self._sim)
        return WorldTape(gazebo, gazebo.node, rate=rate)
