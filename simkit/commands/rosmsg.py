"""`simkit rosmsg` and `simkit rossrv`: what messages and services look like; no simulation has to run for it.

Source: rosmsg and rossrv of ROS Noetic: commands, options, shape of the output.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass

from simkit import msgs
from simkit.commands.command import Answer, parsed
from simkit.errors import SimkitError, UnknownNameError
from simkit.msgs.catalog import message_definition_text, service_definition_texts
from simkit.msgs.strify import message_text, service_text


@dataclass(frozen=True, kw_only=True)
class _Kind:
    """Messages or services: what differs between the two commands."""

    word: str
    suffix: str
    types: Callable[[], list[str]]
    text: Callable[[str], str]
    raw: Callable[[str], str]
    md5: Callable[[str], str]


_KINDS = {
    "rosmsg": _Kind(
        word="message",
        suffix=".msg",
        types=msgs.message_types,
        text=message_text,
        raw=message_definition_text,
        md5=lambda name: str(msgs.message_class(name)._md5sum),
    ),
    "rossrv": _Kind(
        word="service",
        suffix=".srv",
        types=msgs.service_types,
        text=service_text,
        raw=lambda name: "---\n".join(service_definition_texts(name)),
        md5=lambda name: str(msgs.service_class(name)._md5sum),
    ),
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Sub-commands show, list, md5, package, packages."""
    kind = _KINDS[parser.get_default("command")]
    does = parser.add_subparsers(dest="does", metavar="COMMAND", required=True, prog=parser.prog)
    show = does.add_parser("show", aliases=["info"], help=f"show the fields of a {kind.word}")
    show.add_argument("-r", "--raw", action="store_true", help="the text as written, with comments")
    does.add_parser("list", help=f"list all {kind.word}s")
    md5 = does.add_parser("md5", help=f"show the MD5 sum of a {kind.word}")
    for of_a_type in (show, md5):
        of_a_type.add_argument(
            "type", metavar="TYPE", help="package/Type, or Type for that of any package"
        )
    package = does.add_parser("package", help=f"list the {kind.word}s of a package")
    package.add_argument("package", metavar="PACKAGE")
    packages = does.add_parser("packages", help=f"list the packages that have {kind.word}s")
    for of_many in (package, packages):
        of_many.add_argument("-s", dest="one_line", action="store_true", help="all on one line")


def _answer(arguments: argparse.Namespace) -> Answer:
    kind = _KINDS[arguments.command]
    if arguments.does in ("packages", "package"):
        names = (
            _packages(kind) if arguments.does == "packages" else _types_of(kind, arguments.package)
        )
        yield (" " if arguments.one_line else "\n").join(names) + "\n"
    elif arguments.does == "list":
        yield "\n".join(kind.types()) + "\n"
    elif arguments.does == "md5":
        for name in _meant(kind, arguments.type):
            head = "" if "/" in arguments.type else f"[{name}]: "
            yield f"{head}{kind.md5(name)}\n"
    else:
        for name in _meant(kind, arguments.type):
            head = "" if "/" in arguments.type else f"[{name}]:\n"
            yield head + (kind.raw if arguments.raw else kind.text)(name) + "\n"
    return 0


def _packages(kind: _Kind) -> list[str]:
    return sorted({name.split("/")[0] for name in kind.types()})


def _types_of(kind: _Kind, package: str) -> list[str]:
    if package not in _packages(kind):
        raise UnknownNameError(f"package with {kind.word}s", package, _packages(kind))
    return [name for name in kind.types() if name.startswith(f"{package}/")]


def _meant(kind: _Kind, written: str) -> list[str]:
    """Full names of the types that `written` means: one, or those of that name in any package."""
    name = written.removesuffix(kind.suffix)
    if "::" in name or "." in name:
        raise SimkitError(f"{name!r} is not how ROS writes a type: package/Type")
    types = kind.types()
    if "/" in name:
        if name not in types:
            raise UnknownNameError(f"{kind.word} type", name, types)
        return [name]
    found = [full for full in types if full.split("/")[1] == name]
    if not found:
        raise UnknownNameError(f"{kind.word} type", name, {full.split("/")[1] for full in types})
    return found


run = parsed("rosmsg", add_arguments, _answer)
run_rossrv = parsed("rossrv", add_arguments, _answer)
