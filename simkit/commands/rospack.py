"""`simkit rospack`: which packages there are, and where.

Source: rospack of ROS Noetic: `list` prints name and folder, `find` the folder.
"""

from __future__ import annotations

import argparse

from simkit import msgs
from simkit.commands.command import Answer, parsed
from simkit.errors import SimkitError, UnknownNameError
from simkit.nodes import builtin_nodes
from simkit.packages import PATH_VARIABLE, PackagePath


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Sub-commands list and find."""
    parser.epilog = f"Packages are looked for below this folder and in {PATH_VARIABLE}."
    does = parser.add_subparsers(dest="does", metavar="COMMAND", required=True, prog=parser.prog)
    does.add_parser("list", help="list all packages and their folders")
    find = does.add_parser("find", help="show the folder of a package")
    find.add_argument("package", metavar="PACKAGE")


def _answer(arguments: argparse.Namespace) -> Answer:
    if arguments.does == "find":
        yield f"{_find(arguments.package)}\n"
        return 0
    places = {name: str(found.folder) for name, found in PackagePath().packages().items()}
    for package in _builtin_packages():
        places.setdefault(package, "(comes with simkit)")
    for name, place in sorted(places.items()):
        yield f"{name} {place}\n"
    return 0


def _builtin_packages() -> list[str]:
    return sorted({package for package, _ in builtin_nodes()})


def _find(package: str) -> str:
    try:
        return str(PackagePath().find(package).folder)
    except UnknownNameError as error:
        if package in _builtin_packages():
            raise SimkitError(f"{package} comes with simkit: it has no folder") from None
        if package in msgs.packages():
            raise SimkitError(
                f"of {package} only the messages are here: simkit rosmsg package {package}"
            ) from None
        known = {*error.known, *_builtin_packages()}
        raise UnknownNameError("package", package, known) from None


run = parsed("rospack", add_arguments, _answer)
