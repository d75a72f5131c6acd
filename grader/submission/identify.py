"""Which exercise a notebook belongs to: what it says, else its name, else the files it writes."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

from grader.submission.notebook import Notebook
from grader.submission.paths import place
from grader.submission.writefile import written_file

if TYPE_CHECKING:
    from grader.exercises import Exercise


def exercise_of(
    notebook: Notebook, exercises: Mapping[str, Exercise], *, name: str
) -> Exercise | None:
    """The exercise that a notebook is a hand-in for; None if nothing tells.

    Args:
        notebook: What was read.
        exercises: The known ones by id.
        name: Its file name, without what a learning management system put before it.
    """
    claimed = exercises.get(notebook.exercise_id or "")
    return claimed or exercise_by_name(name, exercises) or _exercise_by_files(notebook, exercises)


def exercise_by_name(name: str, exercises: Mapping[str, Exercise]) -> Exercise | None:
    """The exercise whose number a file name holds, as in `3_01_x.ipynb`, `ex 3.1.ipynb`."""
    for exercise in exercises.values():
        chapter, number = exercise.id.split(".")
        # "3_1" must not be found in "3_10" or in "13_1".
        pattern = rf"(?<![0-9A-Za-z]){chapter}[ _.-]0?{number}(?![0-9])"
        if re.search(pattern, name, re.IGNORECASE):
            return exercise
    return None


def _exercise_by_files(notebook: Notebook, exercises: Mapping[str, Exercise]) -> Exercise | None:
    written = [found.path for cell in notebook.cells if (found := written_file(cell.source))]
    best, most = None, 0
    for exercise in exercises.values():
        placed = {
            place(path, packages=exercise.packages, wanted=exercise.files).path for path in written
        }
        count = len(placed & set(exercise.files))
        if count > most:
            best, most = exercise, count
    return best
