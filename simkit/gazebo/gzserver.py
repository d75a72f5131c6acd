"""gzserver as a node: starts a world, and offers it to ROS.

Source: gazebo_ros `empty_world.launch` and gzserver's command line.
"""

from __future__ import annotations

from typing import Final

from simkit.commands.errors import UsageError
from simkit.diagnostics import Severity
from simkit.gazebo.server import Gazebo
from simkit.gazebo.services import offer_services
from simkit.gazebo.topics import publish_states
from simkit.gazebo.watchers import watch
from simkit.gazebo.worlds import find_world
from simkit.graph import Node
from simkit.nodes.program import Program
from simkit.packages import PackagePath
from simkit.physics.sdf import SdfWorld

USAGE: Final = "usage: gzserver [-u] [-r] [--verbose] [-e ENGINE] [WORLD_FILE]"
_FLAGS = ("-r", "--record", "--verbose", "-q", "--quiet")
_WITH_VALUE = ("-e", "--physics", "--seed", "--iters", "-s", "--server-plugin")


class GzServer(Program):
    """The program `gzserver` of the package gazebo_ros; the node is named `gazebo`.

    Args:
        node: Its place in the graph.
        argv: `-u` begins at rest; the world file; other options of gzserver change nothing here.
        packages: Where world files and models are.

    Raises:
        UsageError: An argument is none of these.
        SimkitError: There is no such world, or dartpy is missing.
    """

    def __init__(self, node: Node, argv: list[str], packages: PackagePath) -> None:
        super().__init__(node)
        name, is_paused = _arguments(argv)
        world = find_world(name, packages)
        _warn_of_losses(node, world)
        self.gazebo = Gazebo(node, packages, description=world, paused=is_paused)
        offer_services(self.gazebo)
        publish_states(self.gazebo)
        watch(self.gazebo)


def _arguments(argv: list[str]) -> tuple[str, bool]:
    """World file, and whether it begins at rest."""
    is_paused, names, rest = False, [], list(argv)
    while rest:
        word = rest.pop(0)
        if word in ("-u", "--pause"):
            is_paused = True
        elif word in _WITH_VALUE:
            if not rest:
                raise UsageError(f"gzserver: {word} needs a value; {USAGE}")
            rest.pop(0)
        elif word.startswith("-") and word not in _FLAGS:
            raise UsageError(f"gzserver: {word!r} is no argument of it; {USAGE}")
        elif not word.startswith("-"):
            names.append(word)
    if len(names) > 1:
        raise UsageError(f"gzserver: two world files, {' and '.join(names)}; {USAGE}")
    return (names[0] if names else ""), is_paused


def _warn_of_losses(node: Node, world: SdfWorld) -> None:
    """Warn of what the world file has and the world has not."""
    for one in world.diagnostics:
        if one.severity is not Severity.NOTE:
            node.warn(f"{one.file}:{one.span.line}:{one.span.column}: {one.what}")
    for element in world.plugins:
        name = element.get("filename") or "?"
        node.warn(f"line {element.span.line}: the plugin {name} of the world is not simulated")
