"""The honest slips that other graders punish: a right notebook stays right.

Those that matter only when a notebook is run (quitting, asking for input, printing, hanging) are
here too, since not running it is what answers them.
"""

from __future__ import annotations

from typing import Any

import pytest

from grader.exercises import Exercise
from grader.submission import Submission, submission_from_notebook


def read(path: Any, exercise: Exercise) -> Submission:
    return submission_from_notebook(path, exercise)


def require_right(make: Any, found: Submission) -> None:
    assert found.files == {make.path: make.solved}
    assert found.answers == {"fixed_frame": "world", "distance": 2.0}


@pytest.mark.parametrize(
    "source",
    [
        "import warnings\nwarnings.warn('careful')",
        "import sys\nprint('note', file=sys.stderr)",
        "while True: pass",
        "import os\nos._exit(1)",
        "import numpy as np\nnp = None",
        "quit()",
        "input('name? ')",
        "raise RuntimeError('my own cell')",
        "%matplotlib widget",
        "!pip --version",
        "%run other.py",
        "%%bash\nexit 1",
        "def f(:",
    ],
)
def test_other_cells_are_not_run_and_do_no_harm(make: Any, exercise: Exercise, source: str) -> None:
    path = make.save(make.cell(source), make.writes(), make.cell(source), make.answer())
    found = read(path, exercise)
    require_right(make, found)
    assert found.notes == ()


def test_a_deleted_check_cell(make: Any, exercise: Exercise) -> None:
    require_right(make, read(make.save(make.writes(), make.answer()), exercise))


def test_a_copied_answer_cell_and_duplicate_ids(make: Any, exercise: Exercise) -> None:
    twice = [make.answer() | {"id": "one"}, make.answer() | {"id": "one"}]
    found = read(make.save(make.writes(), *twice), exercise)
    require_right(make, found)
    assert found.notes == ("Some cells share one id (copied cells do); each was read.",)


def test_a_copied_file_cell(make: Any, exercise: Exercise) -> None:
    found = read(make.save(make.writes(), make.writes(), make.answer()), exercise)
    require_right(make, found)
    assert "Two cells write" in found.notes[0]


@pytest.mark.parametrize("kind", ["markdown", "raw"])
def test_a_changed_type_of_cell(make: Any, exercise: Exercise, kind: str) -> None:
    path = make.save(make.writes(kind=kind), make.answer(kind=kind))
    found = read(path, exercise)
    require_right(make, found)
    assert f"is a {kind} cell; it was read all the same" in found.notes[0]
    assert f"is a {kind} cell; its answers were read" in found.notes[1]


def test_removed_ids(make: Any, exercise: Exercise) -> None:
    found = read(make.save(make.writes(id=None), make.answer() | {"id": None}), exercise)
    require_right(make, found)
    assert found.notes == ("Some cells have no id; they were read all the same.",)


def test_answers_retyped_in_a_new_cell(make: Any, exercise: Exercise) -> None:
    found = read(make.save(make.cell(make.answers), make.writes()), exercise)
    require_right(make, found)
    assert found.notes == ("Cell 1 is not the answer cell, but its answers were read.",)


def test_a_renamed_kernel(make: Any, exercise: Exercise) -> None:
    metadata = {"kernelspec": {"name": "robots-env"}, "language_info": {"name": "julia"}}
    found = read(make.save(make.writes(), make.answer(), metadata=metadata), exercise)
    require_right(make, found)
    assert "'robots-env'; grading does not use it" in found.notes[0]


def test_the_metadata_of_another_exercise_does_not_matter_here(
    make: Any, exercise: Exercise
) -> None:
    forged = {"workbook": {"id": "9.9", "points": 1000, "files": []}}
    require_right(make, read(make.save(make.writes(), make.answer(), metadata=forged), exercise))


def test_a_comment_above_the_magic(make: Any, exercise: Exercise) -> None:
    source = f"# my node\n%%writefile {make.path}\n{make.solved}"
    found = read(make.save(make.cell(source), make.answer()), exercise)
    require_right(make, found)
    assert "must be the first line of its cell" in found.notes[0]
