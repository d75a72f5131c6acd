"""What a student hands in for one exercise: files and answers, as data."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from grader.submission.answers import collect_answers
from grader.submission.files import collect_files, same_text
from grader.submission.notebook import Notebook, read_notebook
from simkit.errors import near_names

if TYPE_CHECKING:
    from grader.exercises import Exercise

MAX_NOTES = 100
"""Most notes of one hand-in."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Submission:
    """Files and answers of one student for one exercise."""

    student: str
    exercise_id: str
    files: dict[str, str]
    """Path relative to `work/` -> text; nothing but the exercise's packages occurs."""
    answers: dict[str, object]
    """Name -> value in JSON's types; an answer not given is not there."""
    notes: tuple[str, ...] = ()
    """Sentences for the student about how the hand-in was read."""

    def attempted(self, exercise: Exercise) -> bool:
        """Whether there is anything to grade: a deliverable that is not the stub, or an answer."""
        return bool(self.answers) or any(
            self.attempted_file(path, exercise) for path in exercise.files
        )

    def attempted_file(self, path: str, exercise: Exercise) -> bool:
        """Whether this deliverable is there and differs from the stub by more than blanks."""
        text, stub = self.files.get(path), exercise.stub_files.get(path)
        return text is not None and (stub is None or not same_text(text, stub))


def submission_from_notebook(path: Path, exercise: Exercise, *, student: str = "") -> Submission:
    """The hand-in in a notebook file.

    Args:
        path: The notebook.
        exercise: Which exercise it is graded as.
        student: Whose it is.

    Raises:
        SubmissionError: The notebook cannot be read; the message is for the student.
    """
    return submission_of(read_notebook(Path(path)), exercise, student=student)


def submission_of(notebook: Notebook, exercise: Exercise, *, student: str = "") -> Submission:
    """The hand-in in a notebook that was read."""
    files = collect_files(
        notebook,
        packages=exercise.packages,
        wanted=exercise.files,
        stubs=exercise.stub_files,
    )
    answers = collect_answers(notebook, exercise.answers)
    missing = [
        _missing_note(name, files.files) for name in exercise.files if name not in files.files
    ]
    notes = dict.fromkeys([*notebook.notes, *files.notes, *missing, *answers.notes])
    return Submission(
        student=student,
        exercise_id=exercise.id,
        files=files.files,
        answers=answers.answers,
        notes=tuple(notes)[:MAX_NOTES],
    )


def _missing_note(name: str, files: Collection[str]) -> str:
    near = [other for other in files if other.rpartition("/")[2] == name.rpartition("/")[2]]
    near += near_names(name, files, limit=1)
    if near:
        return f"No cell writes {name}, but one writes {near[0]}; did you mean the former?"
    return f"No cell writes {name}; begin a cell with `%%writefile {name}`."
