"""A notebook as far as grading reads it: cells, tags and metadata; never its outputs.

Plain JSON and tolerance on purpose: cell ids, kernel, format version and outputs of a hand-in do
not matter, and nbformat takes seconds to import where JupyterLab is installed.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from grader.errors import SubmissionError
from grader.submission.json_text import parse_json
from grader.submission.labels import label
from grader.submission.regular_file import read_regular_file

MAX_NOTEBOOK_BYTES = 64_000_000
"""Largest notebook file that is read."""
MAX_CELLS = 5_000
"""Most cells of a notebook."""
MAX_CELL_CHARACTERS = 1_000_000
"""Longest text of one cell."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Cell:
    """One cell."""

    number: int
    """Its place in the notebook, from 1, as a person counts."""
    kind: str
    """"code", "markdown", "raw", or whatever the file says."""
    source: str
    """Its text with line feeds as line ends."""
    tags: tuple[str, ...]
    id: str | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Notebook:
    """The cells and the metadata of a notebook."""

    cells: tuple[Cell, ...]
    metadata: dict[str, object]
    notes: tuple[str, ...]
    """Sentences for the student about what was odd and was read all the same."""

    @property
    def exercise_id(self) -> str | None:
        """The exercise that the notebook itself claims to be; None if it does not say."""
        table = self.metadata.get("workbook")
        claimed = table.get("id") if isinstance(table, dict) else None
        return claimed if isinstance(claimed, str) else None


def read_notebook(path: Path) -> Notebook:
    """The notebook in a file.

    Raises:
        SubmissionError: The file cannot be read or holds no notebook; a sentence names it.
    """
    path = Path(path)
    return notebook_from_bytes(read_regular_file(path, MAX_NOTEBOOK_BYTES), name=label(path.name))


def notebook_from_bytes(data: bytes, *, name: str) -> Notebook:
    """The notebook in the bytes of a file.

    Args:
        data: Content of the file.
        name: What to call it in messages.

    Raises:
        SubmissionError: There is no notebook in them.
    """
    if not data.strip():
        raise SubmissionError(f"{name} is empty; save the notebook and hand it in again")
    try:
        return _notebook(parse_json(data))
    except SubmissionError as error:
        raise SubmissionError(f"{name} {error}") from error


def _notebook(value: object) -> Notebook:
    if not isinstance(value, dict):
        raise SubmissionError("is JSON, but not a notebook: it has no cells")
    metadata = value.get("metadata")
    metadata = metadata if isinstance(metadata, dict) else {}
    raw_cells = _raw_cells(value)
    cells = tuple(
        _cell(raw, number) for number, raw in enumerate(raw_cells, 1) if isinstance(raw, dict)
    )
    notes = [*_broken_cell_notes(len(raw_cells) - len(cells)), *_id_notes(cells)]
    notes += _kernel_notes(metadata)
    return Notebook(cells=cells, metadata=metadata, notes=tuple(notes))


def _raw_cells(value: dict[str, object]) -> list[object]:
    cells = value.get("cells")
    if cells is None:  # nbformat 3 keeps them in worksheets
        sheets = value.get("worksheets")
        lists = [sheet.get("cells") for sheet in _items(sheets) if isinstance(sheet, dict)]
        cells = [cell for items in lists for cell in _items(items)] if lists else None
    if not isinstance(cells, list):
        raise SubmissionError("is JSON, but not a notebook: it has no list of cells")
    if len(cells) > MAX_CELLS:
        raise SubmissionError(f"has more than {MAX_CELLS} cells")
    return cells


def _items(value: object) -> list[object]:
    return value if isinstance(value, list) else []


def _cell(raw: dict[str, object], number: int) -> Cell:
    kind, cell_id, metadata = raw.get("cell_type"), raw.get("id"), raw.get("metadata")
    tags = metadata.get("tags") if isinstance(metadata, dict) else None
    source = _source(raw.get("source", raw.get("input")))
    if len(source) > MAX_CELL_CHARACTERS:
        raise SubmissionError(f"has a cell (number {number}) of {len(source)} characters")
    return Cell(
        number=number,
        kind=kind if isinstance(kind, str) else "unknown",
        source=source,
        tags=tuple(tag for tag in _items(tags) if isinstance(tag, str)),
        id=cell_id if isinstance(cell_id, str) else None,
    )


def _source(value: object) -> str:
    if isinstance(value, list):
        value = "".join(line for line in value if isinstance(line, str))
    if not isinstance(value, str):
        return ""
    # Half of a surrogate pair cannot be written to a file.
    text = value.encode("utf-8", "replace").decode("utf-8")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _broken_cell_notes(broken: int) -> list[str]:
    if not broken:
        return []
    return [f"{broken} of the notebook's cells are broken and were left out."]


def _id_notes(cells: tuple[Cell, ...]) -> list[str]:
    ids = [cell.id for cell in cells if cell.id is not None]
    notes = []
    if len(set(ids)) < len(ids):
        notes.append("Some cells share one id (copied cells do); each was read.")
    if len(ids) < len(cells):
        notes.append("Some cells have no id; they were read all the same.")
    return notes


def _kernel_notes(metadata: dict[str, object]) -> list[str]:
    kernel = metadata.get("kernelspec")
    name = kernel.get("name") if isinstance(kernel, dict) else None
    if not isinstance(name, str) or name == "python3":
        return []
    return [f"The notebook names the kernel {name[:60]!r}; grading does not use it."]
