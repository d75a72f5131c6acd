"""How a simulation has a world of physics: Gazebo, on its clock."""

from __future__ import annotations

import weakref
from pathlib import Path
from typing import TYPE_CHECKING

from simkit.errors import SimkitError

if TYPE_CHECKING:
    from simkit.gazebo import Gazebo, Spawned
    from simkit.simulation.simulation import Simulation

GZSERVER = ("gazebo_ros", "gzserver")
"""The node that has a world."""


class GazeboStarter:
    """The part of a `Simulation` that has a world; physics is loaded when it is asked for.

    Args:
        sim: The simulation.
    """

    def __init__(self, sim: Simulation) -> None:
        self._sim: Simulation = weakref.proxy(sim)

    @property
    def has_world(self) -> bool:
        """Whether a world is there already."""
        return self._found() is not None

    @property
    def gazebo(self) -> Gazebo:
        """The world with its models, plugins and services; an empty world with a ground is started if there is none.

        Raises:
            SimkitError: The simulation is closed, or there is no physics engine on this machine.
        """
        self._sim.require_open()
        found = self._found()
        if found is None:
            self._sim.graph.params.set("/use_sim_time", True)
            self._sim.start_node(*GZSERVER, "__name:=gazebo")
            found = self._found()
        if found is None:
            raise SimkitError("no world could be started")
        return found

    def spawn(
        self,
        path_or_text: str | Path,
        *,
        name: str | None = None,
        xyz: tuple[float, float, float] = (0.0, 0.0, 0.0),
        rpy: tuple[float, float, float] = (0.0, 0.0, 0.0),
        namespace: str = "/",
    ) -> Spawned:
        """Bring a robot into the world, as `spawn_model` does.

        Args:
            path_or_text: A URDF or SDF file, or its text.
            name: Its name in the world; that of the file's robot if None.
            xyz: Where it shall be [m].
            rpy: Roll, pitch and yaw that it shall have [rad].
            namespace: Where the names of its plugins are that say nothing of it.

        Raises:
            SimkitError: There is no such file, or no such model can be.
        """
        from simkit.gazebo.models import read_model
        from simkit.geometry import Transform

        model = read_model(path_or_text, self._sim.packages)
        gazebo = self._sim.gazebo
        spawn = gazebo.spawn_urdf if model.is_urdf else gazebo.spawn_sdf
        return spawn(
            model.text,
            name=name or model.name,
            pose=Transform.from_rpy(xyz, rpy),
            namespace=namespace,
            file=model.file,
        )

    def _found(self) -> Gazebo | None:
        """The world of the newest gzserver; asking does not load the code of worlds."""
        for node in reversed(self._sim.builtins):
            found: Gazebo | None = getattr(node.program, "gazebo", None)
            if node.alive and found is not None:
                return found
        return None

    def begin(self) -> None:
        """As on a robot that starts with Gazebo, time begins at 0, if it has not begun."""
        self._sim.graph.executor.begin_at(0)
