"""Which plugins a model has, and how they are put to work.

An error names a plugin that cannot work, and the model is there without it, as in Gazebo.

Source: sdformat `parser_urdf.cc`: the plugins of `<gazebo>` without a reference belong to the model, sensors
to the link that is named; gazebo_ros_api_plugin for namespaces.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from simkit.errors import SimkitError, near_names
from simkit.graph import Node
from simkit.physics import Model, World
from simkit.physics.sdf import SdfModel
from simkit.plugins import Plugin, PluginEntry, Site, plugins
from simkit.plugins.parameters import read_parameters
from simkit.plugins.registry import NOT_HERE
from simkit.urdf import Robot
from simkit.xml import Element

STEP_HOOKS = ("before_step", "after_step")


@dataclass(frozen=True, slots=True, kw_only=True)
class PluginTag:
    """A tag `<plugin>`, and where it stands."""

    element: Element
    """The tag."""
    link: str | None = None
    """Link that it belongs to; None for the model."""
    sensor: Element | None = None
    """Sensor that it stands in."""


def tags_of_robot(robot: Robot) -> Iterator[PluginTag]:
    """The plugins of a URDF, in the order of the file; `<gazebo>` blocks that name nothing have none."""
    root = robot.document.root
    for block in [] if root is None else root.all("gazebo"):
        link = block.get("reference") or None
        if link is not None and link not in robot.links:
            continue
        yield from _tags_in(block, link)


def tags_of_sdf(model: SdfModel) -> Iterator[PluginTag]:
    """The plugins of an SDF model: its own, then those of the sensors of its links."""
    for element in model.plugins:
        yield PluginTag(element=element)
    for link in model.links:
        for sensor in link.sensors:
            for element in sensor.all("plugin"):
                yield PluginTag(element=element, link=link.name, sensor=sensor)


def _tags_in(block: Element, link: str | None) -> Iterator[PluginTag]:
    for child in block.children:
        if child.name == "plugin":
            yield PluginTag(element=child, link=link)
        elif child.name == "sensor":
            for element in child.all("plugin"):
                yield PluginTag(element=element, link=link, sensor=child)


class Attachments:
    """Puts plugins to work on models, and takes them off.

    Args:
        node: The node that they speak through.
        world: The world that calls their hooks.
        base_ns: What the time of the graph is when that of the world is 0 [ns].
    """

    def __init__(self, node: Node, world: World, base_ns: Callable[[], int]) -> None:
        self._node = node
        self._world = world
        self._base_ns = base_ns

    def attach(
        self,
        tags: Iterator[PluginTag],
        model: Model,
        *,
        robot: Robot | None,
        file: str,
        namespace: str | None,
    ) -> tuple[Plugin[Any], ...]:
        """Put the plugins of a model to work.

        Args:
            tags: Its plugins.
            model: The model.
            robot: Its URDF, if it has one.
            file: Name to show for what the tags stand in.
            namespace: That of the one who spawns it; None for a model of the world file.

        Returns:
            Those that work.
        """
        found = []
        for one in tags:
            site = Site(
                node=self._node,
                world=self._world,
                model=model,
                element=one.element,
                file=file,
                namespace=namespace,
                link=one.link,
                sensor=one.sensor,
                robot=robot,
            )
            entry = self._entry(site)
            plugin = None if entry is None else self._load(entry, site)
            if plugin is not None:
                found.append(plugin)
        return tuple(found)

    def detach(self, plugin: Plugin[Any]) -> None:
        """Take a plugin off its model."""
        for hook, calls in self._hooks(plugin):
            calls.remove(hook)
            self._world.due.pop(hook, None)
        plugin.on_detach()

    def _entry(self, site: Site) -> PluginEntry | None:
        filename = (site.element.get("filename") or "").strip()
        known = plugins()
        entry = known.get(filename)
        if filename in NOT_HERE:
            self._node.warn(
                f"{_place(site)}: {filename} is not simulated here; {site.model.name} is without it."
            )
            return None
        if entry is None:
            near = near_names(filename, known)
            hint = f" Did you mean {near[0]}?" if near else ""
            self._node.error(
                f"{_place(site)}: there is no plugin {filename!r}; {site.model.name} is without it.{hint}"
            )
            return None
        kind = None if site.sensor is None else site.sensor.get("type")
        if entry.sensor != kind:
            wanted = (
                "in a <gazebo> without a sensor"
                if entry.sensor is None
                else f'in a <sensor type="{entry.sensor}"> in a <gazebo reference="LINK">'
            )
            self._node.error(
                f"{_place(site)}: {filename} does not load here: it stands {wanted}, "
                f"so {site.model.name} is without it."
            )
            return None
        return entry

    def _load(self, entry: PluginEntry, site: Site) -> Plugin[Any] | None:
        try:
            kind = entry.load()
            parameters = read_parameters(kind.Parameters, site, speaker=kind.speaker(site))
            plugin: Plugin[Any] = kind(site, parameters)
            plugin.on_attach()
        except SimkitError as error:
            self._node.error(f"{error} ({entry.filename}: {site.model.name} is without it)")
            return None
        for hook, calls in self._hooks(plugin):
            calls.append(hook)
            if plugin.overrides("due_ns"):
                self._world.due[hook] = lambda: plugin.due_ns - self._base_ns()
        return plugin

    def _hooks(self, plugin: Plugin[Any]) -> list[tuple[Any, Any]]:
        calls = {"before_step": self._world.before_step, "after_step": self._world.after_step}
        return [
            (getattr(plugin, name), calls[name]) for name in STEP_HOOKS if plugin.overrides(name)
        ]


def _place(site: Site) -> str:
    return f"{site.file}:{site.element.span.line}:{site.element.span.column}"


__all__ = ["Attachments", "PluginTag", "tags_of_robot", "tags_of_sdf"]
