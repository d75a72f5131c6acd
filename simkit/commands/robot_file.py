"""Which file a name on a command line means, and what is in it: robots, launch files, YAML."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

from simkit.errors import SimkitError, near_names
from simkit.packages import PackagePath

MOST_BYTES = 20_000_000
"""No robot is larger; what is, was named by mistake."""
_PACKAGE = "package://"


@dataclass(frozen=True, kw_only=True)
class RobotFile:
    """A file that was named."""

    name: str
    """Name to show for it."""
    data: bytes
    """What is in it."""
    folder: Path
    """Where names of meshes begin that are relative to it."""
    packages: PackagePath
    """Where packages are looked for: below this folder, in SIMKIT_PACKAGE_PATH, and beside the package that the file lies in."""


def read_file(name: str) -> RobotFile:
    """Read what a name means: a path, `package://hello_ros/urdf/robot.urdf`, or `-` for standard input.

    Raises:
        SimkitError: There is no such file, or it cannot be read; names the files that may be meant.
    """
    packages = PackagePath()
    if name == "-":
        data = sys.stdin.buffer.read(MOST_BYTES + 1)
        return RobotFile(
            name="<stdin>", data=_small(data, "standard input"), folder=Path(), packages=packages
        )
    path = _path(name, packages)
    return RobotFile(
        name=str(path),
        data=_text_of(path),
        folder=path.parent,
        packages=_with_neighbours(path, packages),
    )


def _path(name: str, packages: PackagePath) -> Path:
    if not name.startswith(_PACKAGE):
        path = Path(name)
        if name and _exists(path):
            return path
        raise SimkitError(f"no file {name[:200]!r}{_meant(path, packages)}")
    package, _, inner = name.removeprefix(_PACKAGE).partition("/")
    folder = packages.find(package).folder
    path = folder / inner
    if not inner or not _exists(path):
        raise SimkitError(f"package {package} has no file {inner[:200]!r}{_meant(path, packages)}")
    try:
        return path.relative_to(Path.cwd())
    except ValueError:
        return path


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):  # a name that no file can have
        return False


def _meant(path: Path, packages: PackagePath) -> str:
    """Where a file of that name, or of a similar one, is: below a package, or beside it."""
    cwd = Path.cwd()
    inside = [
        found
        for package in packages.packages().values()
        for found in sorted((package.folder / "urdf").glob("*"))
    ]
    same = [found for found in inside if found.name == path.name]
    if same:
        places = [
            str(one.relative_to(cwd)) if one.is_relative_to(cwd) else str(one) for one in same
        ]
        return f"; there is {' and '.join(places[:3])}"
    beside = path.parent.iterdir() if _exists(path.parent) and path.parent.is_dir() else iter(())
    names = {found.name for found in [*beside, *inside] if found.is_file()}
    near = near_names(path.name, names) if len(path.name) < 100 else []
    return f"; did you mean {' or '.join(near)}?" if near else ""


def _text_of(path: Path) -> bytes:
    if path.is_dir():
        inner = sorted(found.name for found in path.glob("*.urdf"))
        files = f"; in it are {', '.join(inner[:6])}" if inner else ""
        raise SimkitError(f"{path} is a folder, not a file{files}")
    try:
        with path.open("rb") as file:
            return _small(file.read(MOST_BYTES + 1), str(path))
    except OSError as error:
        raise SimkitError(f"{path} cannot be read: {error.strerror or error}") from error


def _small(data: bytes, name: str) -> bytes:
    if len(data) > MOST_BYTES:
        raise SimkitError(f"{name} has more than {MOST_BYTES // 1_000_000} MB: that is no robot")
    is_utf16 = data[:2] in (b"\xff\xfe", b"\xfe\xff")
    if b"\0" in data[:4096] and not is_utf16:
        raise SimkitError(f"{name} is no text: it holds bytes that no text has")
    return data


def _with_neighbours(path: Path, packages: PackagePath) -> PackagePath:
    """The packages, and those beside the one that a file lies in."""
    for folder in path.absolute().parents:
        if (folder / "package.xml").is_file():
            return PackagePath([Path.cwd(), folder.parent])
    return packages
