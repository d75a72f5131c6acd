"""Where a student's file goes: a path relative to `work/`, or a sentence why nowhere."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass

MAX_PATH = 200
"""Longest path [characters]."""
_PART = re.compile(r"[\w.+@=,() -]{1,100}")
_RESERVED = re.compile(r"(?i)(con|prn|aux|nul|com[0-9]|lpt[0-9])(\..*)?")


@dataclass(frozen=True, slots=True, kw_only=True)
class Placed:
    """The outcome of placing one path."""

    path: str | None
    """Normalised path with forward slashes; None if the file is not taken."""
    note: str = ""
    """Sentence for the student; empty if there is nothing to say."""


def place(written: str, *, packages: Collection[str], wanted: Collection[str]) -> Placed:
    """Where the file that a student called `written` belongs.

    Args:
        written: The path after `%%writefile`.
        packages: Top folders the exercise may write to.
        wanted: Paths of the deliverables.

    Returns:
        A deliverable also for a path that differs from it by case only, by backslashes, or by a
        leading `work/`, with a note; any other path inside `packages` as it is.
    """
    shown = repr(written[:80])
    if refusal := _refusal(written):
        return Placed(path=None, note=f"The file {shown} was not taken: {refusal}.")
    parts = [part for part in written.replace("\\", "/").split("/") if part not in ("", ".")]
    path = "/".join(parts)
    meant = _meant(path, wanted)
    if meant is not None and (meant != path or "\\" in written):
        return Placed(path=meant, note=f"The file {shown} was taken as {meant}; write it so.")
    if parts[-1].lower() == "package.xml" and len(parts) > 2:
        # It would make a package of any name, e.g. one that stands in for turtlesim.
        return Placed(path=None, note=f"The file {shown} was not taken: a package in a package.")
    if parts[0] not in packages:
        return Placed(path=None, note=_outside(shown, parts[-1], packages, wanted))
    return Placed(path=path)


def _outside(shown: str, name: str, packages: Collection[str], wanted: Collection[str]) -> str:
    meant = [path for path in wanted if path.rpartition("/")[2] == name]
    if meant:
        return f"The file {shown} was not taken; write it as {meant[0]}."
    folders = " or ".join(f"{package}/" for package in sorted(packages))
    return f"The file {shown} was not taken: this exercise's files are in {folders}."


def _refusal(written: str) -> str:
    """Why a path is refused; empty if it is not."""
    path = written.replace("\\", "/")
    if not path.strip("/."):
        return "it has no name; the first line must be `%%writefile path/to/file`"
    if len(path) > MAX_PATH:
        return f"its path is longer than {MAX_PATH} characters"
    if path.startswith(("/", "~")) or re.match(r"[A-Za-z]:", path):
        return "its path must be relative to the notebook, as in `hello_ros/scripts/name.py`"
    parts = path.split("/")
    if ".." in parts:
        return "`..` leads out of the folder of your files"
    if path.endswith("/"):
        return "it names a folder"
    bad = next((p for p in parts if p not in ("", ".") and not _is_plain(p)), None)
    if bad is not None:
        return f"{bad!r} in its path is not a plain name (letters, digits, _ - .)"
    return ""


def _is_plain(part: str) -> bool:
    return bool(_PART.fullmatch(part)) and not _RESERVED.fullmatch(part) and part == part.strip(" ")


def _meant(path: str, wanted: Collection[str]) -> str | None:
    """The deliverable that `path` is, but for case or a leading `work/`."""
    if path in wanted:
        return path
    folded = path.casefold().removeprefix("work/")
    return next((name for name in wanted if name.casefold() == folded), None)
