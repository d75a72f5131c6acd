"""Node side: the client of this process, which the script's modules (`rospy`, `tf`) ask for by `current`."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

from simkit.graph.process.node_client import NodeClient

_current: NodeClient | None = None
_preloading = False


def connect(client: NodeClient) -> None:
    """Make `client` the one of this process."""
    global _current
    _current = client


@contextlib.contextmanager
def preloading() -> Iterator[None]:
    """Allow the import of rospy and tf before there is a graph: what the warm parent does."""
    global _preloading
    _preloading = True
    try:
        yield
    finally:
        _preloading = False


def require_node_process() -> None:
    """Refuse the import of a ROS module outside node processes.

    Raises:
        ImportError: This is no node process.
    """
    if not _preloading:
        current()


def current() -> NodeClient:
    """The client of this node process.

    Raises:
        ImportError: This is no node process.
    """
    if _current is None:
        raise ImportError(
            "rospy and tf work only in a node: save the script in your package and start it with "
            "sim.rosrun('package', 'script.py')"
        )
    return _current


@contextlib.contextmanager
def looking(period_ns: int, end_ns: int) -> Iterator[None]:
    """As `NodeClient.looking`, of the client of this process if there is one."""
    if _current is None:
        yield
    else:
        with _current.looking(period_ns, end_ns):
            yield


def let_time_pass() -> None:
    """Let a millisecond of virtual time pass, unless the caller has blocked since its last call."""
    if _current is not None:
        _current.let_time_pass()
