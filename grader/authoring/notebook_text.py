"""A source as the text of a notebook: the same bytes whenever and wherever it is built."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Sequence
from typing import Any

from grader.authoring.source import Source
from grader.authoring.source_cells import SourceCell

_KERNEL = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}


def solution_notebook(source: Source) -> str:
    """The text of the notebook with the solution."""
    return _exercise(
        source, [(cell, cell.for_solution(), key) for cell, key in keyed(source.cells)]
    )


def student_notebook(source: Source) -> str:
    """The text of the notebook that is given out."""
    cells = [
        (cell, cell.for_students(), key)
        for cell, key in keyed(source.cells)
        if "solution" not in cell.tags
    ]
    return _exercise(source, cells)


def keyed(cells: Sequence[SourceCell]) -> list[tuple[SourceCell, str]]:
    """Each cell with what stays the same about it when other cells come and go.

    A cell is known by its label, else by the file it writes, else by its kind and its number among
    those of its kind.
    """
    count: Counter[str] = Counter()
    keyed = []
    for cell in cells:
        role = _role(cell)
        count[role] += 1
        keyed.append((cell, f"{role}:{count[role]}"))
    return keyed


def _role(cell: SourceCell) -> str:
    if cell.label is not None:
        return f"label:{cell.label}"
    if cell.written is not None:
        return f"file:{cell.written.path}"
    return "-".join([cell.kind, *sorted(cell.tags)])


def _exercise(source: Source, cells: Sequence[tuple[SourceCell, str, str]]) -> str:
    return notebook_text(cells, name=source.definition.id, metadata={"workbook": source.table})


def notebook_text(
    cells: Sequence[tuple[SourceCell, str, str]], *, name: str, metadata: dict[str, Any]
) -> str:
    """The text of a notebook.

    Args:
        cells: Each cell, its text in this notebook, and its key, unique in the notebook.
        name: Tells this notebook's cells from those of others with the same keys.
        metadata: What its metadata holds besides the kernel.
    """
    value = {
        "cells": [_cell(cell, text, f"{name}/{key}") for cell, text, key in cells],
        "metadata": {"kernelspec": _KERNEL, "language_info": {"name": "python"}, **metadata},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    return json.dumps(value, ensure_ascii=False, indent=1, sort_keys=True) + "\n"


def _cell(cell: SourceCell, text: str, key: str) -> dict[str, Any]:
    made: dict[str, Any] = {
        "cell_type": cell.kind,
        "id": hashlib.sha256(key.encode()).hexdigest()[:12],
        "metadata": {"tags": list(cell.tags)} if cell.tags else {},
        "source": text.splitlines(keepends=True),
    }
    if cell.kind == "code":
        made |= {"execution_count": None, "outputs": []}
    if "hint" in cell.tags:
        _fold(made, text)
    return made


def _fold(made: dict[str, Any], text: str) -> None:
    """Hide a hint until it is asked for."""
    if made["cell_type"] == "code":
        made["metadata"]["jupyter"] = {"source_hidden": True}
    else:
        folded = f"<details>\n<summary>Hint</summary>\n\n{text}\n\n</details>"
        made["source"] = folded.splitlines(keepends=True)
