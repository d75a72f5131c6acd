"""The files that a launch file names, and how much it may ask for: evaluation always ends, and soon."""

from __future__ import annotations

import os
from collections import Counter
from pathlib import Path

from simkit.errors import UnknownNameError
from simkit.launch.errors import Kind, LaunchRefused, Lesson, ours
from simkit.launch.file_search import KNOWN, how_to_name, torn_find
from simkit.launch.rules import FILE, SUBSTITUTION, TOO_MUCH
from simkit.nodes import builtin_nodes
from simkit.packages import Package, PackageError, PackagePath

MAX_INCLUDE_DEPTH = 25
"""Launch files that include each other in a chain."""
MAX_GROUP_DEPTH = 60
"""Groups in groups."""
MAX_STRING = 100_000
"""Characters of one value after its `$(...)` were replaced."""
MAX_FILE_BYTES = 10_000_000
"""Size of a file that a parameter is read from."""
MAX_LAUNCH_BYTES = 300_000
"""Size of a launch file."""
_INCLUDED_AGAIN = "Look for a file that is included again and again."
_LIMITS = {
    "tags": (10_000, "the launch files come to more than {} tags in all", _INCLUDED_AGAIN),
    "bytes": (1_000_000, "the launch files have more than {} bytes in all", _INCLUDED_AGAIN),
    "files": (
        300,
        "more than {} launch files are included",
        "Look for files that include each other.",
    ),
    "yaml": (
        100_000,
        "the YAML of this launch file is longer than {} characters",
        "Parameters are for settings; keep data in files that the node reads.",
    ),
    "all": (
        50_000_000,
        "the values of this launch file are longer than {} characters in all",
        "Look for arguments that double again and again.",
    ),
}
"""What is counted: tags with the parameters and remappings that come of them; bytes and number of launch files; characters
of YAML, which is slow to read; characters and bytes of all values and files. How much there may be, and what to say of more."""
XACRO = "xacro"
"""A package of which only its program counts, and only as the command of a parameter."""
OF_ROS = frozenset({"controller_manager", "gazebo_plugins", "gazebo_ros_control", "rviz"})
"""Packages of ROS that robots' launch files name; those with nodes in the kit are known besides."""
_IN_PACKAGES = "Keep what belongs to a package in its folder, and name it by $(find PACKAGE)/...."


class Budget:
    """Counts what an evaluation has used; each method raises `LaunchRefused` if that is too much."""

    def __init__(self) -> None:
        self._used: Counter[str] = Counter()

    def tag(self, count: int = 1) -> None:
        """One more tag, or so many."""
        self._use("tags", count)

    def launch_file(self, size: int) -> None:
        """One more launch file, of so many bytes."""
        self._use("bytes", size)
        self._use("files", 1)

    def string(self, length: int) -> None:
        """A value of so many characters."""
        if length > MAX_STRING:
            raise ours(
                TOO_MUCH,
                f"a value of {length} characters is longer than the {MAX_STRING} that are allowed",
                "Put long texts into a file, and use textfile=.",
            )
        self.total(length)

    def yaml(self, length: int) -> None:
        """A YAML text of so many characters."""
        self._use("yaml", length)

    def total(self, amount: int) -> None:
        """So many characters or bytes were read or made."""
        self._use("all", amount)

    def _use(self, kind: str, amount: int) -> None:
        self._used[kind] += amount
        most, what, remedy = _LIMITS[kind]
        if self._used[kind] > most:
            raise ours(TOO_MUCH, what.format(most), remedy)


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
