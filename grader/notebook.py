"""`check("3.1")` in an exercise notebook: the public checks, by the same code that grades."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from grader.errors import GraderError, SubmissionError
from grader.exercises import Exercise, find_root, get_exercise
from grader.last_checks import remember
from grader.report.html import exercise_html, message_html
from grader.report.text import exercise_text
from grader.results import ExerciseResult, Status
from grader.run import grade_submission
from grader.sandbox import find_sandbox
from grader.submission import Submission, submission_from_folder, submission_from_notebook
from simkit.errors import SimkitError

SAVE = "save the notebook (Ctrl+S) before you hand it in, or run the cell again"


@dataclass(frozen=True, slots=True, kw_only=True)
class CheckReport:
    """What `check` returns: shown as cards in a notebook, as lines elsewhere."""

    result: ExerciseResult | None
    """The results of the public checks; None if they could not run."""
    title: str = ""
    """Title of the exercise."""
    problem: str = ""
    """Why they could not run."""

    @property
    def passed(self) -> bool:
        """Whether every public check passed."""
        return self.result is not None and self.result.status is Status.PASSED

    def _repr_html_(self) -> str:
        if self.result is None:
            return message_html(self.problem)
        return exercise_html(self.result, title=self.title, hidden_to_come=True)

    def __repr__(self) -> str:
        """The lines for a terminal."""
        if self.result is None:
            return self.problem
        return exercise_text(self.result, title=self.title, hidden_to_come=True)


def check(exercise_id: str, *, answers: Mapping[str, object] | None = None) -> CheckReport:
    """Run the public checks of an exercise on the files of the working folder.

    Args:
        exercise_id: E.g. "3.1".
        answers: Values by name; those of the notebook's own variables if None.
    """
    try:
        folder = Path.cwd()
        exercise = get_exercise(find_root(folder), str(exercise_id))
        known = answers if answers is not None else _variables()
        return check_folder(folder, exercise, known)
    except (GraderError, SimkitError) as error:
        return CheckReport(result=None, problem=str(error))


def check_folder(
    folder: Path, exercise: Exercise, answers: Mapping[str, object] | None
) -> CheckReport:
    """Run the public checks of an exercise on the files of a folder.

    Args:
        folder: Where the student works: the folder with the package, or the workbook's own.
        exercise: What is asked for.
        answers: Values by name; those of the saved notebook if None.
    """
    root = find_root(folder)
    work = folder if (folder / exercise.package).is_dir() else root / "work"
    saved = _saved(work, exercise)
    if answers is None:
        answers = saved.answers if saved is not None else {}
    submission = submission_from_folder(work, exercise, answers)
    stale = _stale(submission, saved, exercise)
    submission = replace(submission, notes=(*submission.notes, *stale))
    sandbox = find_sandbox(private=(root,))
    result = grade_submission(submission, exercise, hidden=False, sandbox=sandbox)
    remember(work, result)
    return CheckReport(result=result, title=exercise.title)


def _variables() -> Mapping[str, Any]:
    """The variables of the notebook that calls; none outside of one."""
    # Nobody is in IPython who has not imported it.
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return dict(shell.user_ns) if shell is not None else {}


def _saved(folder: Path, exercise: Exercise) -> Submission | None:
    """What would be handed in if the notebook of the folder were: as it was saved last."""
    try:
        return submission_from_notebook(folder / f"{exercise.slug}.ipynb", exercise)
    except SubmissionError:
        return None


def _stale(submission: Submission, saved: Submission | None, exercise: Exercise) -> list[str]:
    """A note if the saved notebook holds other work than what was just checked."""
    if saved is None:
        return []
    different = [
        path
        for path in exercise.files
        if saved.files.get(path, "").split() != submission.files.get(path, "").split()
    ]
    different += [
        name for name in exercise.answers if saved.answers.get(name) != submission.answers.get(name)
    ]
    if not different:
        return []
    return [f"In the saved notebook, {', '.join(different)} is not what was checked here: {SAVE}."]
