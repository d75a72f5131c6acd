"""Which folders of this machine a student's process sees, and which it must not."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import simkit

SYSTEM_FOLDERS = (Path("/usr"),)
SYSTEM_LINKS = tuple(Path(name) for name in ("/bin", "/sbin", "/lib", "/lib32", "/lib64"))
LOADER_FILES = (Path("/etc/ld.so.cache"), Path("/etc/alternatives"))
PRIVATE_NAMES = ("exercises", "solutions", "tests", "benchmarks", "grader", "work", ".git", ".ci")


@dataclass(frozen=True, slots=True, kw_only=True)
class Mounts:
    """What is laid over an empty file system, read-only."""

    shown: tuple[Path, ...]
    """Folders and files that are visible at their own paths."""
    hidden: tuple[Path, ...]
    """Folders that stay empty although they lie in a shown one."""

    def in_order(self) -> list[tuple[Path, bool]]:
        """Paths with True (show) or False (hide), so that an inner one follows its outer one."""
        steps = [(path, True) for path in self.shown] + [(path, False) for path in self.hidden]
        return sorted(steps, key=lambda step: (len(step[0].parts), str(step[0]), step[1]))


def node_mounts(package_path: Path, *, private: Iterable[Path] = ()) -> Mounts:
    """What a node sees: the system, this Python, simkit, and one student's package folder.

    Args:
        package_path: The student's files, laid out.
        private: Folders to hide where they lie inside of a shown one: the workbook, the
            submissions, the gradebook.
    """
    shown = _deduplicated([*_system(), *_python(), _folder_of(simkit.__file__), package_path])
    hidden = [
        inner
        for path in _deduplicated([*private, Path(__file__).resolve().parents[1]])
        for inner in _without_breaking(path, shown)
        if any(inner.is_relative_to(outer) for outer in shown)
    ]
    return Mounts(shown=shown, hidden=_deduplicated(hidden))


def _without_breaking(path: Path, shown: tuple[Path, ...]) -> list[Path]:
    # An environment made in the workbook's own folder: hide what is secret in it, not Python.
    if path not in shown:
        return [path]
    return [path / name for name in PRIVATE_NAMES if (path / name).is_dir()]


def _system() -> list[Path]:
    folders = [path for path in SYSTEM_LINKS if path.is_dir() and not path.is_symlink()]
    return [
        *(path for path in SYSTEM_FOLDERS if path.is_dir()),
        *folders,
        *(path for path in LOADER_FILES if path.exists()),
    ]


def _python() -> list[Path]:
    executable = Path(sys.executable)
    packages = [Path(entry) for entry in sys.path if entry.endswith(("site-packages", "-packages"))]
    prefixes = [Path(sys.prefix), Path(sys.base_prefix), Path(sys.base_exec_prefix)]
    return [
        path
        for path in [*prefixes, executable.resolve().parent.parent, *packages]
        if path.is_dir() and path != Path("/")
    ]


def system_links() -> list[tuple[str, Path]]:
    """Links such as /lib -> usr/lib, as (target, path)."""
    return [(str(path.readlink()), path) for path in SYSTEM_LINKS if path.is_symlink()]


def _folder_of(file: str | None) -> Path:
    assert file is not None
    return Path(file).parent


def _deduplicated(paths: Iterable[Path]) -> tuple[Path, ...]:
    return tuple(dict.fromkeys(path.absolute() for path in paths))
