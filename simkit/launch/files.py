"""The files that a launch file names: packages, other launch files, robots, YAML."""

from __future__ import annotations

import os
from pathlib import Path

from simkit.errors import UnknownNameError
from simkit.launch.budget import MAX_FILE_BYTES, Budget
from simkit.launch.file_search import KNOWN, how_to_name, torn_find
from simkit.launch.refusal import Kind, LaunchRefused, Lesson, ours
from simkit.launch.rules import FILE, SUBSTITUTION
from simkit.nodes import builtin_nodes
from simkit.packages import Package, PackageError, PackagePath

XACRO = "xacro"
"""A package of which only its program counts, and only as the command of a parameter."""
OF_ROS = frozenset({"controller_manager", "gazebo_plugins", "gazebo_ros_control", "rviz"})
"""Packages of ROS that robots' launch files name; those with nodes in the kit are known besides."""
_IN_PACKAGES = "Keep what belongs to a package in its folder, and name it by $(find PACKAGE)/...."


class Files:
    """Finds and reads what launch files name, within bounds.

    Args:
        packages: Where packages are, and whether all else is out of reach.
        budget: Counts what is read.
    """

    def __init__(self, packages: PackagePath, budget: Budget) -> None:
        self.path = packages
        """Where packages are."""
        self._packages: dict[str, Package] | None = None
        self._budget = budget

    @property
    def packages(self) -> dict[str, Package]:
        """The packages by name, as they were when they were first asked for."""
        if self._packages is None:
            self._packages = self.path.packages()
        return self._packages

    @property
    def confined(self) -> bool:
        """Whether all that is no package is out of reach."""
        return self.path.confined

    def find_package(self, name: str) -> Path:
        """Folder of a package.

        Raises:
            LaunchRefused: There is none, or it comes with the kit and has no folder.
        """
        if name in self.packages:
            return self.packages[name].folder
        if name == XACRO or (name.isidentifier() and (KNOWN / name).is_dir()):
            return KNOWN / name
        places = "".join(f"\nROS path [{n}]={path}" for n, path in enumerate(self.path.folders))
        raise LaunchRefused(Kind.NOT_FOUND, f"{name}{places}", self._no_package(name))

    def read(self, name: str, limit: int = MAX_FILE_BYTES) -> bytes:
        """The bytes of a file.

        Args:
            name: Its path; a relative one is meant from the working folder, as in roslaunch.
            limit: Size that it may have.

        Raises:
            LaunchRefused: It is not there, too large, or out of reach.
        """
        if not self.may_read(name):
            raise ours(
                FILE,
                f"the file {name!r} lies outside of the packages",
                torn_find(name) or _IN_PACKAGES,
            )
        try:
            size = Path(name).stat().st_size
            if size > limit:
                raise ours(FILE, f"{name} has {size} bytes", f"At most {limit} are read.")
            data = Path(name).read_bytes()
        except (OSError, ValueError) as error:
            raise self._unreadable(name, error) from None
        self._budget.total(len(data))
        return data

    def read_text(self, name: str) -> str:
        """The text of a file in UTF-8, its lines ended as on Linux.

        Raises:
            LaunchRefused: As `read`, or it is not UTF-8.
        """
        try:
            text = self.read(name).decode()
        except UnicodeDecodeError as error:
            lesson = Lesson(
                rule=FILE,
                what=f"{self.shown(name)} is not a text in UTF-8",
                remedy="Save it with the encoding UTF-8.",
            )
            raise LaunchRefused(Kind.VALUE, str(error), lesson) from None
        return text.replace("\r\n", "\n").replace("\r", "\n")

    def may_read(self, name: str | Path) -> bool:
        """Whether a file is within reach."""
        if self.path.may_read(name):
            return True
        try:
            return Path(name).resolve().is_relative_to(KNOWN.resolve())
        except (OSError, RuntimeError, ValueError):
            return False

    def shown(self, name: str | Path) -> str:
        """A path for people: from the package's name on if it lies in one."""
        path = Path(os.path.normpath(name))
        for package in self.packages.values():
            if path.is_relative_to(package.folder):
                return path.relative_to(package.folder.parent).as_posix()
        if path.is_relative_to(KNOWN):
            return path.relative_to(KNOWN).as_posix()
        return str(name)

    def _no_package(self, name: str) -> Lesson:
        try:
            self.path.find(name)
            what = f"the package {name!r} cannot be found"
        except UnknownNameError as error:
            what = str(error)
        except PackageError as error:
            return Lesson(rule=SUBSTITUTION, what=str(error), remedy="Make it a package.")
        remedy = "Write the name of a package that is here, or make it: simkit catkin_create_pkg."
        if name in OF_ROS:
            what = f"{name} is a package of ROS, of which simkit has no files"
            remedy = "Leave this tag out to use the rest."
        if name in {package for package, _ in builtin_nodes()}:
            what = f"{name} comes with simkit as built-in nodes: it has no folder with files"
            remedy = f"Start its nodes with <node pkg={name!r} ...>; its files cannot be named."
        return Lesson(rule=SUBSTITUTION, what=what, remedy=remedy)

    def missing(self, name: str) -> Lesson:
        """What to say of a file that is not there."""
        remedy = how_to_name(name, self.packages.values(), may_read=self.may_read)
        return Lesson(rule=FILE, what=f"there is no file {self.shown(name)!r}", remedy=remedy)

    def _unreadable(self, name: str, error: OSError | ValueError) -> LaunchRefused:
        lesson = Lesson(
            rule=FILE,
            what=f"{self.shown(name)!r} cannot be read: {getattr(error, 'strerror', None) or error}",
            remedy="Write the path of a file that you may read.",
        )
        if isinstance(error, FileNotFoundError):
            lesson = self.missing(name)
        return LaunchRefused(
            Kind.OTHER, _as_written(error, name), lesson, name=type(error).__name__
        )


def _as_written(error: OSError | ValueError, name: str) -> str:
    """Python's words for a file, with its name as it was written: a Path would spell it anew."""
    if not isinstance(error, OSError) or error.errno is None:
        return str(error)
    return f"[Errno {error.errno}] {error.strerror}: {name!r}"
