"""What to say of a file that is not there: which one was meant, and how it is named."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from pathlib import Path

from simkit.errors import near_names
from simkit.packages import Package

_TORN = re.compile(r"\$?[({]?\s*find\s+(?P<package>[\w-]+)\s*[)}]?/?(?P<rest>[^)}]*)[)}]?$")
"""A `$(find PACKAGE)/...` that lacks something, so that nobody has replaced it."""
_MOST = 1000
"""So many files of a folder are looked at."""


def how_to_name(name: str, packages: Iterable[Package], *, may_read: Callable[[Path], bool]) -> str:
    """A remedy for the name of a file that is not there.

    Args:
        name: The name as it was looked for, what could be replaced in it replaced.
        packages: The packages that are known.
        may_read: Whether a file is within reach; of others not even that they are there is told.
    """
    packages = list(packages)
    path = Path(name)
    if torn := torn_find(name):
        return torn
    if found := _from_a_package(name, packages, may_read):
        return f"Write {found}: a relative path begins in the folder of the terminal."
    if name.startswith("package://"):
        rest = name.removeprefix("package://").replace("/", ")/", 1)
        return f"Write $(find {rest}; package:// is for meshes of a URDF."
    if near := near_names(path.name, _files_in(path.parent)):
        return f"Did you mean {' or '.join(near)}, which is in that folder?"
    if found := _elsewhere(path, packages, may_read):
        return f"Write {found}: there it is."
    return "Write the path of a file that is there, best as $(find PACKAGE)/folder/file."


def torn_find(name: str) -> str | None:
    """A remedy for a `$(find PACKAGE)` with a slip in it; None if there is none."""
    found = _TORN.match(name)
    if found is None:
        return None
    return (
        f"Write $(find {found['package']})/{found['rest'].lstrip('/')}, with $ and round brackets."
    )


def _from_a_package(
    name: str, packages: list[Package], may_read: Callable[[Path], bool]
) -> str | None:
    """How to name a file whose path begins in a package."""
    if not name or Path(name).is_absolute():
        return None
    for package in packages:
        path = package.folder / name
        if may_read(path) and path.is_file():
            return f"$(find {package.name})/{name}"
    return None


def _elsewhere(path: Path, packages: list[Package], may_read: Callable[[Path], bool]) -> str | None:
    """How to name the one file of this name in the package that was meant, if it is in another folder."""
    for package in packages:
        if path.is_relative_to(package.folder):
            same = [one for one in _files_below(package.folder) if one.name == path.name]
            if len(same) == 1 and may_read(same[0]):
                return f"$(find {package.name})/{same[0].relative_to(package.folder).as_posix()}"
    return None


def _files_below(folder: Path) -> Iterator[Path]:
    return islice((one for one in sorted(folder.rglob("*")) if one.is_file()), _MOST)


def _files_in(folder: Path) -> list[str]:
    try:
        return sorted(child.name for child in folder.iterdir() if child.is_file())[:_MOST]
    except OSError:
        return []
