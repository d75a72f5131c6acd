"""The source of an exercise: MyST Markdown in `solutions/`, read and held to its rules.

The file has a front matter with the table `workbook`, text, and `{code-cell}` blocks, which may
have the tags `solution` (not for students), `hint` (folded), `answer` (short answers), and a
`:label:` that keeps the id of the cell when others come and go.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from grader.authoring.myst import parsed_myst
from grader.authoring.rules import require_sound
from grader.authoring.source_cells import SourceCell, read_cells
from grader.errors import SourceError
from grader.exercises import (
    SLUG_PATTERN,
    Definition,
    exercise_key,
    require_definition,
)

FRONT_MATTER_KEYS = ("workbook", "jupytext", "kernelspec")
"""What a front matter may hold; the last two are for editors and are not used."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Source:
    """One exercise as its author wrote it."""

    path: Path
    definition: Definition
    table: dict[str, Any]
    """The `workbook` table as written, for the notebooks' metadata."""
    cells: tuple[SourceCell, ...]

    @property
    def slug(self) -> str:
        """Name of the file without ending, and of both notebooks."""
        return self.path.stem


def source_paths(root: Path) -> list[Path]:
    """The sources of a workbook, in order."""
    return sorted(path for path in (root / "solutions").glob("*.md") if path.name != "README.md")


def load_source(path: Path) -> Source:
    """The source in a file.

    Raises:
        SourceError: Anything is not as it must be; file and line say where.
    """
    parsed, lines = parsed_myst(path)
    definition, table = _definition(path, "\n".join(lines), dict(parsed.metadata))
    cells = read_cells(parsed, lines, file=path.name)
    source = Source(path=path, definition=definition, table=table, cells=cells)
    require_sound(cells, definition, file=path.name, lines=lines)
    return source


def _definition(
    path: Path, text: str, metadata: dict[str, Any]
) -> tuple[Definition, dict[str, Any]]:
    metadata.pop("source_map", None)
    for key in metadata:
        if key not in (*FRONT_MATTER_KEYS, "jupyter"):
            raise SourceError(
                f"unknown key `{key}` in the front matter", file=path.name, line=_line(text, key)
            )
    table = metadata.get("workbook")
    try:
        definition = require_definition(table)
    except ValueError as error:
        named = re.findall(r"`(\w+)", str(error))
        key = next((word for word in named if f"\n  {word}:" in text), "workbook")
        raise SourceError(str(error), file=path.name, line=_line(text, key)) from error
    slug = SLUG_PATTERN.fullmatch(path.stem)
    key = exercise_key(definition.id)
    if slug is None or not path.stem.startswith(f"{key}_"):
        raise SourceError(
            f"exercise {definition.id} belongs in a file {key}_<words_in_small_letters>.md",
            file=path.name,
            line=_line(text, "id"),
        )
    assert isinstance(table, dict)
    return definition, _plain(table)


def _line(text: str, key: str) -> int:
    """The line (from 1) that begins with a key; 1 if none does."""
    for number, line in enumerate(text.split("\n"), 1):
        if line.strip().startswith(key):
            return number
    return 1


def _plain(value: Any) -> Any:
    """The same value of plain dicts and lists; the parser has its own kinds of these."""
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in value.items()}
    return [_plain(item) for item in value] if isinstance(value, list) else value
