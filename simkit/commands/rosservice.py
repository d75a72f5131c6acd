"""`rosservice`: which services there are, what they take, and calling one.

Source: rosservice of ROS Noetic, outputs and texts.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import yaml

from simkit.commands.command import Answer, Call, Wait, subcommands
from simkit.commands.errors import ToolError, UsageError, near_hint
from simkit.commands.graph_facts import address, is_below, resolved, service_nodes
from simkit.commands.parser import ArgumentParser
from simkit.graph import Graph
from simkit.msgs import (
    Message,
    MessageError,
    SerializationError,
    field_paths,
    fill_message,
    service_class,
)
from simkit.msgs.strify import service_text

ANSWER_SECONDS = 10.0
"""How long an answer may take [s of virtual time]."""
_CALLER = "/rosservice"


def list_services(graph: Graph, namespace: str = "/", *, nodes: bool = False) -> str:
    """What `rosservice list` prints: the names of the services, with `nodes` as `-n`."""
    within = resolved(namespace)
    return "".join(
        f"{name} {node}\n" if nodes else f"{name}\n"
        for name, node in service_nodes(graph).items()
        if is_below(name, within)
    )


def info(graph: Graph, service: str) -> str:
    """What `rosservice info` prints: node, address, type and arguments.

    Raises:
        ToolError: There is no such service.
    """
    name = resolved(service)
    if name not in graph.services:
        raise ToolError(f"ERROR: unknown service{near_hint(name, graph.services)}")
    node = graph.services[name].node_name
    return (
        f"Node: {node}\nURI: {address(node)}\n"
        f"Type: {type_of(graph, service)}Args: {args(graph, service)}"
    )


def type_of(graph: Graph, service: str) -> str:
    """What `rosservice type` prints.

    Raises:
        ToolError: There is no such service.
    """
    name = resolved(service)
    if name not in graph.services:
        raise ToolError(f"Unknown service [{name}]{near_hint(name, graph.services)}")
    return f"{graph.services[name].service_class._type}\n"


def args(graph: Graph, service: str) -> str:
    """What `rosservice args` prints: the fields of the request.

    Raises:
        ToolError: There is no such service.
    """
    return " ".join(field_paths(_class(graph, service)._request_class())) + "\n"


def node_of(graph: Graph, service: str) -> str:
    """What `rosservice node` prints: the node that offers a service.

    Raises:
        ToolError: There is no such service.
    """
    name = resolved(service)
    if name not in graph.services:
        raise ToolError(f"Unknown service: {name}{near_hint(name, graph.services)}")
    return f"{graph.services[name].node_name}\n"


def find(graph: Graph, type_name: str) -> str:
    """What `rosservice find` prints: the services of a type."""
    names = (
        name
        for name, server in sorted(graph.services.items())
        if server.service_class._type == type_name
    )
    return "\n".join(names) + "\n"


def call(graph: Graph, service: str, *words: str) -> Answer:
    """Call a service, as `rosservice call` does; time passes until it answers.

    Args:
        graph: The graph.
        service: Service name.
        *words: YAML for the whole request, or for each of its fields.

    Raises:
        ToolError: No such service, the words do not fit it, or it refused.
    """
    name = resolved(service)
    kind = _class(graph, service)
    data = _sendable(kind, _request(graph, kind, words))
    answers: list[tuple[bool, bytes]] = []
    graph.call_service(name, data, _CALLER, lambda ok, body: answers.append((ok, body)))
    yield Wait(until=lambda: bool(answers), seconds=ANSWER_SECONDS)
    if not answers:
        raise ToolError(f"ERROR: service [{name}] did not answer within {ANSWER_SECONDS:g} s")
    success, body = answers[0]
    if not success:
        raise ToolError(f"ERROR: service [{name}] responded with an error: {body!r}", exit_code=2)
    response: Message = kind._response_class.from_bytes(body)
    yield f"{response}\n"


def _class(graph: Graph, service: str) -> Any:
    name = resolved(service)
    if name not in graph.services:
        raise ToolError(
            f"ERROR: Service [{name}] is not available.{near_hint(name, graph.services)}",
            exit_code=2,
        )
    return service_class(graph.services[name].service_class._type)


def _request(graph: Graph, kind: Any, words: Sequence[str]) -> Message:
    values = [_yaml(word) for word in words]
    try:
        request: Message = fill_message(kind._request_class, values, now=graph.now())
    except MessageError as error:
        given = "\n".join(f" * {value} (type {type(value).__name__})" for value in values)
        expected = " ".join(field_paths(kind._request_class()))
        raise ToolError(
            f"ERROR: Incompatible arguments to call service:\n{error}\n"
            f"Provided arguments are:\n{given}\n\nService arguments are: [{expected}]",
            exit_code=2,
        ) from error
    return request


def _sendable(kind: Any, request: Message) -> bytes:
    try:
        return request.to_bytes()
    except SerializationError as error:
        raise ToolError(
            "ERROR: Unable to send request. One of the fields has an incorrect type:\n"
            f"  {error}\n\nsrv file:\n{service_text(kind._type)}",
            exit_code=2,
        ) from error


def _yaml(word: str) -> object:
    try:
        return yaml.safe_load(word) if word else ""
    except yaml.YAMLError as error:
        raise UsageError(f"rosservice call: {word!r} is not YAML: {error}") from error


def _list_command(call: Call) -> Answer:
    parser = ArgumentParser("rosservice list")
    parser.add_argument("-n", "--nodes", action="store_true", help="the nodes too")
    parser.add_argument("namespace", nargs="?", default="/")
    found = parser.parse_args(call.words)
    yield list_services(call.graph, found.namespace, nodes=found.nodes)


def _call_command(asked: Call) -> Answer:
    parser = ArgumentParser("rosservice call")
    parser.add_argument("-v", dest="verbose", action="store_true", help="no effect here")
    parser.add_argument("--wait", action="store_true", help="until the service is offered")
    parser.add_argument("service")
    parser.add_argument("args", nargs="*", help="YAML; after -- if it begins with -")
    found = parser.parse_intermixed_args(asked.words)
    graph, name = asked.graph, resolved(found.service)
    if found.wait:
        yield Wait(until=lambda: name in graph.services, seconds=asked.bounds.seconds)
    if not found.args and _class(graph, name)._request_class.__slots__:
        parser.error(f"Please specify service arguments: {args(graph, name).strip()}")
    yield from call(graph, name, *found.args)


def _named(command: str, answer: Any) -> Any:
    def run(call: Call) -> Answer:
        parser = ArgumentParser(f"rosservice {command}")
        parser.add_argument("type" if command == "find" else "service")
        (name,) = vars(parser.parse_args(call.words)).values()
        yield answer(call.graph, name)

    return run


COMMANDS = {
    "args": _named("args", args),
    "call": _call_command,
    "find": _named("find", find),
    "info": _named("info", info),
    "list": _list_command,
    "node": _named("node", node_of),
    "type": _named("type", type_of),
}
"""The commands of rosservice by name."""
run = subcommands("rosservice", COMMANDS)
