"""The cells of a source, with the line of the source that each begins at."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from grader.authoring.regions import (
    Region,
    RegionError,
    find_regions,
    is_notebook_python,
    is_python,
    solution_text,
    student_text,
)
from grader.errors import SourceError
from grader.submission.writefile import WrittenFile, written_file
from simkit.errors import near_names

TAGS = ("answer", "hint", "solution")
"""The tags of a cell that mean something."""
OPTIONS = ("tags", "label")
"""What may stand in the head of a cell."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SourceCell:
    """One cell of a source."""

    kind: str
    """"code" or "markdown"."""
    text: str
    """With its marks of regions."""
    line: int
    """Line of the source of its first line, from 1."""
    tags: tuple[str, ...]
    label: str | None
    regions: tuple[Region, ...]

    @property
    def written(self) -> WrittenFile | None:
        """The file that the cell writes, if it is a `%%writefile` cell."""
        return written_file(self.text) if self.kind == "code" else None

    def region_lines(self) -> frozenset[int]:
        """Indices of the lines that only the solution has, marks left out."""
        return frozenset(
            index for region in self.regions for index in range(region.start + 1, region.body_stop)
        )

    def for_solution(self) -> str:
        """Its text in the solution."""
        return solution_text(self.text)

    def for_students(self) -> str:
        """Its text in the student's notebook.

        Raises:
            RegionError: It would not be valid Python.
        """
        if "answer" in self.tags:
            return _open_answers(self)
        written = self.written
        if self.kind != "code" or not self.regions:
            return self.text
        if written is None:
            return student_text(self.text, is_valid=is_notebook_python)
        if not written.path.endswith(".py"):
            return student_text(self.text)
        return student_text(self.text, is_valid=_is_python_file)


def _is_python_file(cell: str) -> bool:
    """Whether the file that a cell writes compiles."""
    return is_python(cell.partition("\n")[2])


def _open_answers(cell: SourceCell) -> str:
    """An answer cell with `...` for each answer in a region."""
    lines = cell.text.split("\n")
    for region in reversed(cell.regions):
        names = [line.split("=")[0].strip() for line in region.body if "=" in line]
        lines[region.start : region.stop + 1] = [region.todo(), *(f"{n} = ..." for n in names)]
    return "\n".join(lines)


def read_cells(parsed: Any, lines: list[str], *, file: str) -> tuple[SourceCell, ...]:
    """The cells that jupytext found, as ours.

    Args:
        parsed: The notebook of jupytext, with its map of lines.
        lines: The lines of the source.
        file: Its name, for errors.

    Raises:
        SourceError: A cell has an unknown tag or option, or a broken region.
    """
    starts = parsed.metadata["source_map"]
    return tuple(
        _cell(raw, start, lines, file=file) for raw, start in zip(parsed.cells, starts, strict=True)
    )


def _cell(raw: Any, start: int, lines: list[str], *, file: str) -> SourceCell:
    line = _first_line(raw.source, start, lines)
    tags, label = _options(dict(raw.metadata), file=file, line=start + 1)
    if raw.cell_type not in ("code", "markdown"):
        raise SourceError(f"a {raw.cell_type} cell has no use here", file=file, line=line)
    try:
        regions = find_regions(raw.source)
    except RegionError as error:
        raise SourceError(str(error), file=file, line=line + error.line - 1) from error
    return SourceCell(
        kind=raw.cell_type,
        text=raw.source,
        line=line,
        tags=tags,
        label=label,
        regions=tuple(regions),
    )


def _first_line(text: str, start: int, lines: list[str]) -> int:
    """Line (from 1) of the first line of a cell, which lies below its head."""
    wanted = text.split("\n")
    for index in range(max(start - 1, 0), len(lines)):
        if lines[index : index + len(wanted)] == wanted:
            return index + 1
    return start + 1


def _options(
    options: dict[str, Any], *, file: str, line: int
) -> tuple[tuple[str, ...], str | None]:
    if unknown := sorted(set(options) - set(OPTIONS)):
        raise SourceError(
            f"unknown option `{unknown[0]}` of a cell; options: {', '.join(OPTIONS)}",
            file=file,
            line=line,
        )
    tags, label = options.get("tags", []), options.get("label")
    for tag in tags if isinstance(tags, list) else [tags]:
        if tag not in TAGS:
            near = near_names(str(tag), TAGS, limit=1)
            ask = f"; did you mean `{near[0]}`?" if near else ""
            raise SourceError(
                f"unknown tag `{tag}`{ask} tags: {', '.join(TAGS)}", file=file, line=line
            )
    if label is not None and not isinstance(label, str):
        raise SourceError(f"the label {label!r} is not a text", file=file, line=line)
    return tuple(tags), label
