"""One file that was found below a path of the command line, and what it was read as."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from grader.errors import SubmissionError
from grader.submission.archive import Item
from grader.submission.identify import exercise_by_name, exercise_of
from grader.submission.labels import label
from grader.submission.lms import lms_name
from grader.submission.notebook import notebook_from_bytes
from grader.submission.submission import Submission, submission_of

if TYPE_CHECKING:
    from grader.exercises import Exercise


@dataclass(frozen=True, slots=True, kw_only=True)
class FoundFile:
    """A notebook with its exercise, a file with its problem, or a folder."""

    parts: tuple[str, ...]
    """Folders and name below the path of the command line."""
    own_name: str
    """What the student called the file."""
    exercise: Exercise | None = None
    submission: Submission | None = None
    problem: str = ""
    """What is wrong with the file, as a sentence without its full stop."""
    is_folder: bool = False

    @property
    def name(self) -> str:
        """Folders and name for a sentence; clean and short."""
        return label("/".join(self.parts) or self.own_name)


def read_item(item: Item, exercises: Mapping[str, Exercise], *, path_name: str) -> FoundFile:
    """What a file is, of which exercise, and what is in it.

    Args:
        item: The file.
        exercises: The known ones by id.
        path_name: Name of the path of the command line, for an item that is that path itself.
    """
    name = item.parts[-1] if item.parts else path_name
    lms = lms_name(name)
    own = (lms.rest or name) if lms else name
    if item.data is None:
        is_notebook = own.lower().endswith(".ipynb") and not item.is_folder
        return FoundFile(
            parts=item.parts,
            own_name=own,
            exercise=exercise_by_name(own, exercises) if is_notebook else None,
            problem=label(item.problem, 300) if item.problem else "",
            is_folder=item.is_folder,
        )
    return _read_notebook(item.parts, own, item.data, exercises)


def _read_notebook(
    parts: tuple[str, ...], own: str, data: bytes, exercises: Mapping[str, Exercise]
) -> FoundFile:
    try:
        notebook = notebook_from_bytes(data, name=label(own))
    except SubmissionError as error:
        exercise = exercise_by_name(own, exercises)
        return FoundFile(parts=parts, own_name=own, exercise=exercise, problem=str(error))
    exercise = exercise_of(notebook, exercises, name=own)
    if exercise is None:
        problem = f"{label(own)} belongs to no exercise that is graded here"
        return FoundFile(parts=parts, own_name=own, problem=problem)
    submission = submission_of(notebook, exercise)
    return FoundFile(parts=parts, own_name=own, exercise=exercise, submission=submission)
