"""Which file is meant: by `roslaunch PACKAGE FILE` or `roslaunch PATH`, and by a name of which there is no file.

Source: roslaunch `resolve_launch_arguments`: a file of that name anywhere in the package, else the first word as a path.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import islice
from pathlib import Path

from simkit.diagnostics import Diagnostic, Severity
from simkit.errors import UnknownNameError, near_names
from simkit.launch.errors import LaunchError
from simkit.launch.rules import ARGUMENT, NOT_FOUND
from simkit.packages import Package, PackagePath
from simkit.xml import Span

KNOWN = Path(__file__).parent / "known"
"""Folders of packages that come with the kit, with the launch files that others include."""
_ENDINGS = (".launch", ".xml", ".test")


def find_launch_file(words: Sequence[str], packages: PackagePath) -> tuple[Path, list[str]]:
    """The launch file of a command line, and the words behind it.

    Args:
        words: What stands behind `roslaunch`: a package and a file, or a path; then arguments.
        packages: Where packages are.

    Raises:
        LaunchError: There is no such file, or several.
    """
    if len(words) >= 2:
        package = _package(words[0], packages)
        found = [] if package is None else _files_named(package.folder, words[1])
        if len(found) > 1:
            raise _several(words, found)
        if found:
            return found[0], list(words[2:])
    if words and Path(words[0]).is_file():
        return Path(words[0]), list(words[1:])
    raise _nothing(words, packages)


def given_arguments(words: Sequence[str]) -> dict[str, str]:
    """Values of arguments by name, from `name:=value` words.

    Raises:
        LaunchError: A word is something else.
    """
    arguments = {}
    for word in words:
        name, sign, value = word.partition(":=")
        if not sign or not name:
            raise _no_argument(words, word)
        if not (name.startswith("_") and not name.startswith("__")):
            arguments[name.strip()] = value.strip()
    return arguments


def launch_files(folder: Path) -> list[Path]:
    """The launch files of a package, sorted."""
    return [path for path in _all_files(folder) if path.suffix in _ENDINGS[:1]]


def _package(name: str, packages: PackagePath) -> Package | None:
    found = packages.packages().get(name)
    if found is None and name.isidentifier() and (KNOWN / name).is_dir():
        return Package(name=name, folder=KNOWN / name)
    return found


def _files_named(folder: Path, name: str) -> list[Path]:
    if "/" in name or "\\" in name:
        path = folder / name
        return [path] if path.is_file() else []
    return [path for path in _all_files(folder) if path.name == name]


def _all_files(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.is_file() and not path.is_symlink())


def _no_argument(words: Sequence[str], word: str) -> LaunchError:
    """The error for a word behind the launch file that is no `name:=value`."""
    what, remedy = f"{word!r} is no argument", "Write name:=value."
    name, equals, value = word.partition("=")
    before = words[words.index(word) - 1] if words.index(word) else ""
    if word.startswith("-"):
        what = f"{word!r} is no argument, and no option that there is here"
        remedy = "simkit roslaunch --help lists the options."
    elif before.endswith(":="):
        remedy = f"Write {before}{word}, without a blank."
    elif equals and name.isidentifier():
        remedy = f"Write {name}:={value}, with a colon."
    elif word.endswith(_ENDINGS):
        what = f"{word!r} is a second launch file, and one is launched at a time"
        remedy = (
            "Launch it in another terminal, or write a launch file that has an <include> of each."
        )
    return _error("", word, what, remedy, rule=ARGUMENT)


def _several(words: Sequence[str], found: Sequence[Path]) -> LaunchError:
    listed = "".join(f"\n- {path}" for path in found)
    said = (
        f"RLException: multiple files named [{words[1]}] in package [{words[0]}]:{listed}\n"
        "Please specify full path instead"
    )
    what = f"the package {words[0]} has {len(found)} files named {words[1]}"
    return _error(said, words[1], what, "Give the path of the one that you mean.")


def _nothing(words: Sequence[str], packages: PackagePath) -> LaunchError:
    if len(words) < 2 or ":=" in words[1]:
        name = words[0] if words else ""
        said = f"RLException: [{name}] is not a launch file name"
        return _error(said, name, f"there is no file {name!r}", _where_it_may_be(name, packages))
    package, file = words[0], words[1]
    said = (
        f"RLException: [{file}] is neither a launch file in package [{package}] nor is [{package}] a "
        "launch file name"
    )
    found = _package(package, packages)
    if found is None:
        what = str(UnknownNameError("package", package, packages.packages()))
        remedy = "Write the name of a package that is here, or go to the folder that holds it."
        return _error(said, file, what, remedy)
    known = [path.name for path in launch_files(found.folder)]
    near = near_names(file, known)
    what = f"the package {package} has no file {file!r}"
    remedy = f"It has {', '.join(known[:12])}." if known else f"Write it: {package}/launch/{file}."
    if near:
        remedy = f"Did you mean {' or '.join(near)}?"
    return _error(said, file, what, remedy)


def _where_it_may_be(name: str, packages: PackagePath) -> str:
    """What to do about one word that is no path of a file: half of a command line, or a slip."""
    found = packages.packages()
    if name in found:
        known = [path.name for path in launch_files(found[name].folder)]
        files = " or ".join(known[:3]) or "FILE.launch"
        return f"Write the launch file behind the package: simkit roslaunch {name} {files}."
    for package in found.values():
        if _files_named(package.folder, name):
            return f"It is in a package: simkit roslaunch {package.name} {name}."
    beside: list[str] = []
    with contextlib.suppress(OSError, ValueError):
        if packages.may_read(name):
            beside = sorted(path.name for path in Path(name).parent.iterdir())
    if near := near_names(Path(name).name, [one for one in beside if one.endswith(_ENDINGS)]):
        return f"Did you mean {' or '.join(near)}, which is in that folder?"
    return "Write simkit roslaunch PACKAGE FILE.launch, or the path of a launch file."


def _error(said: str, file: str, what: str, remedy: str, *, rule: str = NOT_FOUND) -> LaunchError:
    diagnostic = Diagnostic(
        rule=rule,
        severity=Severity.ERROR,
        file=file,
        span=Span(1, 1),
        source="",
        what=what,
        remedy=remedy,
    )
    return LaunchError(said, diagnostic)


_TORN = re.compile(r"\$?[({]?\s*find\s+(?P<package>[\w-]+)\s*[)}]?/?(?P<rest>[^)}]*)[)}]?$")
"""A `$(find PACKAGE)/...` that lacks something, so that nobody has replaced it."""
_MOST = 1000
"""So many files of a folder are looked at."""


def how_to_name(name: str, packages: Iterable[Package], *, may_read: Callable[[Path], bool]) -> str:
    """A remedy for the name of a file that is not there.

    Args:
        name: The name as it was looked for, what could be replaced in it replaced.
        packages: The packages that are known.
        may_read: Whether a file is within reach; of others the remedy does not even say that they exist.
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
