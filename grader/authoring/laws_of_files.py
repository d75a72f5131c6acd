"""Laws of files: each source has its checks, its variants and fresh notebooks, and nothing else."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from grader.authoring.findings import Finding
from grader.authoring.new import FILL_IN
from grader.authoring.notebook_text import solution_notebook, student_notebook
from grader.authoring.source import Source
from grader.exercises import exercise_key

_BARE_TAG = re.compile(r"</?[\w:]+(?:\s+[\w:]+=\"[^\"]*\")?\s*/?>")
_MIN_TELLING = 12
"""Shorter lines tell nothing [letters, digits and underscores]."""


def files_of(source: Source) -> list[str]:
    """The hand-written files of an exercise, relative to the workbook."""
    key = exercise_key(source.definition.id)
    return [
        f"solutions/{source.slug}.md",
        f"exercises/test_{key}.py",
        f"solutions/test_{key}_hidden.py",
        f"solutions/variants_{key}.toml",
    ]


def complete(root: Path, source: Source) -> Iterator[Finding]:
    """Every hand-written file is there, and none waits to be filled in."""
    for name in files_of(source):
        path = root / name
        if not path.is_file():
            yield Finding(
                file=name,
                what="is missing",
                remedy=f"write it; `grader new` shows its form ({source.definition.id})",
            )
            continue
        lines = path.read_text(encoding="utf-8").split("\n")
        for number in [n for n, line in enumerate(lines, 1) if FILL_IN in line][:1]:
            yield Finding(
                file=f"{name}:{number}",
                what=f"the scaffold still says {FILL_IN}",
                remedy="write what is meant there",
            )


def fresh(root: Path, source: Source) -> Iterator[Finding]:
    """Both notebooks are what the source says."""
    built = {
        f"exercises/{source.slug}.ipynb": student_notebook(source),
        f"solutions/{source.slug}.ipynb": solution_notebook(source),
    }
    for name, text in built.items():
        path = root / name
        if not path.is_file():
            yield Finding(file=name, what="is missing", remedy="run `grader build`")
        elif path.read_bytes() != text.encode("utf-8"):
            yield Finding(file=name, what="is stale", remedy="run `grader build`")


def nothing_else(root: Path, *, slugs: Sequence[str], keys: Sequence[str]) -> Iterator[Finding]:
    """Nothing lies in the trees that belongs to no exercise.

    Args:
        root: Folder of the workbook.
        slugs: Names of the sources without ending, also of those with a fault.
        keys: What their numbers are in names of files.
    """
    known = {"exercises/README.md", "solutions/README.md"}
    known |= {path.relative_to(root).as_posix() for path in root.glob("exercises/oracles/*.py")}
    known |= {f"{tree}/{slug}.ipynb" for slug in slugs for tree in ("exercises", "solutions")}
    known |= {f"solutions/{slug}.md" for slug in slugs}
    for key in keys:
        known |= {
            f"exercises/test_{key}.py",
            f"solutions/test_{key}_hidden.py",
            f"solutions/variants_{key}.toml",
        }
    for tree in ("exercises", "solutions"):
        for path in sorted((root / tree).rglob("*")):
            inner = path.relative_to(root)
            litter = any(part == "__pycache__" or part.startswith(".") for part in inner.parts)
            if path.is_file() and not litter and inner.as_posix() not in known:
                yield Finding(
                    file=inner.as_posix(),
                    what="belongs to no exercise",
                    remedy="move it, delete it, or give it a source",
                )


def nothing_leaks(source: Source) -> Iterator[Finding]:
    """No telling line of a solution is in the student's notebook."""
    given: set[str] = set()
    for cell in source.cells:
        if "solution" not in cell.tags:
            given |= {line.strip() for line in cell.for_students().split("\n")}
    for cell in source.cells:
        for offset, line in _solution_lines(cell.text, cell.tags, cell.region_lines()):
            if line in given and is_telling(line):
                yield Finding(
                    file=f"solutions/{source.slug}.md:{cell.line + offset}",
                    what=f"the solution's line {line!r} is in the student's notebook too",
                    remedy="change or remove one of the two",
                )


def _solution_lines(
    text: str, tags: Sequence[str], in_regions: frozenset[int]
) -> Iterator[tuple[int, str]]:
    for offset, line in enumerate(text.split("\n")):
        if offset in in_regions or "solution" in tags:
            yield offset, line.strip()


def is_telling(line: str) -> bool:
    """Whether a line of a solution is more than a bracket, a keyword or a bare tag."""
    return len(re.findall(r"\w", line)) >= _MIN_TELLING and not _BARE_TAG.fullmatch(line)
