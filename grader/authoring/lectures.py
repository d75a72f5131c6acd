"""Lectures: from `lectures/*.md`, written like sources of exercises, to notebooks beside them.

A lecture is for reading and running: it has no regions, no deliverables and one version for all.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from grader.authoring.findings import Finding
from grader.authoring.myst import parsed_myst
from grader.authoring.notebook_text import keyed, notebook_text
from grader.authoring.source_cells import SourceCell, read_cells
from grader.errors import SourceError

FOLDER = "lectures"


def lecture_paths(root: Path) -> list[Path]:
    """The sources of a workbook's lectures, in order."""
    return sorted(path for path in (root / FOLDER).glob("*.md") if path.name != "README.md")


def built_lectures(root: Path) -> dict[Path, str]:
    """File -> text of the notebook of each lecture.

    Raises:
        SourceError: A lecture has a fault.
    """
    return {path.with_suffix(".ipynb"): lecture_notebook(path) for path in lecture_paths(root)}


def fresh_lectures(root: Path) -> Iterator[Finding]:
    """The notebook of each lecture is what its source says."""
    for path in lecture_paths(root):
        notebook = path.with_suffix(".ipynb")
        try:
            text = lecture_notebook(path)
        except SourceError as error:
            line = f":{error.line}" if error.line is not None else ""
            yield Finding(file=f"{FOLDER}/{error.file}{line}", what=error.text, remedy="correct it")
            continue
        if not notebook.is_file() or notebook.read_bytes() != text.encode("utf-8"):
            yield Finding(
                file=f"{FOLDER}/{notebook.name}",
                what="is stale" if notebook.is_file() else "is missing",
                remedy="run `grader build`",
            )


def lecture_notebook(path: Path) -> str:
    """The text of the notebook of a lecture.

    Args:
        path: Its source.

    Raises:
        SourceError: It is not MyST Markdown, or has what only exercises have.
    """
    parsed, lines = parsed_myst(path)
    cells = read_cells(parsed, lines, file=path.name)
    for cell in cells:
        _require_plain(cell, path.name)
    made = [(cell, cell.text, key) for cell, key in keyed(cells)]
    return notebook_text(made, name=f"{FOLDER}/{path.stem}", metadata={})


def _require_plain(cell: SourceCell, file: str) -> None:
    """Refuse what only exercises have."""
    what = ""
    if cell.regions:
        what = "a region of a solution"
    elif set(cell.tags) - {"hint"}:
        what = f"a cell tagged `{sorted(set(cell.tags) - {'hint'})[0]}`"
    elif cell.written is not None:
        what = f"a cell that writes {cell.written.path}"
    if what:
        raise SourceError(f"{what} belongs into an exercise", file=file, line=cell.line)
