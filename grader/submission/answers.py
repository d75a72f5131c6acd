"""Short answers: `name = literal` in the cells of a notebook, read by the parser, never run."""

from __future__ import annotations

import ast
import math
import warnings
from collections.abc import Collection
from dataclasses import dataclass, field

from grader.errors import GraderError
from grader.submission.notebook import Cell, Notebook
from grader.submission.writefile import written_file
from simkit.errors import near_names

MAX_ANSWER_CELL = 20_000
"""Longest cell that is searched for answers [characters]."""
MAX_ANSWER_TEXT = 400_000
"""So much of a notebook is searched for answers [characters]."""
MAX_ANSWER_DEPTH = 20
"""Deepest nesting of an answer's lists and tables."""


@dataclass(slots=True, kw_only=True)
class CollectedAnswers:
    """What was found so far."""

    answers: dict[str, object] = field(default_factory=dict)
    """Name -> value in JSON's types (tuples and sets come as lists)."""
    notes: list[str] = field(default_factory=list)


class NotAnAnswerError(GraderError):
    """The value of an answer is not one that is read; the text says what to write."""


def collect_answers(notebook: Notebook, names: Collection[str]) -> CollectedAnswers:
    """The answers that a notebook gives; later ones win, `...` and `None` give none.

    Cells tagged `answer` count, whatever their type; so do untagged code cells that assign
    nothing but expected names (an answer retyped in a new cell).

    Args:
        notebook: What was handed in.
        names: The names that the exercise asks for.
    """
    found = CollectedAnswers()
    left = MAX_ANSWER_TEXT
    for cell in notebook.cells:
        # The cheap look first: most cells are not worth parsing.
        if "answer" not in cell.tags and not any(name in cell.source for name in names):
            continue
        left -= len(cell.source) if len(cell.source) <= MAX_ANSWER_CELL else 0
        if left < 0:
            found.notes.append("The notebook is too long; only its beginning was searched.")
            break
        if "answer" in cell.tags and names:
            _read_answer_cell(cell, names, found)
        elif cell.kind == "code" and _assigns_only(cell.source, names):
            found.notes.append(
                f"Cell {cell.number} is not the answer cell, but its answers were read."
            )
            _read_answer_cell(cell, names, found)
    return found


def _read_answer_cell(cell: Cell, names: Collection[str], found: CollectedAnswers) -> None:
    if cell.kind != "code":
        found.notes.append(
            f"The answer cell (number {cell.number}) is a {cell.kind[:20]} cell; its answers were"
            " read all the same."
        )
    if len(cell.source) > MAX_ANSWER_CELL:
        found.notes.append(f"Cell {cell.number} is too long for answers and was not read.")
        return
    for statement in _statements(cell, found):
        _read_statement(statement, names, found)


def _statements(cell: Cell, found: CollectedAnswers) -> list[ast.stmt]:
    """The cell's statements; if it does not parse, those of its lines that do."""
    tree = _parse(cell.source)
    if tree is not None:
        return tree
    statements: list[ast.stmt] = []
    for line in cell.source.split("\n"):
        parsed = _parse(line.strip())
        if parsed is None:
            found.notes.append(
                f"In cell {cell.number} the line {line.strip()[:80]!r} is not Python;"
                " the other lines were read."
            )
        statements += parsed or []
    return statements


def _parse(text: str) -> list[ast.stmt] | None:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # e.g. about "\\d"; not ours to print
            return ast.parse(text).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def _targets(statement: ast.stmt) -> tuple[list[str], ast.expr] | None:
    """Names and value of `a = value`, `a = b = value` or `a: type = value`."""
    if isinstance(statement, ast.Assign):
        targets, value = statement.targets, statement.value
    elif isinstance(statement, ast.AnnAssign) and statement.value is not None:
        targets, value = [statement.target], statement.value
    else:
        return None
    names = [target.id for target in targets if isinstance(target, ast.Name)]
    return (names, value) if len(names) == len(targets) else None


def _assigns_only(source: str, names: Collection[str]) -> bool:
    if len(source) > MAX_ANSWER_CELL or written_file(source) is not None:
        return False
    found = [_targets(statement) for statement in _parse(source) or []]
    return bool(found) and all(pair is not None and set(pair[0]) <= set(names) for pair in found)


def _read_statement(statement: ast.stmt, names: Collection[str], found: CollectedAnswers) -> None:
    pair = _targets(statement)
    if pair is None:
        return
    targets, value = pair
    for name in targets:
        if name not in names:
            found.notes += _misspelt(name, names)
            continue
        _store(name, value, found)


def _misspelt(name: str, names: Collection[str]) -> list[str]:
    near = near_names(name, names, limit=1)
    return [f"No answer is called {name[:60]}; did you mean {near[0]}?"] if near else []


def _store(name: str, value: ast.expr, found: CollectedAnswers) -> None:
    try:
        answer = plain_answer(_literal(value))
    except NotAnAnswerError as error:
        found.notes.append(f"The answer {name} was not read: {error}.")
        return
    if answer is None:
        return
    if name in found.answers and found.answers[name] != answer:
        found.notes.append(f"{name} is answered twice; the later answer was taken.")
    found.answers[name] = answer


def _literal(value: ast.expr) -> object:
    if isinstance(value, ast.Name):
        raise NotAnAnswerError(f'put text in quotes: "{value.id[:60]}"')
    try:
        return ast.literal_eval(value)
    except (ValueError, TypeError, SyntaxError, RecursionError, MemoryError) as error:
        raise NotAnAnswerError(
            "write the value itself (a number, or a text in quotes), not something to compute"
        ) from error


def plain_answer(value: object, depth: int = 0) -> object:
    """An answer in JSON's types; None for `...`, which stands for an answer not yet given.

    Raises:
        NotAnAnswerError: The value, or a part of it, has no such form.
    """
    if value is Ellipsis or value is None or isinstance(value, bool):
        return None if value is Ellipsis else value
    if isinstance(value, str):
        return value.encode("utf-8", "replace").decode("utf-8")
    if isinstance(value, int) and abs(value) < 10**30:
        return value
    if isinstance(value, float) and math.isfinite(value):
        return value
    if depth < MAX_ANSWER_DEPTH:
        if isinstance(value, set):
            value = sorted(value, key=repr)
        if isinstance(value, list | tuple):
            return [plain_answer(item, depth + 1) for item in value]
        if isinstance(value, dict) and all(isinstance(key, str) for key in value):
            return {plain_answer(key): plain_answer(item, depth + 1) for key, item in value.items()}
    raise NotAnAnswerError("a number, a text in quotes, True, False, or a list of these is meant")
