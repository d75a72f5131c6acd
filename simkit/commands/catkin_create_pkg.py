"""`catkin_create_pkg`: the folder of a new ROS package.

Source: catkin_pkg's `catkin_create_pkg` (names, the two files, what it prints); the folders for
scripts, launch files and robots are ours, and its `include` and `src` for C++ are left out.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import escape

from simkit import msgs
from simkit.commands.command import Answer, parsed
from simkit.errors import near_names
from simkit.nodes import builtin_nodes
from simkit.packages import PackageError

FOLDERS = ("launch", "scripts", "urdf")
"""Folders of a new package, empty."""
_NAME = re.compile(r"[a-z][a-z0-9_]*")
_LIBRARIES = ("catkin", "geometry_msgs", "roscpp", "rospy", "std_msgs", "tf2", "tf2_geometry_msgs")


@dataclass(frozen=True, slots=True, kw_only=True)
class NewPackage:
    """A package that was made."""

    name: str
    "Its name."
    folder: Path
    "Where it is."
    created: tuple[str, ...]
    "What is in it: `file hello_ros/package.xml`, `folder hello_ros/scripts`."
    notes: tuple[str, ...]
    "What looks odd, one sentence each."

    def __str__(self) -> str:
        lines = [f"Created {what}" for what in self.created]
        lines.append(
            f"Successfully created files in {self.folder}. Please adjust the values in package.xml."
        )
        return "\n".join([*lines, *(f"Note: {note}" for note in self.notes)])


def create_package(
    name: str,
    dependencies: Sequence[str] = (),
    *,
    folder: str | Path | None = None,
    description: str = "",
) -> NewPackage:
    """Make the folder of a package, with `package.xml`, `CMakeLists.txt` and empty folders.

    Args:
        name: Its name: small letters, digits and underscores, a letter first.
        dependencies: Packages it uses, e.g. `rospy`, `tf`.
        folder: Where the new folder is made; the working folder if None.
        description: What it is for.

    Raises:
        PackageError: The name is invalid or taken, the name of a dependency is invalid, or the folder exists.
    """
    _require_name(name, "a package")
    for dependency in dependencies:
        _require_name(dependency, "a dependency")
    if name in _known_packages():
        raise PackageError(
            f"{name} is a package of ROS, and yours would hide it: take another name, my_{name}"
        )
    place = Path.cwd() if folder is None else Path(folder)
    _require_free(place, name)
    needed = list(dict.fromkeys(dependencies))
    files = {
        "CMakeLists.txt": cmake_text(name, needed),
        "package.xml": manifest_text(name, needed, description or f"The {name} package"),
    }
    for inner in FOLDERS:
        (place / name / inner).mkdir(parents=True)
    for file, text in files.items():
        (place / name / file).write_text(text, encoding="utf-8", newline="\n")
    return NewPackage(
        name=name,
        folder=place / name,
        created=(
            *(f"file {name}/{file}" for file in files),
            *(f"folder {name}/{inner}" for inner in FOLDERS),
        ),
        notes=tuple(filter(None, map(_doubt, needed))),
    )


def manifest_text(name: str, dependencies: Sequence[str], description: str) -> str:
    """Text of a `package.xml`."""
    depends = "".join(f"  <depend>{dependency}</depend>\n" for dependency in dependencies)
    return (
        '<?xml version="1.0"?>\n'
        '<package format="2">\n'
        f"  <name>{name}</name>\n"
        "  <version>0.0.0</version>\n"
        f"  <description>{escape(description)}</description>\n"
        '  <maintainer email="you@todo.todo">you</maintainer>\n'
        "  <license>TODO</license>\n"
        "\n"
        "  <buildtool_depend>catkin</buildtool_depend>\n"
        f"{depends}"
        "</package>\n"
    )


def cmake_text(name: str, dependencies: Sequence[str]) -> str:
    """Text of a `CMakeLists.txt`, which catkin needs on a robot and nothing here reads."""
    listed = "".join(f"\n  {dependency}" for dependency in dependencies)
    components = f" COMPONENTS{listed}\n" if listed else ""
    return (
        "cmake_minimum_required(VERSION 3.0.2)\n"
        f"project({name})\n"
        "\n"
        f"find_package(catkin REQUIRED{components})\n"
        "\n"
        "catkin_package()\n"
    )


def _require_name(name: str, what: str) -> None:
    if _NAME.fullmatch(name):
        return
    better = re.sub(r"[^a-z0-9_]+", "_", name.lower()).strip("_").lstrip("0123456789_")
    instead = f"; how about {better}?" if better else ""
    raise PackageError(
        f"{name!r} is not a valid name for {what}: small letters, digits and underscores, "
        f"a letter first{instead}"
    )


def _require_free(place: Path, name: str) -> None:
    folder = place / name
    if not folder.exists():
        return
    if (folder / "package.xml").is_file():
        raise PackageError(
            f"the package {name} is there already: put your scripts into {name}/scripts, "
            "or take another name"
        )
    raise PackageError(
        f"{name} is there already, but is no package: move it away, or take another name"
    )


def _doubt(dependency: str) -> str:
    """A sentence about a dependency that may be misspelt; empty for one that is known."""
    known = _known_packages()
    if dependency in known:
        return ""
    near = near_names(dependency, known, limit=1)
    meant = f"; did you mean {near[0]}?" if near else ""
    return f"{dependency} is no package that simkit knows{meant}"


def _known_packages() -> set[str]:
    builtin = {package for package, _ in builtin_nodes()}
    return {*builtin, *msgs.packages(), *_LIBRARIES}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Name and dependencies, as the original takes them."""
    parser.add_argument("name", metavar="NAME", help="of the package, e.g. hello_ros")
    parser.add_argument("dependencies", metavar="DEPENDENCY", nargs="*", help="e.g. rospy tf")


def _answer(arguments: argparse.Namespace) -> Answer:
    """Make the package in the working folder, and say what was made."""
    yield f"{create_package(arguments.name, arguments.dependencies)}\n"
    return 0


run = parsed("catkin_create_pkg", add_arguments, _answer)
