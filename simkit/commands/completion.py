"""`simkit complete`: what Tab offers for the last word of a command line.

Packages, executables and launch files are looked up on disk. The running simulation is asked for nodes, topics, services and
parameters.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterable, Mapping, Sequence

from simkit.commands.command import Answer, parsed
from simkit.commands.rosrun import executables
from simkit.commands.table import COMMANDS
from simkit.commands.words import SHORTHANDS
from simkit.errors import SimkitError
from simkit.live.client import run_in_session
from simkit.live.session import find_session
from simkit.nodes import builtin_nodes
from simkit.packages import PackagePath

Candidates = Callable[[Sequence[str]], Iterable[str]]
"""What may follow the words after the command's name."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The words typed so far; the last one is to be completed, and may be empty."""
    parser.usage = "simkit complete -- WORDS"
    parser.add_argument("words", metavar="WORDS", nargs="+")


def _answer(arguments: argparse.Namespace) -> Answer:
    yield "".join(f"{text}\n" for text in completions(arguments.words))
    return 0


def completions(words: Sequence[str]) -> list[str]:
    """What the last word may become, sorted; nothing where anything may stand.

    Args:
        words: The command line, the command first, with or without `simkit`.
    """
    *before, begun = words
    if before and before[0] == "simkit":
        before = before[1:]
        if not before:
            return _begun(begun, [*COMMANDS, *SHORTHANDS])
    if not before or before[0] not in _FOLLOWING:
        return []
    try:
        found = _FOLLOWING[before[0]](before[1:])
        return _begun(begun, found)
    except (SimkitError, OSError):  # Tab offers nothing then
        return []


def _begun(begun: str, names: Iterable[str]) -> list[str]:
    return sorted({name for name in names if name.startswith(begun)})


def _packages(before: Sequence[str]) -> Iterable[str]:
    if before:
        return []
    return [*PackagePath().packages(), *(package for package, _ in builtin_nodes())]


def _executables(before: Sequence[str]) -> Iterable[str]:
    if not before:
        return _packages(before)
    return executables(PackagePath(), before[0]) if len(before) == 1 else []


def _launch_files(before: Sequence[str]) -> Iterable[str]:
    if not before:
        return PackagePath().packages()
    if len(before) > 1:
        return []
    return [path.name for path in PackagePath().find(before[0]).folder.rglob("*.launch")]


def _live(*command: str) -> Candidates:
    """The lines that a command prints in the running simulation."""

    def ask(_before: Sequence[str]) -> Iterable[str]:
        session = find_session()
        printed: list[str] = []
        if session is not None:
            run_in_session(session, command, printed.append)
        return "".join(printed).split()

    return ask


def _message_types(_before: Sequence[str]) -> Iterable[str]:
    from simkit import msgs

    return msgs.message_types()


def _service_types(_before: Sequence[str]) -> Iterable[str]:
    from simkit import msgs

    return msgs.service_types()


def _type_of_topic(before: Sequence[str]) -> Iterable[str]:
    return _live("rostopic", "type", before[0])(before)


def _nothing(_before: Sequence[str]) -> Iterable[str]:
    return []


def _each(*following: Candidates) -> Candidates:
    """A candidate list for each place; the last place may be followed by anything."""

    def look(before: Sequence[str]) -> Iterable[str]:
        plain = [word for word in before if not word.startswith("-")]
        return following[len(plain)](plain) if len(plain) < len(following) else []

    return look


def _commands(tool: str, following: Mapping[str, Candidates]) -> Candidates:
    """A tool's commands, and what follows each of them."""

    def look(before: Sequence[str]) -> Iterable[str]:
        if before:
            return following.get(before[0], _nothing)(before[1:])
        module = COMMANDS[tool].load_module()
        return getattr(module, "COMMANDS", following)

    return look


_TOPICS, _NODES = _each(_live("rostopic", "list")), _each(_live("rosnode", "list"))
_SERVICES, _PARAMETERS = _each(_live("rosservice", "list")), _each(_live("rosparam", "list"))
_TYPES = {"rosmsg": _each(_message_types), "rossrv": _each(_service_types)}
_FOLLOWING: Mapping[str, Candidates] = {
    "rosrun": _executables,
    "roslaunch": _launch_files,
    **dict.fromkeys(("roscd", "rosls", "rosed", "rosversion"), _packages),
    "rospack": _commands(
        "rospack",
        {
            "list": _nothing,
            **dict.fromkeys(("find", "depends", "depends1", "depends-on"), _packages),
        },
    ),
    **{
        tool: _commands(tool, {**dict.fromkeys(("show", "info", "md5"), types), "list": _nothing})
        for tool, types in _TYPES.items()
    },
    "rostopic": _commands(
        "rostopic",
        {
            **dict.fromkeys(("bw", "delay", "echo", "hz", "info", "type"), _TOPICS),
            "find": _TYPES["rosmsg"],
            "pub": _each(_live("rostopic", "list"), _type_of_topic),
        },
    ),
    "rosnode": _commands("rosnode", dict.fromkeys(("info", "kill", "ping"), _NODES)),
    "rosservice": _commands(
        "rosservice",
        {
            **dict.fromkeys(("args", "call", "info", "type"), _SERVICES),
            "find": _TYPES["rossrv"],
        },
    ),
    "rosparam": _commands(
        "rosparam", dict.fromkeys(("delete", "dump", "get", "load", "set"), _PARAMETERS)
    ),
}

run = parsed("complete", add_arguments, _answer)
