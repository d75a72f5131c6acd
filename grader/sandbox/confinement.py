"""What a sandbox hands to the runtime of node processes."""

from __future__ import annotations

from dataclasses import dataclass, field

from simkit.graph.process import NodeLimits


@dataclass(frozen=True, slots=True, kw_only=True)
class Confinement:
    """How the node processes of one simulation are started."""

    command_prefix: tuple[str, ...]
    """Put before the command of the nodes' warm parent."""
    limits: NodeLimits
    """What each node process may use."""
    environment: dict[str, str] = field(default_factory=dict)
    """Added to the clean environment that simkit gives to every node process."""
