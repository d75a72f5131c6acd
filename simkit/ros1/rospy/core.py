"""The node itself: its name, its start and its end."""

from __future__ import annotations

import atexit
import sys
from collections.abc import Callable, Sequence
from typing import Any

from simkit.graph.process import client
from simkit.graph.process.failure import print_traceback
from simkit.graph.process.node_client import Refused
from simkit.graph.process.protocol import Op

from .exceptions import ROSException, ROSInitException, ROSInterruptException


class _State:
    """What this process knows of its node."""

    def __init__(self) -> None:
        self.name: str | None = None
        self.init_arguments: tuple[Any, ...] | None = None
        self.waiting: list[Callable[[], None]] = []
        self.hooks: list[Callable[[], object]] = []
        self.ending = False


_state = _State()


def init_node(
    name: str,
    argv: Sequence[str] | None = None,
    anonymous: bool = False,
    log_level: int | None = None,
    disable_rostime: bool = False,
    disable_rosout: bool = False,
    disable_signals: bool = False,
    xmlrpc_port: int = 0,
    tcpros_port: int = 0,
) -> None:
    """Register this process as a node.

    Args:
        name: Node name, without a namespace.
        argv: Command line to read remappings from; that of the process if None.
        anonymous: Append a number that makes the name unique.
        log_level: Level from which on log calls are published.
        disable_rostime: Taken for rospy's sake.
        disable_rosout: Taken for rospy's sake.
        disable_signals: Taken for rospy's sake.
        xmlrpc_port: Taken for rospy's sake.
        tcpros_port: Taken for rospy's sake.

    Raises:
        ValueError: The name is empty or has a namespace.
        ROSException: Called before with other arguments.
    """
    if not name:
        raise ValueError("name must not be empty")
    if "/" in name:
        raise ValueError(f"namespaces are not allowed in node names: {name!r}")
    arguments = (name, argv, anonymous, log_level, disable_rostime, disable_signals)
    if _state.init_arguments is not None:
        if _state.init_arguments != arguments:
            raise ROSException(
                "rospy.init_node() has already been called with different arguments: "
                f"{_state.init_arguments}"
            )
        return
    try:
        reply = client.current().ask(Op.INIT_NODE, name=name, anonymous=bool(anonymous))
    except Refused as error:
        raise ROSException(str(error)) from None
    _state.name = reply["name"]
    _state.init_arguments = arguments
    if log_level is not None:
        from . import logs

        logs.set_level(log_level)
    client.current().on_shutdown = signal_shutdown
    atexit.register(lambda: signal_shutdown("atexit"))
    waiting, _state.waiting = _state.waiting, []
    for register in waiting:
        register()


def when_initialized(register: Callable[[], None]) -> None:
    """Do it now, or as soon as `init_node` has been called."""
    if _state.name is None:
        _state.waiting.append(register)
    else:
        register()


def require_init(what: str) -> None:
    """Refuse what needs a node first.

    Raises:
        ROSInitException: `init_node` has not been called.
    """
    if _state.name is None:
        raise ROSInitException(f"{what}: rospy.init_node() must be called first")


def is_initialized() -> bool:
    """Whether `init_node` has been called."""
    return _state.name is not None


def is_shutdown() -> bool:
    """Whether the node is to end; a loop that asks this lets virtual time pass."""
    line = client.current()
    if line.shutdown_reason is None:
        line.let_time_pass()
    return line.shutdown_reason is not None


def is_shutdown_requested() -> bool:
    """Whether a shutdown has been requested; hooks may still be running."""
    return _state.ending or client.current().shutdown_reason is not None


def signal_shutdown(reason: object) -> None:
    """End the node: shutdown hooks run, and can still sleep and publish; then every wait is interrupted."""
    if _state.ending:
        return
    _state.ending = True
    for hook in _state.hooks:
        _run_hook(hook)
    client.current().request_shutdown(str(reason))


def on_shutdown(hook: Callable[[], object]) -> None:
    """Call `hook` when the node ends; at once if it has ended.

    Raises:
        TypeError: It cannot be called.
    """
    if not callable(hook):
        raise TypeError(
            f"shutdown hook [{hook}] must be a function or callable object: {type(hook)}"
        )
    if client.current().shutdown_reason is not None:
        hook()
    else:
        _state.hooks.append(hook)


def spin() -> None:
    """Block until the node is shut down; callbacks run meanwhile.

    Raises:
        ROSInitException: `init_node` has not been called.
    """
    if _state.name is None:
        raise ROSInitException("client code must call rospy.init_node() first")
    line = client.current()
    while line.shutdown_reason is None:
        line.scheduler.block()


def interrupted(text: str = "rospy shutdown") -> ROSInterruptException:
    """What a wait raises that a shutdown ends."""
    return ROSInterruptException(text)


def get_name() -> str:
    """Resolved name of this node; `/unnamed` before `init_node`."""
    return _state.name or "/unnamed"


def get_caller_id() -> str:
    """Resolved name of this node."""
    return get_name()


def get_namespace() -> str:
    """Namespace of this node, ending in `/`."""
    return get_name().rpartition("/")[0] + "/"


def get_node_uri() -> str | None:
    """None: nodes of this kit have no address."""
    return None


def resolve_name(name: str, caller_id: str | None = None) -> str:
    """Global name that `name` stands for in this node."""
    if caller_id is not None and caller_id != get_name():
        return (
            name if name.startswith("/") else caller_id.rpartition("/")[0] + "/" + name.lstrip("~")
        )
    return str(client.current().ask(Op.QUERY, what="resolve", name=name)["value"])


def remap_name(name: str) -> str:
    """`name` with this node's remappings applied."""
    return resolve_name(name)


def get_published_topics(namespace: str = "/") -> list[list[str]]:
    """Pairs of topic and type of what is published under a namespace."""
    topics = client.current().ask(Op.QUERY, what="topics")["value"]
    prefix = resolve_name(namespace).rstrip("/") + "/"
    return [[name, kind] for name, kind in topics if name.startswith(prefix)]


def myargv(argv: Sequence[str] | None = None) -> list[str]:
    """A command line without remappings."""
    return [argument for argument in (sys.argv if argv is None else argv) if ":=" not in argument]


def _run_hook(hook: Callable[[], object]) -> None:
    try:
        hook()
    except BaseException as error:  # a hook's fault must not keep the others from running
        client.current().report_fault(error)
        print_traceback(error, sys.stderr)
