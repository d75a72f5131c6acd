"""Where node processes come from: one fork server (or fresh interpreters), its sandbox and its limits."""

from __future__ import annotations

import atexit
import weakref
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from simkit.graph.process.fork_server import HAS_FORK, StartError
from simkit.graph.process.spec import NodeLimits, StartSpec
from simkit.graph.process.starters import ForkStarter, SpawnStarter, StartedProcess, Starter


class NodeRuntime:
    """Starts node processes, and ends every one of them when it closes.

    Args:
        command_prefix: Put before the interpreter's command line, e.g. bubblewrap and its options.
        limits: What each node process may use.
        environment: More environment variables for the nodes.
        allowance: Wall time for which a script may compute without blocking [s].
        method: `fork` or `spawn`; the quicker one that works here if None.
        drop_to_uid: User to become before a script runs; only root can.
    """

    def __init__(
        self,
        command_prefix: Sequence[str] = (),
        *,
        limits: NodeLimits | None = None,
        environment: Mapping[str, str] | None = None,
        allowance: float = 5.0,
        method: str | None = None,
        drop_to_uid: int | None = None,
    ) -> None:
        self.allowance = allowance
        self.limits = limits or NodeLimits()
        self._prefix = tuple(command_prefix)
        self._environment = dict(environment or {})
        self._method = method
        self._drop_to_uid = drop_to_uid
        self._starter: Starter | None = None
        _open_runtimes.add(self)

    def warm_up(self) -> None:
        """Start the fork server now; the first node then need not wait for it."""
        if self._starter is None:
            self._starter = default_starter(self._prefix, self._environment, self._method)

    def start(self, spec: StartSpec) -> StartedProcess:
        """Start a node process; a fork server that has died is replaced once.

        Raises:
            StartError: No process can be started.
        """
        spec = replace(
            spec,
            script=str(Path(spec.script).absolute()),
            limits=self.limits,
            drop_to_uid=self._drop_to_uid,
        )
        self.warm_up()
        assert self._starter is not None
        try:
            return self._starter.start(spec)
        except StartError:
            self.close()
        self.warm_up()
        return self._starter.start(spec)

    def close(self) -> None:
        """End every node process."""
        if self._starter is not None:
            self._starter.close()
            self._starter = None


def default_starter(
    command_prefix: Sequence[str], environment: Mapping[str, str], method: str | None = None
) -> Starter:
    """The quickest starter that works here: `fork` on Linux, `spawn` elsewhere, or the one asked for."""
    method = method or ("fork" if HAS_FORK else "spawn")
    kind = {"fork": ForkStarter, "spawn": SpawnStarter}[method]
    return kind(command_prefix, environment)


_open_runtimes: weakref.WeakSet[NodeRuntime] = weakref.WeakSet()
_shared: list[NodeRuntime] = []


def shared_runtime() -> NodeRuntime:
    """The runtime of simulations that were not given one; it lasts as long as this process."""
    if not _shared:
        _shared.append(NodeRuntime())
    return _shared[0]


@atexit.register
def _close_runtimes() -> None:
    for runtime in list(_open_runtimes):
        runtime.close()
