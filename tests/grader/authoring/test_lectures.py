from __future__ import annotations

import json
from typing import Any

import nbformat
import pytest

from grader.authoring.build import build, check
from grader.authoring.lectures import fresh_lectures
from grader.errors import SourceError

LECTURE = """\
---
jupytext:
  text_representation:
    extension: .md
    format_name: myst
---

# Lecture

Some text.

```{code-cell} ipython3
print("hello")
```

+++ {"tags": ["hint"]}

The answer.
"""
SOURCE = "lectures/3_1_transforms.md"
NOTEBOOK = "lectures/3_1_transforms.ipynb"


def test_a_lecture_becomes_one_notebook(workbook: Any) -> None:
    workbook.write(SOURCE, LECTURE)
    assert workbook.root / NOTEBOOK in workbook.build()
    assert workbook.build() == []
    notebook = nbformat.read(workbook.root / NOTEBOOK, as_version=nbformat.NO_CONVERT)
    nbformat.validate(notebook)
    assert [cell.cell_type for cell in notebook.cells] == ["markdown", "code", "markdown"]
    assert "<details>" in notebook.cells[2].source
    assert set(notebook.metadata) == {"kernelspec", "language_info"}


def test_its_cells_are_told_from_those_of_exercises(workbook: Any) -> None:
    workbook.write(SOURCE, LECTURE)
    workbook.build()
    ids = [
        {cell["id"] for cell in json.loads(workbook.read(name))["cells"]}
        for name in (NOTEBOOK, workbook.student)
    ]
    assert not ids[0] & ids[1]


def test_stale_and_foreign_notebooks_are_named(workbook: Any) -> None:
    workbook.write(SOURCE, LECTURE)
    build(workbook.root)
    workbook.edit(SOURCE, "Some text", "Other text")
    workbook.write("lectures/3_2_more.ipynb", "{}")
    assert check(workbook.root) == [
        f"{NOTEBOOK} is stale; run `grader build`",
        "lectures/3_2_more.ipynb has no source lectures/3_2_more.md; delete it",
    ]
    assert [str(finding) for finding in fresh_lectures(workbook.root)] == [
        f"{NOTEBOOK}: is stale; run `grader build`"
    ]


@pytest.mark.parametrize(
    ("cell", "what"),
    [
        ("# solution: say it\nprint(1)\n# end solution", "a region of a solution"),
        (":tags: [answer]\n\n# nothing", "a cell tagged `answer`"),
        ("%%writefile hello_ros/scripts/talker.py\nprint(1)", "a cell that writes"),
    ],
)
def test_what_belongs_into_an_exercise_is_refused(workbook: Any, cell: str, what: str) -> None:
    workbook.write(SOURCE, LECTURE.replace('print("hello")', cell))
    with pytest.raises(SourceError, match=what):
        build(workbook.root)
    assert what in next(fresh_lectures(workbook.root)).what
