"""`roscd`, `rosls`, `rosed`: folders and files of packages, by the package's name.

Source: rosbash of ROS Noetic. A program cannot change the folder of the shell that starts it: `simkit roscd` prints the
folder, and the shell's function of that name, which `simkit env` defines, goes there.
"""

from __future__ import annotations

import argparse
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from simkit.commands.command import Answer, ErrorText, parsed
from simkit.commands.errors import ToolError
from simkit.commands.rospack import package_folder
from simkit.commands.shells import WORKSPACE
from simkit.errors import UnknownNameError

_EDITORS = ("vim", "nano", "vi", "notepad")


def add_place(parser: argparse.ArgumentParser) -> None:
    """A package, and perhaps a folder in it."""
    parser.add_argument(
        "place", metavar="PACKAGE[/FOLDER]", nargs="?", help="the workspace if it is left out"
    )


def add_file(parser: argparse.ArgumentParser) -> None:
    """A package and a file in it."""
    parser.add_argument("package", metavar="PACKAGE")
    parser.add_argument("file", metavar="FILE", help="its name; any folder of the package has it")


def folder_of(place: str | None) -> Path:
    """The folder that `PACKAGE/FOLDER` means; the workspace of `simkit env` if None.

    Raises:
        UnknownNameError: No such package, or no such folder in it.
    """
    if not place:
        return Path(os.environ.get(WORKSPACE) or Path.cwd())
    package, _, rest = place.partition("/")
    folder = package_folder(package)
    wanted = folder / rest
    if not wanted.is_dir():
        below = [
            str(path.relative_to(folder).as_posix())
            for path in folder.rglob("*")
            if path.is_dir() and not path.name.startswith((".", "__"))
        ]
        raise UnknownNameError(f"folder in package {package!r}", rest, below)
    return wanted


def _roscd(arguments: argparse.Namespace) -> Answer:
    yield f"{folder_of(arguments.place)}\n"
    if sys.stdout.isatty():
        yield ErrorText(
            'This shell stays where it is: roscd changes its folder after eval "$(simkit env)".\n'
        )
    return 0


def _rosls(arguments: argparse.Namespace) -> Answer:
    folder = folder_of(arguments.place)
    names = sorted(path.name for path in folder.iterdir() if not path.name.startswith("."))
    yield "".join(f"{name}\n" for name in names)
    return 0


def _rosed(arguments: argparse.Namespace) -> Answer:
    folder = package_folder(arguments.package)
    files = [
        path
        for path in sorted(folder.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts
    ]
    found = [path for path in files if path.name == arguments.file]
    if not found:
        names = [path.name for path in files]
        raise UnknownNameError(f"file in package {arguments.package!r}", arguments.file, names)
    if len(found) > 1:
        listed = ", ".join(path.relative_to(folder).as_posix() for path in found)
        raise ToolError(f"package {arguments.package} has several files of that name: {listed}")
    yield ""
    return subprocess.call([*_editor(), str(found[0])])


def _editor() -> list[str]:
    chosen = os.environ.get("EDITOR", "")
    found = next(filter(shutil.which, _EDITORS), None)
    if not chosen and found is None:
        raise ToolError("no editor is known: export EDITOR=nano names yours")
    return shlex.split(chosen) if chosen else [str(found)]


run_roscd = parsed("roscd", add_place, _roscd)
run_rosls = parsed("rosls", add_place, _rosls)
run_rosed = parsed("rosed", add_file, _rosed)
