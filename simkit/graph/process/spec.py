"""What a node process is told when it starts."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from simkit.graph.process.limits import NodeLimits


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
