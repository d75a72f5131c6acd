"""`simkit rospack`: which packages there are, and where; `simkit rosversion`.

Source: rospack of ROS Noetic: `list` prints name and folder, `find` the folder, `depends` the deepest packages first.
rosversion prints `<unversioned>` for a package without a version.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Mapping
from pathlib import Path

from simkit import msgs
from simkit.commands.command import Answer, parsed
from simkit.commands.errors import UsageError
from simkit.errors import SimkitError, UnknownNameError
from simkit.nodes import builtin_nodes
from simkit.packages import PATH_VARIABLES, PackagePath

ROS_VERSION = "1.16.0"
"""Version of rospy and roscpp in a release of ROS Noetic."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Sub-commands list, find, and those on what depends on what."""
    parser.epilog = (
        f"Packages are looked for below this folder and in {' and '.join(PATH_VARIABLES)}."
    )
    does = parser.add_subparsers(dest="does", metavar="COMMAND", required=True, prog=parser.prog)
    does.add_parser("list", help="list all packages and their folders")
    for name, (help_text, _) in _OF_A_PACKAGE.items():
        of_a_package = does.add_parser(name, help=help_text)
        of_a_package.add_argument("package", metavar="PACKAGE")


def _answer(arguments: argparse.Namespace) -> Answer:
    if arguments.does in _OF_A_PACKAGE:
        _, answer = _OF_A_PACKAGE[arguments.does]
        yield "".join(f"{line}\n" for line in answer(arguments.package))
        return 0
    places = {name: str(found.folder) for name, found in PackagePath().packages().items()}
    for package in _builtin_packages():
        places.setdefault(package, "(comes with simkit)")
    for name, place in sorted(places.items()):
        yield f"{name} {place}\n"
    return 0


def _direct(package: str) -> list[str]:
    """The packages that a package depends on, as its package.xml lists them."""
    manifest = package_folder(package) / "package.xml"
    return sorted(set(_DEPENDS.findall(_COMMENT.sub("", manifest.read_text(errors="replace")))))


def _all(package: str) -> list[str]:
    """The packages that a package depends on, and those that they depend on, the deepest first."""
    known = PackagePath().packages()
    ordered: list[str] = []

    def visit(name: str, above: tuple[str, ...]) -> None:
        for needed in _direct(name):
            if needed not in ordered and needed not in above:
                if needed in known:
                    visit(needed, (*above, needed))
                ordered.append(needed)

    visit(package, (package,))
    return ordered


def _users(package: str) -> list[str]:
    """The packages that depend on a package, directly or not."""
    return sorted(name for name in PackagePath().packages() if package in _all(name))


def _builtin_packages() -> list[str]:
    return sorted({package for package, _ in builtin_nodes()})


def package_folder(package: str) -> Path:
    """The folder of a package.

    Raises:
        UnknownNameError: There is no such package; names near ones.
        SimkitError: It comes with simkit, and has no folder.
    """
    try:
        return PackagePath().find(package).folder
    except UnknownNameError as error:
        if package in _builtin_packages():
            raise SimkitError(f"{package} comes with simkit: it has no folder") from None
        if package in msgs.packages():
            raise SimkitError(
                f"of {package} only the messages are here: simkit rosmsg package {package}"
            ) from None
        known = {*error.known, *_builtin_packages()}
        raise UnknownNameError("package", package, known) from None


def add_package(parser: argparse.ArgumentParser) -> None:
    """A package, or -d."""
    parser.add_argument("-d", "--distro", action="store_true", help="show the name of this ROS")
    parser.add_argument("package", metavar="PACKAGE", nargs="?")


def _version(arguments: argparse.Namespace) -> Answer:
    if arguments.distro or arguments.package in ("ros", "roscpp", "rospy"):
        yield "noetic\n" if arguments.distro else f"{ROS_VERSION}\n"
        return 0
    if arguments.package is None:
        raise UsageError("simkit rosversion: which package? rosversion PACKAGE, or rosversion -d")
    manifest = package_folder(arguments.package) / "package.xml"
    found = re.search(
        r"<version[^>]*>\s*([^<\s]+)\s*</version>", manifest.read_text(errors="replace")
    )
    yield f"{found[1] if found else '<unversioned>'}\n"
    return 0


_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_DEPENDS = re.compile(r"<(?:build_|build_export_|exec_|run_)?depend\b[^>]*>\s*([^<\s]+)\s*<")
_OF_A_PACKAGE: Mapping[str, tuple[str, Callable[[str], list[str]]]] = {
    "find": ("show the folder of a package", lambda package: [str(package_folder(package))]),
    "depends": ("list what a package depends on, directly or not", _all),
    "depends1": ("list what a package depends on directly", _direct),
    "depends-on": ("list the packages that depend on a package", _users),
}

run = parsed("rospack", add_arguments, _answer)
run_rosversion = parsed("rosversion", add_package, _version)
