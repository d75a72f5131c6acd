from __future__ import annotations

import json
import warnings
from pathlib import Path
from typing import Any

import nbformat
import pytest

from grader.authoring.build import build, check
from grader.errors import SourceError
from grader.exercises import get_exercise
from grader.submission import submission_from_notebook


def cells(workbook: Any, name: str) -> list[dict[str, Any]]:
    made: list[dict[str, Any]] = json.loads(workbook.read(name))["cells"]
    return made


def text_of(cell: dict[str, Any]) -> str:
    return "".join(cell["source"])


def test_both_notebooks_are_built_once(workbook: Any) -> None:
    assert workbook.build() == [
        workbook.root / workbook.student,
        workbook.root / workbook.solution,
    ]
    assert workbook.build() == []


def test_the_bytes_are_the_same_anywhere(workbook: Any, tmp_path: Path) -> None:
    workbook.build()
    other = type(workbook)(tmp_path / "elsewhere")
    other.build()
    for name in (workbook.student, workbook.solution):
        data = (workbook.root / name).read_bytes()
        assert data == (other.root / name).read_bytes()
        assert data.endswith(b"}\n")
        assert b"\r" not in data


def test_the_notebooks_are_valid_and_clean(workbook: Any) -> None:
    workbook.build()
    for name in (workbook.student, workbook.solution):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            notebook = nbformat.read(workbook.root / name, as_version=nbformat.NO_CONVERT)
            nbformat.validate(notebook)
        assert (notebook.nbformat, notebook.nbformat_minor) == (4, 5)
        assert set(notebook.metadata) == {"kernelspec", "language_info", "workbook"}
        assert notebook.metadata.workbook.id == "3.1"
        for cell in notebook.cells:
            assert not cell.get("outputs")
            assert cell.get("execution_count") is None
        ids = [cell.id for cell in notebook.cells]
        assert len(set(ids)) == len(ids)


def test_what_students_get(workbook: Any) -> None:
    workbook.build()
    texts = [text_of(cell) for cell in cells(workbook, workbook.student)]
    assert "    # TODO: say the word\n    pass\n" in texts[1]
    assert "  <!-- TODO: start the talker -->\n</launch>" in texts[2]
    assert texts[3] == ("<details>\n<summary>Hint</summary>\n\nLook at `print`.\n\n</details>")
    assert texts[5] == (
        "# Two answers.\n# TODO: the frame, and how far [m]\nfixed_frame = ...\ndistance = ..."
    )
    assert not any("explanation" in text or "right_word" in text for text in texts)
    assert not any("end solution" in text for text in texts)


def test_what_the_solution_holds(workbook: Any) -> None:
    workbook.build()
    texts = [text_of(cell) for cell in cells(workbook, workbook.solution)]
    assert 'word = "the right word"' in texts[1]
    assert 'fixed_frame = "world"' in texts[5]
    assert "an explanation for teachers" in texts[6]
    assert not any("# solution" in text or "end solution" in text for text in texts)


def test_the_grader_reads_what_was_built(workbook: Any) -> None:
    workbook.build()
    exercise = get_exercise(workbook.root, "3.1")
    assert list(exercise.stub_files) == list(exercise.files)
    stub = submission_from_notebook(workbook.root / workbook.student, exercise)
    assert (stub.attempted(exercise), stub.notes) == (False, ())
    solution = submission_from_notebook(workbook.root / workbook.solution, exercise)
    assert solution.answers == {"fixed_frame": "world", "distance": 2.0}
    assert solution.notes == ()


def test_a_cell_keeps_its_id_when_others_come_and_go(workbook: Any) -> None:
    workbook.build()
    before = {text_of(cell): cell["id"] for cell in cells(workbook, workbook.student)}
    solution = {cell["id"] for cell in cells(workbook, workbook.solution)}
    assert set(before.values()) <= solution
    workbook.edit(workbook.source, "+++ {", '```{code-cell}\nprint("new")\n```\n\n+++ {')
    workbook.edit(
        workbook.source,
        "```{code-cell}\n:tags: [solution]",
        "More.\n\n```{code-cell}\n:tags: [solution]",
    )
    workbook.build()
    after = {text_of(cell): cell["id"] for cell in cells(workbook, workbook.student)}
    assert all(after[text] == cell_id for text, cell_id in before.items())


def test_ids_differ_between_exercises(workbook: Any) -> None:
    text = workbook.read(workbook.source).replace("3.1", "3.2")
    workbook.write("solutions/3_02_say_more.md", text)
    workbook.build()
    one = {cell["id"] for cell in cells(workbook, workbook.student)}
    two = {cell["id"] for cell in cells(workbook, "exercises/3_02_say_more.ipynb")}
    assert not one & two


def test_stale_missing_and_orphaned_notebooks_are_told(workbook: Any) -> None:
    assert check(workbook.root) == [
        "exercises/3_01_say_it.ipynb is missing; run `grader build`",
        "solutions/3_01_say_it.ipynb is missing; run `grader build`",
    ]
    workbook.build()
    assert check(workbook.root) == []
    workbook.edit(workbook.student, "Some text", "Some other text")
    workbook.write("exercises/3_09_old.ipynb", "{}")
    assert check(workbook.root) == [
        "exercises/3_01_say_it.ipynb is stale; run `grader build`",
        "exercises/3_09_old.ipynb has no source solutions/3_09_old.md; delete it",
    ]


def test_nothing_is_written_when_a_source_has_a_fault(workbook: Any) -> None:
    workbook.write("solutions/3_02_broken.md", "# Nothing\n")
    with pytest.raises(SourceError, match="3_02_broken"):
        build(workbook.root)
    assert not (workbook.root / workbook.student).exists()


def test_two_sources_of_one_exercise_are_refused(workbook: Any) -> None:
    workbook.write("solutions/3_01_twin.md", workbook.read(workbook.source))
    with pytest.raises(SourceError, match=r"3_01_say_it\.md is exercise 3\.1 too"):
        build(workbook.root)
