"""What a script may do on the graph: an exercise says it, the graph holds to it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase

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
