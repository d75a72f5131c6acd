"""The first line of a cell that writes a file: `%%writefile [-a] PATH`, read but never run."""

from __future__ import annotations

import re
import shlex
from dataclasses import dataclass

_MAGIC = re.compile(r"(?P<signs>%{1,2})(?P<gap>[ \t]*)(?:writefile|file)(?=\s|$)(?P<rest>.*)")
MAX_ARGUMENTS = 1000
"""So much of the line is read [characters]; a path is much shorter."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WrittenFile:
    """What a `%%writefile` cell says."""

    path: str
    """The path as the student wrote it, without quotes; empty if there is none."""
    append: bool
    text: str
    """What the file gets: the cell below the magic, ending with a line feed unless empty."""
    notes: tuple[str, ...]
    """What Jupyter would not have accepted, as ends of a sentence about the cell."""


def written_file(source: str) -> WrittenFile | None:
    """The file that a cell writes; None for any other cell.

    Blank lines and comments above the magic are skipped, as are a missing `%` and stray spaces:
    Jupyter would not write the file then, and the notes say so.
    """
    lines = source.split("\n")
    start = next((i for i, line in enumerate(lines) if not _is_skipped(line)), None)
    if start is None or not (found := _MAGIC.match(lines[start].strip())):
        return None
    path, append, notes = _arguments(found["rest"][:MAX_ARGUMENTS])
    if any(line.strip() for line in lines[:start]):
        notes.append("`%%writefile` must be the first line of its cell, above any comment")
    if found["signs"] == "%" or found["gap"]:
        notes.append("the magic is spelt `%%writefile`: two percent signs and no space")
    text = "\n".join(lines[start + 1 :])
    if text and not text.endswith("\n"):
        text += "\n"
    return WrittenFile(path=path, append=append, text=text, notes=tuple(notes))


def _is_skipped(line: str) -> bool:
    return not line.strip() or line.lstrip().startswith("#")


def _arguments(rest: str) -> tuple[str, bool, list[str]]:
    try:
        words = shlex.split(rest.replace("\\", "\\\\"))
    except ValueError:
        words = rest.replace('"', " ").replace("'", " ").split()
    append = any(word in ("-a", "--append") for word in words)
    paths = [word for word in words if word not in ("-a", "--append")]
    notes = []
    if len(paths) > 1:
        notes.append(
            "more than one name stands after `%%writefile`; put a path with spaces in quotes"
        )
    return (paths[0] if paths else ""), append, notes
