"""Names of ROS graph resources: legality, resolution, remapping, and the command line that carries them.

Source: rosgraph `names` as described on the ROS wiki page "Names".
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, field

from simkit.graph.errors import GraphError, RosCommandError

_LEGAL = re.compile(r"^[~/A-Za-z][\w/]*$", re.ASCII)
_LEGAL_BASE = re.compile(r"^[A-Za-z][\w]*$", re.ASCII)


def is_legal_name(name: str) -> bool:
    """Whether `name` may name a resource: a letter, `/` or `~` first, then letters, digits, `_`, `/`."""
    return _LEGAL.match(name) is not None and "//" not in name


def is_legal_node_name(name: str) -> bool:
    """Whether `name` may name a node: no `/`, a letter first."""
    return _LEGAL_BASE.match(name) is not None


def namespace_of(name: str) -> str:
    """Namespace of a resolved name, ending in `/`: `/a/b` lies in `/a/`."""
    return name.rstrip("/").rpartition("/")[0] + "/"


def join(namespace: str, name: str) -> str:
    """`name` inside `namespace`, unless it is global or private already."""
    if not name:
        return namespace.rstrip("/") or "/"
    if name[0] in "/~":
        return name
    return namespace.rstrip("/") + "/" + name


def free_name(base: str, taken: Container[str]) -> str:
    """The first of `base_1`, `base_2`, ... that is not taken."""
    return next(name for n in itertools.count(1) if (name := f"{base}_{n}") not in taken)


def resolve(name: str, node_name: str, remappings: Mapping[str, str] | None = None) -> str:
    """The global name that `name` stands for in a node.

    Args:
        name: `x` (relative), `/x` (global) or `~x` (private).
        node_name: Resolved name of the node, e.g. `/turtlesim`.
        remappings: Resolved name to resolved name, as `split_command_line` gives.

    Raises:
        GraphError: `name` is not a legal name.
    """
    if name and not is_legal_name(name):
        raise GraphError(
            f"{name!r} is not a legal name: letters, digits, _ and / only, a letter, / or ~ first"
        )
    if name.startswith("~"):
        resolved = node_name.rstrip("/") + "/" + name[1:].lstrip("/")
    else:
        resolved = join(namespace_of(node_name), name)
    if len(resolved) > 1:
        resolved = resolved.rstrip("/")
    return (remappings or {}).get(resolved, resolved)


@dataclass(frozen=True, slots=True, kw_only=True)
class CommandLine:
    """What a ROS command line says besides the program's own arguments."""

    arguments: tuple[str, ...] = ()
    """The program's own arguments, remappings taken out."""
    remappings: Mapping[str, str] = field(default_factory=dict)
    """`from` to `to` of each `from:=to`, as written."""
    private_parameters: Mapping[str, object] = field(default_factory=dict)
    """Values of `_name:=value`, read as YAML."""
    node_name: str | None = None
    """`__name:=`: the node's name, whatever `init_node` says."""
    namespace: str = "/"
    """`__ns:=`: the namespace in which the node's names resolve."""

    def resolved_remappings(self, node_name: str) -> dict[str, str]:
        """Remappings between global names, for a node of that resolved name."""
        return {
            resolve(source, node_name): resolve(target, node_name)
            for source, target in self.remappings.items()
        }


def split_command_line(arguments: Sequence[str]) -> CommandLine:
    """Take remappings, private parameters and special names out of a command line.

    Args:
        arguments: E.g. `["_turtle:=turtle2", "__name:=b", "pose:=/x", "fast"]`.

    Raises:
        RosCommandError: A value is not YAML, or a special name is unknown or not legal.
    """
    own: list[str] = []
    remappings: dict[str, str] = {}
    parameters: dict[str, object] = {}
    special: dict[str, str] = {}
    for argument in arguments:
        left, found, right = argument.partition(":=")
        if not found or not left:
            own.append(argument)
        elif left.startswith("__"):
            special[left] = right
        elif left.startswith("_"):
            parameters[left[1:]] = _yaml_value(argument, right)
        else:
            _require_legal(argument, left, right)
            remappings[left] = right
    node_name = special.get("__name")
    if node_name is not None and not is_legal_node_name(node_name):
        raise RosCommandError(
            f"__name:={node_name}: a node's name has no '/' and starts with a letter"
        )
    return CommandLine(
        arguments=tuple(own),
        remappings=remappings,
        private_parameters=parameters,
        node_name=node_name,
        namespace=join("/", special.get("__ns", "/")),
    )


def _yaml_value(argument: str, text: str) -> object:
    import yaml  # takes 10 ms to load, and most nodes are given no parameters

    try:
        return yaml.safe_load(text) if text else ""
    except yaml.YAMLError as error:
        raise RosCommandError(f"{argument}: the value is not YAML: {error}") from error


def _require_legal(argument: str, *names: str) -> None:
    for name in names:
        if not is_legal_name(name):
            raise RosCommandError(f"{argument}: {name!r} is not a legal name")
