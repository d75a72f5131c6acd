"""`simkit rospack`: which packages there are, and where; `simkit rosversion`.

Source: rospack of ROS Noetic: `list` prints name and folder, `find` the folder.
rosversion prints `<unversioned>` for a package without a version.
"""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from simkit import msgs
from simkit.commands.command import Answer, parsed
from simkit.commands.errors import UsageError
from simkit.errors import SimkitError, UnknownNameError
from simkit.nodes import builtin_nodes
from simkit.packages import PATH_VARIABLES, PackagePath

ROS_VERSION = "1.17.4"
"""Version of rospy in ROS Noetic's last release."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Sub-commands list and find."""
    parser.epilog = (
        f"Packages are looked for below this folder and in {' and '.join(PATH_VARIABLES)}."
    )
    does = parser.add_subparsers(dest="does", metavar="COMMAND", required=True, prog=parser.prog)
    does.add_parser("list", help="list all packages and their folders")
    find = does.add_parser("find", help="show the folder of a package")
    find.add_argument("package", metavar="PACKAGE")


def _answer(arguments: argparse.Namespace) -> Answer:
    if arguments.does == "find":
        yield f"{package_folder(arguments.package)}\n"
        return 0
    places = {name: str(found.folder) for name, found in PackagePath().packages().items()}
    for package in _builtin_packages():
        places.setdefault(package, "(comes with simkit)")
    for name, place in sorted(places.items()):
        yield f"{name} {place}\n"
    return 0


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


run = parsed("rospack", add_arguments, _answer)
run_rosversion = parsed("rosversion", add_package, _version)
