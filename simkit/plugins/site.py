"""What a plugin is given: its model, its node, and where its tag stands."""

from __future__ import annotations

import zlib
from dataclasses import dataclass

from simkit.errors import SimkitError
from simkit.graph import Node
from simkit.physics import Model, World
from simkit.urdf import Robot
from simkit.xml import Element


class PluginError(SimkitError):
    """A plugin cannot work as its tag says; it is not loaded, and its model is there without it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Site:
    """The place of one plugin."""

    node: Node
    """The node `/gazebo`: whatever a plugin publishes comes from it."""
    world: World
    """The world; its clock counts from its own beginning, that of the graph is `now_ns`."""
    model: Model
    """The model that it belongs to."""
    element: Element
    """Its tag `<plugin>`."""
    file: str = ""
    """Name to show for what the tag stands in."""
    namespace: str | None = None
    """Namespace of the one who spawned the model, for a tag that has none; None for a model of a world file."""
    link: str | None = None
    """Link that its `<gazebo reference="...">` names; None if it is a plugin of the model."""
    sensor: Element | None = None
    """The tag `<sensor>` around it; None if there is none."""
    robot: Robot | None = None
    """The URDF; None for a model of SDF."""

    @property
    def name(self) -> str:
        """Name of the plugin, from its tag."""
        return self.element.get("name") or self.element.get("filename") or "plugin"

    @property
    def robot_namespace(self) -> str:
        """Where its names are, without slashes around; empty at the root.

        Source:
            gazebo_ros: `<robotNamespace>`, which spawning adds where it is missing; else the model's name.
        """
        tag = self.element.child("robotNamespace")
        if tag is not None and tag.text.strip():
            return tag.text.strip().strip("/")
        return self.model.name if self.namespace is None else self.namespace.strip("/")

    @property
    def now_ns(self) -> int:
        """Virtual time of the graph [ns]."""
        return self.node.graph.executor.now_ns

    def place(self, element: Element) -> str:
        """Where a tag stands, to begin a sentence with."""
        return f"{self.file or self.model.name}:{element.span.line}:{element.span.column}"

    def resolve(self, name: str) -> str:
        """The global name of a topic, service or parameter of the plugin."""
        if name.startswith("/") or not self.robot_namespace:
            return "/" + name.strip("/")
        return f"/{self.robot_namespace}/{name.strip('/')}"

    def seed(self, *words: str) -> int:
        """A seed for what is random in the plugin: that of the simulation, the model, and what is given."""
        text = "/".join((str(self.node.graph.seed), self.model.name, self.link or "", *words))
        return zlib.crc32(text.encode())
