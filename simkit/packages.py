"""ROS packages on disk: where they are, and which file a command line means.

Source: rospack (a folder with a `package.xml` is a package, named by its folder here; one with a file `CATKIN_IGNORE` is passed
over) and rosrun (an executable is found by its file name anywhere in the package).
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from simkit.errors import SimkitError, UnknownNameError, near_names

MAX_DEPTH = 5
"""How deep below a folder of the path a package may lie."""
PATH_VARIABLES = ("SIMKIT_PACKAGE_PATH", "ROS_PACKAGE_PATH")
"""Environment variables with folders of packages, in the order in which they are searched."""
IGNORED = "CATKIN_IGNORE"
"""A folder with a file of this name is passed over, with all that is in it, unless the path names that very folder."""
_SKIPPED = {".git", ".venv", "node_modules", "__pycache__", ".ipynb_checkpoints"}


class PackageError(SimkitError):
    """A package is there, but not what was asked of it."""


@dataclass(frozen=True, kw_only=True)
class Package:
    """One ROS package."""

    name: str
    """Its name: that of its folder."""
    folder: Path
    """Where it is."""

    def find_executable(self, name: str) -> Path:
        """The file that `rosrun package name` means.

        Raises:
            UnknownNameError: No file of that name; lists what could be run.
            PackageError: Several files of that name.
        """
        files = sorted(_files(self.folder))
        found = [file for file in files if file.name == name]
        if len(found) == 1:
            return found[0]
        if found:
            listed = ", ".join(str(file.relative_to(self.folder)) for file in found)
            raise PackageError(f"package {self.name} has several files named {name}: {listed}")
        raise UnknownNameError(f"executable in package {self.name!r}", name, self.executables())

    def executables(self) -> list[str]:
        """Names of the files that could be run: Python scripts, and what may be executed."""
        return [
            file.name
            for file in sorted(_files(self.folder))
            if file.suffix == ".py" or os.access(file, os.X_OK)
        ]


class PackagePath:
    """Folders in which packages are looked for, the first hit wins.

    Args:
        folders: Searched first, in order; the working folder if None. Those of SIMKIT_PACKAGE_PATH and
            ROS_PACKAGE_PATH follow.
        confined: Whether files outside of the packages are out of reach, and the environment too: for work of people
            who are not trusted.
    """

    def __init__(
        self, folders: Sequence[str | Path] | None = None, *, confined: bool = False
    ) -> None:
        more = [] if confined else _folders_of_environment()
        if folders is None:
            here = Path.cwd()
            folders = [] if here == here.parent else [here]  # nobody means the whole disk
        self.folders = [Path(folder).absolute() for folder in [*folders, *more]]
        self.confined = confined

    def prefer(self, folders: Sequence[str | Path]) -> None:
        """Look in these folders first from now on, then in the others."""
        first = [Path(folder).absolute() for folder in folders]
        self.folders = [*first, *(folder for folder in self.folders if folder not in first)]

    def may_read(self, path: str | Path) -> bool:
        """Whether a file that somebody's launch file or robot names may be opened.

        Where nothing is confined, any file. Otherwise one inside of a package, whatever links lead there.
        """
        if not self.confined:
            return True
        try:
            real = Path(path).resolve()
            folders = [package.folder.resolve() for package in self.packages().values()]
        except (OSError, RuntimeError, ValueError):
            return False  # links in a circle, or no path at all
        return any(real.is_relative_to(folder) for folder in folders)

    def packages(self) -> dict[str, Package]:
        """Every package on the path, by name."""
        found: dict[str, Package] = {}
        for folder in self.folders:
            for manifest in _manifests(folder, MAX_DEPTH):
                found.setdefault(
                    manifest.parent.name, Package(name=manifest.parent.name, folder=manifest.parent)
                )
        return found

    def find(self, name: str) -> Package:
        """A package by name.

        Raises:
            UnknownNameError: None of that name; lists those on the path.
            PackageError: A folder of that name is there, but without a `package.xml`.
        """
        packages = self.packages()
        if name in packages:
            return packages[name]
        for folder in self.folders:
            if (folder / name).is_dir() and not near_names(name, packages):
                raise PackageError(
                    f"{name} is a folder but no package: it has no package.xml "
                    f"(add one beside its scripts: {name}/package.xml)"
                )
        raise UnknownNameError("package", name, packages)


def _folders_of_environment() -> list[str]:
    texts = [os.environ.get(variable, "") for variable in PATH_VARIABLES]
    return [part for text in texts for part in text.split(os.pathsep) if part]


def _manifests(folder: Path, depth: int) -> Iterator[Path]:
    manifest = folder / "package.xml"
    if manifest.is_file():
        yield manifest
        return
    if depth == 0 or not folder.is_dir():
        return
    try:
        children = sorted(folder.iterdir())
    except PermissionError:  # somebody else's folder has no package of ours
        return
    for child in children:
        if child.is_dir() and not child.is_symlink() and not _is_ignored(child):
            yield from _manifests(child, depth - 1)


def _is_ignored(folder: Path) -> bool:
    return folder.name in _SKIPPED or (folder / IGNORED).exists()


def _files(folder: Path) -> Iterator[Path]:
    for child in sorted(folder.iterdir()):
        if child.name in _SKIPPED or child.is_symlink():
            continue
        if child.is_dir():
            yield from _files(child)
        elif child.is_file():
            yield child
