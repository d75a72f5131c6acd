"""What a node process starts with: its script, what it may use, and what it may say to the graph."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

MIB = 1024 * 1024


@dataclass(frozen=True, slots=True, kw_only=True)
class NodeLimits:
    """Limits of one node process; None leaves the system's own."""

    cpu_seconds: int | None = None
    """Processor time over the process's whole life [s]."""
    memory_bytes: int | None = None
    """Address space [bytes]."""
    processes: int | None = None
    """Processes and threads of the user at the same time; the kernel does not hold root to it."""
    open_files: int | None = None
    """Open file descriptors."""
    file_bytes: int | None = None
    """Size of any file it writes [bytes]."""
    output_bytes: int = 8 * MIB
    """What it may print; a node that prints more is stopped [bytes]."""

    def to_json(self) -> dict[str, int | None]:
        """As a JSON object."""
        return asdict(self)

    @classmethod
    def from_json(cls, value: dict[str, Any]) -> NodeLimits:
        """From `to_json`'s object."""
        return cls(**value)


def apply_limits(limits: NodeLimits) -> None:
    """Hold the calling process to `limits`, where the platform can."""
    try:
        import resource
    except (
        ImportError
    ):  # Windows has no rlimits: the reader of the output and the allowance still hold
        return
    wanted = {
        resource.RLIMIT_CPU: limits.cpu_seconds,
        resource.RLIMIT_AS: limits.memory_bytes,
        resource.RLIMIT_NPROC: limits.processes,
        resource.RLIMIT_NOFILE: limits.open_files,
        resource.RLIMIT_FSIZE: limits.file_bytes,
        resource.RLIMIT_CORE: 0,
    }
    for kind, value in wanted.items():
        if value is not None:
            _set_limit(kind, value)


def _set_limit(kind: int, value: int) -> None:
    import resource

    _, hard = resource.getrlimit(kind)
    if hard != resource.RLIM_INFINITY:
        value = min(value, hard)
    resource.setrlimit(kind, (value, value))


_ALWAYS = ("/rosout",)


@dataclass(frozen=True, slots=True, kw_only=True)
class Permissions:
    """Names, as shell patterns of resolved names, that a node may write."""

    publish: tuple[str, ...] = ("*",)
    """Topics it may publish on."""
    services: tuple[str, ...] = ("*",)
    """Services it may call or offer."""
    parameters: tuple[str, ...] = ("*",)
    """Parameters it may set or delete; its private ones are always its own."""
    nodes: tuple[str, ...] = ("*",)
    """Built-in nodes that a launch file may start, as `package/executable`."""

    def refuse_publishing(self, topic: str) -> str | None:
        """Why a topic may not be published on, or None."""
        return _refusal("publishes on", topic, self.publish)

    def refuse_service(self, service: str) -> str | None:
        """Why a service may not be used, or None."""
        return _refusal("uses the service", service, self.services)

    def refuse_parameter(
        self, parameter: str, *node_names: str, who: str = "this node"
    ) -> str | None:
        """Why a parameter may not be written, or None.

        Args:
            parameter: Its global name.
            *node_names: Nodes whose private parameters may be written.
            who: Who writes.
        """
        if any(parameter.startswith(name.rstrip("/") + "/") for name in node_names):
            return None
        return _refusal("sets the parameter", parameter, self.parameters, who=who)

    def refuse_node(self, package: str, executable: str) -> str | None:
        """Why a launch file may not start a built-in node, or None."""
        return _refusal("starts", f"{package}/{executable}", self.nodes, who="this launch file")


def _refusal(deed: str, name: str, allowed: Sequence[str], *, who: str = "this node") -> str | None:
    if any(fnmatchcase(name, pattern) for pattern in (*allowed, *_ALWAYS)):
        return None
    instead = "only " + ", ".join(allowed) if allowed else "none at all"
    return f"{who} {deed} {name}, which this exercise does not allow ({instead})"


@dataclass(frozen=True, slots=True, kw_only=True)
class StartSpec:
    """One script to run as a node."""

    script: str
    """Path of the script file."""
    shown_path: str
    """Path to show in messages, e.g. `hello_ros/scripts/x.py`."""
    arguments: tuple[str, ...] = ()
    """Command line behind the script's name, remappings included."""
    working_directory: str | None = None
    """Where the script runs; its own folder if None."""
    seed: int = 0
    """Seeds `random` and numpy's global generator."""
    now_ns: int = 0
    """Virtual time at the start [ns]."""
    limits: NodeLimits = field(default_factory=NodeLimits)
    """What the process may use."""
    drop_to_uid: int | None = None
    """User and group to become before the script runs (only root can)."""

    @property
    def node_name(self) -> str:
        """Name of the node until the script says its own: that of its file."""
        stem = Path(self.script).stem
        legal = (c if c.isascii() and (c.isalnum() or c == "_") else "_" for c in stem)
        return "".join(legal) or "node"

    def to_bytes(self) -> bytes:
        """As JSON."""
        return json.dumps(asdict(self)).encode()

    @classmethod
    def from_bytes(cls, data: bytes) -> StartSpec:
        """From `to_bytes`."""
        value: dict[str, Any] = json.loads(data)
        limits = NodeLimits.from_json(value.pop("limits"))
        arguments = tuple(value.pop("arguments"))
        return cls(**value, limits=limits, arguments=arguments)
