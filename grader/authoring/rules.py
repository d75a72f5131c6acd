"""What must hold between the cells of a source and its definition."""

from __future__ import annotations

import ast
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Sequence

from grader.authoring.regions import RegionError
from grader.authoring.source_cells import SourceCell
from grader.errors import SourceError
from grader.exercises import Definition
from grader.submission.paths import place

XML_ENDINGS = (".xml", ".urdf", ".xacro", ".launch", ".world", ".sdf")
"""Files whose student version must be well-formed."""
_DIRECTIVE = re.compile(r"^(?:`{3,}|:{3,})\{", re.MULTILINE)

Fault = Callable[[str, int], SourceError]
"""Makes the error of a fault and its line."""


def require_sound(
    cells: Sequence[SourceCell], definition: Definition, *, file: str, lines: Sequence[str]
) -> None:
    """Hold the cells of a source to the rules.

    Args:
        cells: All cells.
        definition: What the front matter says.
        file: Name of the source.
        lines: Its lines.

    Raises:
        SourceError: The first rule that is broken.
    """

    def fault(text: str, line: int) -> SourceError:
        return SourceError(text, file=file, line=line)

    def line_of(word: str) -> int:
        return next((n for n, line in enumerate(lines, 1) if word in line), 1)

    for cell in cells:
        _require_tags_fit(cell, fault)
        _require_plain_markdown(cell, fault)
        _require_known_place(cell, definition, fault)
        _require_student_version(cell, fault)
    _require_labels_differ(cells, fault)
    for path in definition.files:
        _require_deliverable(path, cells, fault, line_of(path))
    _require_answers(cells, definition, fault, line_of("answers"))


def _require_tags_fit(cell: SourceCell, fault: Fault) -> None:
    if "answer" in cell.tags and (cell.kind != "code" or cell.written is not None):
        raise fault("the tag `answer` is for code cells that assign answers", cell.line)
    if "solution" in cell.tags and (cell.regions or len(cell.tags) > 1):
        raise fault(
            "a cell tagged `solution` is removed whole; no regions or other tags", cell.line
        )
    if cell.kind == "markdown" and cell.regions:
        raise fault("regions are for code cells; tag the cell `solution` instead", cell.line)


def _require_plain_markdown(cell: SourceCell, fault: Fault) -> None:
    if cell.kind != "markdown":
        return
    if found := _DIRECTIVE.search(cell.text):
        line = cell.line + cell.text[: found.start()].count("\n")
        raise fault("Jupyter does not render MyST directives; use plain Markdown", line)


def _require_known_place(cell: SourceCell, definition: Definition, fault: Fault) -> None:
    written = cell.written
    if written is None:
        return
    if written.notes:
        raise fault(written.notes[0], cell.line)
    placed = place(written.path, packages=definition.packages, wanted=definition.files)
    if placed.note or placed.path != written.path:
        raise fault(placed.note or f"write the path as {placed.path}", cell.line)


def _require_student_version(cell: SourceCell, fault: Fault) -> None:
    try:
        text = cell.for_students()
    except RegionError as error:
        raise fault(str(error), cell.line + error.line - 1) from error
    written = cell.written
    if written is None or written.append or not written.path.endswith(XML_ENDINGS):
        return
    versions = {"the solution's": cell.for_solution()}
    if all(region.instead is None for region in cell.regions):
        versions["the student's"] = text  # a file to mend may be anything
    for which, version in versions.items():
        try:
            ElementTree.fromstring(version.partition("\n")[2].strip())
        except ElementTree.ParseError as error:
            raise fault(f"{which} version is not well-formed XML: {error}", cell.line) from error


def _require_labels_differ(cells: Sequence[SourceCell], fault: Fault) -> None:
    seen: set[str] = set()
    for cell in cells:
        if cell.label in seen:
            raise fault(f"the label `{cell.label}` occurs twice", cell.line)
        seen |= {cell.label} if cell.label is not None else set()


def _require_deliverable(path: str, cells: Sequence[SourceCell], fault: Fault, line: int) -> None:
    writers = [cell for cell in cells if cell.written is not None and cell.written.path == path]
    if not writers:
        raise fault(f"no cell begins with `%%writefile {path}`", line)
    if any("solution" in cell.tags for cell in writers):
        raise fault(f"the cell of {path} must stay for students; mark a region in it", line)
    if not any(cell.regions for cell in writers):
        raise fault(f"{path} has no region: nothing is left for the student to do", line)


def _require_answers(
    cells: Sequence[SourceCell], definition: Definition, fault: Fault, line: int
) -> None:
    given: set[str] = set()
    for cell in cells:
        if "answer" in cell.tags:
            given |= _names_in_regions(cell, fault)
    if missing := [name for name in definition.answers if name not in given]:
        raise fault(f"no region of a cell tagged `answer` assigns `{missing[0]}`", line)
    if extra := sorted(given - set(definition.answers)):
        raise fault(f"`{extra[0]}` is assigned as an answer, but not in `answers`", line)


def _names_in_regions(cell: SourceCell, fault: Fault) -> set[str]:
    names: set[str] = set()
    for region in cell.regions:
        for offset, text in enumerate(region.body, region.start + 1):
            if text.strip() and not text.lstrip().startswith("#"):
                names.add(_answer_name(text, cell.line + offset, fault))
    outside = set(range(len(cell.text.split("\n")))) - {
        index for region in cell.regions for index in range(region.start, region.stop + 1)
    }
    for index in sorted(outside):
        text = cell.text.split("\n")[index]
        if text.strip() and not text.lstrip().startswith("#"):
            raise fault("an answer cell holds regions and comments only", cell.line + index)
    return names


def _answer_name(text: str, line: int, fault: Fault) -> str:
    """The name in `name = literal`."""
    try:
        statement = ast.parse(text.strip()).body[0]
        if isinstance(statement, ast.Assign) and isinstance(statement.targets[0], ast.Name):
            ast.literal_eval(statement.value)
            return statement.targets[0].id
    except (SyntaxError, ValueError):
        pass
    raise fault("an answer is one line `name = literal`", line)
