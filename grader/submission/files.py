"""The files that a notebook writes, taken out of its cells without running them."""

from __future__ import annotations

import functools
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

from grader.submission.notebook import Cell, Notebook
from grader.submission.paths import place
from grader.submission.writefile import WrittenFile, written_file

MAX_FILES = 100
"""Most files of one hand-in."""
MAX_TOTAL_CHARACTERS = 2_000_000
"""Most text of all files of one hand-in."""


@dataclass(slots=True, kw_only=True)
class CollectedFiles:
    """What was found so far."""

    files: dict[str, str] = field(default_factory=dict)
    """Normalised path -> text."""
    notes: list[str] = field(default_factory=list)


def collect_files(
    notebook: Notebook,
    *,
    packages: Collection[str],
    wanted: Collection[str],
    stubs: Mapping[str, str] | None = None,
) -> CollectedFiles:
    """Every file that the `%%writefile` cells of a notebook write; later cells win.

    Args:
        notebook: What was handed in; the type of its cells does not matter.
        packages: Top folders that may be written to; other files are left out with a note.
        wanted: Paths of the deliverables.
        stubs: Files as released: a later cell with the untouched stub does not replace work.
    """
    found = CollectedFiles()
    for cell in notebook.cells:
        if written := written_file(cell.source):
            _take(cell, written, found, packages=packages, wanted=wanted, stubs=stubs or {})
    return found


def _take(
    cell: Cell,
    written: WrittenFile,
    found: CollectedFiles,
    *,
    packages: Collection[str],
    wanted: Collection[str],
    stubs: Mapping[str, str],
) -> None:
    placed = place(written.path, packages=packages, wanted=wanted)
    found.notes += [placed.note] if placed.note else []
    if placed.path is None:
        return
    path = placed.path
    found.notes += [f"In cell {cell.number} ({path}), {note}." for note in written.notes]
    if cell.kind != "code":
        found.notes.append(
            f"The cell that writes {path} is a {cell.kind[:20]} cell; it was read all the same."
            " Make it a code cell again, or Jupyter does not write the file."
        )
    _store(path, written, found, stub=stubs.get(path))


def _store(path: str, written: WrittenFile, found: CollectedFiles, *, stub: str | None) -> None:
    known = found.files.get(path)
    text = (known or "") + written.text if written.append else written.text
    if _is_clash(path, found.files):
        found.notes.append(f"The file {path} was not taken: another file has that place.")
        return
    total = sum(len(other) for other in found.files.values()) - len(known or "") + len(text)
    if len(found.files) + (known is None) > MAX_FILES or total > MAX_TOTAL_CHARACTERS:
        found.notes.append(f"The file {path} was not taken: too many or too long files.")
        return
    if known is not None and not written.append:
        if stub is not None and same_text(text, stub) and not same_text(known, stub):
            found.notes.append(
                f"Two cells write {path}; the later one is the untouched template, so the earlier"
                " one was taken. Delete the later one."
            )
            return
        found.notes.append(f"Two cells write {path}; the later one was taken.")
    found.files[path] = text


def _is_clash(path: str, files: Mapping[str, str]) -> bool:
    """Whether `path` differs from a known one by case only, or one is a folder of the other."""
    folded = path.casefold()
    for other in files:
        known = other.casefold()
        if other != path and known == folded:
            return True
        if known.startswith(f"{folded}/") or folded.startswith(f"{known}/"):
            return True
    return False


def same_text(one: str, other: str) -> bool:
    """Whether two texts are equal but for line ends and blanks at the end of lines or text."""
    return normalised(one) == normalised(other)


@functools.lru_cache(maxsize=16)  # a hostile notebook makes us compare one long text often
def normalised(text: str) -> str:
    """`text` with line feeds only, and without blanks at the end of lines or of the text."""
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    return "\n".join(line.rstrip() for line in lines).rstrip()
