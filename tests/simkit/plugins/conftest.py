"""A stage for plugins: a world on the clock of a graph, robots in it, and ears on topics."""

from __future__ import annotations

from typing import Any

import pytest

from simkit.gazebo import Gazebo
from simkit.gazebo.worlds import find_world
from simkit.geometry import Transform
from simkit.graph import Executor, Graph, LogLevel
from simkit.msgs import message_class
from simkit.packages import PackagePath
from simkit.physics import NoEngineError


class Stage:
    """An empty world with a ground, and someone who listens."""

    def __init__(self, seed: int = 0) -> None:
        self.graph = Graph(Executor(0), None, seed=seed)
        packages = PackagePath([])
        self.gazebo = Gazebo(
            self.graph.create_node("/gazebo"), packages, description=find_world("", packages)
        )
        self.listener = self.graph.create_node("/listener")

    def spawn(self, inside: str, *, name: str = "r", pose: Transform | None = None, **options):
        """A robot of what stands in its `<robot>`."""
        return self.gazebo.spawn_urdf(
            f'<robot name="{name}">{inside}</robot>',
            name=name,
            pose=pose or self.at(),
            file=f"{name}.urdf",
            **options,
        )

    @staticmethod
    def at(x=0.0, y=0.0, z=0.0, roll=0.0, pitch=0.0, yaw=0.0) -> Transform:
        """A pose."""
        return Transform.from_rpy((x, y, z), (roll, pitch, yaw))

    def listen(self, topic: str, kind: str) -> list[Any]:
        """The messages of a topic, from now on."""
        heard: list[Any] = []
        self.listener.subscribe(topic, message_class(kind), heard.append)
        return heard

    def run(self, seconds: float) -> None:
        """Let time pass [s]."""
        executor = self.graph.executor
        executor.run_to(executor.now_ns + round(seconds * 1e9))

    def said(self, level: LogLevel = LogLevel.WARN) -> list[str]:
        """What `/gazebo` said so far, from a level on."""
        return [
            one.text for one in self.graph.records if one.node == "/gazebo" and one.level >= level
        ]


@pytest.fixture
def new_stage():
    """Makes a stage; skips where dartpy is not."""

    def make(seed: int = 0) -> Stage:
        try:
            return Stage(seed)
        except NoEngineError as error:
            pytest.skip(str(error))

    return make


@pytest.fixture
def stage(new_stage) -> Stage:
    """A stage."""
    return new_stage()


@pytest.fixture
def link():
    """Writes a link of 1 kg."""

    def make(
        name: str = "base", shape: str = '<box size="0.2 0.2 0.2"/>', mass: float = 1.0
    ) -> str:
        collision = f"<collision><geometry>{shape}</geometry></collision>" if shape else ""
        return (
            f'<link name="{name}"><inertial><mass value="{mass}"/><inertia ixx="0.01" iyy="0.01" '
            f'izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>{collision}</link>'
        )

    return make
