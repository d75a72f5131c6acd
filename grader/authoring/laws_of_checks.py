"""Laws of checks, read from their files without running them.

Each has a sentence and points, and each deliverable and each answer is the matter of some check.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence
from pathlib import Path, PurePosixPath

from grader.authoring.findings import Finding
from grader.exercises import Definition


def check_files_are_sound(
    root: Path, definition: Definition, *, names: Sequence[str]
) -> Iterator[Finding]:
    """What is wrong with the files of checks of an exercise.

    Args:
        root: Folder of the workbook.
        definition: What is handed in.
        names: The files, public checks first; missing ones are left out.
    """
    trees: list[ast.Module] = []
    for name in names:
        path = root / name
        if not path.is_file():
            continue
        try:
            tree = ast.parse(path.read_bytes())
        except (SyntaxError, ValueError) as error:
            yield Finding(file=name, what=f"is not Python: {error}", remedy="correct it")
            continue
        trees.append(tree)
        yield from _checks_are_sound(name, tree)
    if trees:
        yield from _nothing_is_forgotten(trees, names[0], definition)


def _checks_are_sound(name: str, tree: ast.Module) -> Iterator[Finding]:
    checks = [
        node
        for node in tree.body
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_")
    ]
    if not checks:
        yield Finding(file=name, what="has no check", remedy="write a function test_...")
    for check in checks:
        place = f"{name}:{check.lineno}"
        sentence = (ast.get_docstring(check) or "").split("\n\n")[0].strip()
        if not sentence.endswith((".", "!", "?")):
            yield Finding(
                file=place,
                what=f"{check.name} has no sentence for the student",
                remedy="give it a docstring that ends with a full stop",
            )
        if not any(_is_points(decorator) for decorator in check.decorator_list):
            yield Finding(
                file=place, what=f"{check.name} has no points", remedy="decorate it with @points(n)"
            )


def _is_points(decorator: ast.expr) -> bool:
    called = decorator.func if isinstance(decorator, ast.Call) else decorator
    return (isinstance(called, ast.Name) and called.id == "points") or (
        isinstance(called, ast.Attribute) and called.attr == "points"
    )


def _nothing_is_forgotten(
    trees: Sequence[ast.Module], name: str, definition: Definition
) -> Iterator[Finding]:
    """A deliverable is looked at where its name occurs, or where all of `exercise.files` are."""
    texts = [text for tree in trees for text in _strings(tree)]
    used = {
        node.attr
        for tree in trees
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute)
        and isinstance(node.value, ast.Name)
        and node.value.id == "exercise"
    }
    files = [] if "files" in used else [PurePosixPath(path).name for path in definition.files]
    answers = [] if "answers" in used else list(definition.answers)
    for wanted in (*files, *answers):
        if not any(wanted in text for text in texts):
            yield Finding(
                file=name,
                what=f"no check looks at {wanted}",
                remedy="write one, or take it from the front matter",
            )


def _strings(tree: ast.Module) -> Iterator[str]:
    """The texts of a file, without its docstrings."""
    docstrings = {
        id(node.body[0].value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.FunctionDef | ast.ClassDef)
        and node.body
        and isinstance(node.body[0], ast.Expr)
    }
    for node in ast.walk(tree):
        text = node.value if isinstance(node, ast.Constant) else None
        if isinstance(text, str) and id(node) not in docstrings:
            yield text
