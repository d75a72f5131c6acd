"""How a simulation has a world of physics: Gazebo, on its clock."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from simkit.errors import SimkitError
from simkit.graph import Graph
from simkit.graph.process import Permissions, ScriptNode
from simkit.packages import PackagePath
from simkit.running import RunningBuiltin

if TYPE_CHECKING:
    from simkit.gazebo import Gazebo, Spawned
    from simkit.physics import World

GZSERVER = ("gazebo_ros", "gzserver")
"""The node that has a world."""


class Simulating:
    """The part of `Simulation` that has a world; physics is loaded when it is asked for."""

    graph: Graph
    packages: PackagePath
    _builtins: list[RunningBuiltin]

    def rosrun(
        self,
        package: str,
        executable: str,
        *arguments: str,
        permissions: Permissions | None = None,
    ) -> ScriptNode | RunningBuiltin:
        """Start a node."""
        raise NotImplementedError

    def _require_open(self) -> None:
        raise NotImplementedError

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
        self._require_open()
        found = self._found()
        if found is None:
            self.graph.params.set("/use_sim_time", True)
            self.rosrun(*GZSERVER, "__name:=gazebo")
            found = self._found()
        if found is None:
            raise SimkitError("no world could be started")
        return found

    @property
    def world(self) -> World:
        """The physics of `gazebo`: models, contacts, steps."""
        return self.gazebo.world

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
        from simkit.gazebo.spawning import read_model
        from simkit.geometry import Transform

        model = read_model(path_or_text, self.packages)
        gazebo = self.gazebo
        spawn = gazebo.spawn_urdf if model.is_urdf else gazebo.spawn_sdf
        return spawn(
            model.text,
            name=name or model.name,
            pose=Transform.from_rpy(xyz, rpy),
            namespace=namespace,
            file=model.file,
        )

    def _found(self) -> Gazebo | None:
        from simkit.gazebo.finding import gazebo_of

        for node in reversed(self._builtins):
            if node.alive and (found := gazebo_of(node.program)) is not None:
                return found
        return None

    def _begin_with_world(self) -> None:
        """As on a robot that starts with Gazebo, time begins at 0, if it has not begun."""
        self.graph.executor.begin_at(0)
