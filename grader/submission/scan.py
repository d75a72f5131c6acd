"""Every notebook below a path of the command line, in a fixed order, without following links."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from pathlib import Path

from grader.errors import GraderError, SubmissionError
from grader.submission.archive import Item, archive_items, is_ignored
from grader.submission.notebook import MAX_NOTEBOOK_BYTES
from grader.submission.regular_file import open_regular_file, read_regular_file

MAX_DEPTH = 12
"""Deepest folder that is searched."""
MAX_SCANNED = 200_000
"""Most files and folders that are looked at below one path."""


def scan(path: Path) -> Iterator[Item]:
    """The notebooks that a path of the command line stands for.

    Args:
        path: A notebook, a zip file, or a folder of these.

    Raises:
        GraderError: There is nothing at this path, or something else.
    """
    if not os.path.lexists(path):
        raise GraderError(f"no file or folder {path}")
    if path.is_dir():
        yield from _folder(path, ())
    elif _kind(path.name) in ("ipynb", "zip"):
        yield from _file(path, ())
    else:
        raise GraderError(f"{path} is neither a notebook (.ipynb), nor a zip file, nor a folder")


def _kind(name: str) -> str:
    return name.rpartition(".")[2].lower() if "." in name else ""


def _folder(folder: Path, parts: tuple[str, ...]) -> Iterator[Item]:
    if len(parts) > MAX_DEPTH:
        yield Item(parts=parts, problem=f"{parts[-1]} lies too deep", is_folder=True)
        return
    try:
        names = sorted(entry.name for entry in os.scandir(folder))
    except OSError as error:
        problem = f"{folder.name} cannot be read: {error.strerror}"
        yield Item(parts=parts, problem=problem, is_folder=True)
        return
    if len(names) > MAX_SCANNED:
        problem = f"{folder.name} holds more than {MAX_SCANNED} files"
        yield Item(parts=parts, problem=problem, is_folder=True)
        return
    for name in names:
        if not is_ignored((name,)):
            yield from _child(folder / name, (*parts, name))


def _child(path: Path, parts: tuple[str, ...]) -> Iterator[Item]:
    mode = path.lstat().st_mode
    if stat.S_ISDIR(mode):
        yield Item(parts=parts, is_folder=True)
        yield from _folder(path, parts)
    elif _kind(path.name) in ("ipynb", "zip"):
        yield from _file(path, parts)
    elif stat.S_ISLNK(mode) and path.is_dir():
        problem = f"{path.name} is a link; hand in the folder itself"
        yield Item(parts=parts, problem=problem, is_folder=True)


def _file(path: Path, parts: tuple[str, ...]) -> Iterator[Item]:
    try:
        if _kind(path.name) == "ipynb":
            yield Item(parts=parts, data=read_regular_file(path, MAX_NOTEBOOK_BYTES))
            return
        inside = (*parts[:-1], path.stem) if parts else ()
        if inside:
            yield Item(parts=inside, is_folder=True)
        with open_regular_file(path) as file:
            yield from archive_items(file, inside)
    except SubmissionError as error:
        yield Item(parts=parts, problem=str(error), is_folder=_kind(path.name) == "zip")
