"""Each exercise keeps the laws of a workbook: `grader build --check` and `grader verify`."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from grader.authoring import build
from grader.authoring.laws_of_files import nothing_else
from grader.authoring.source import load_source, source_paths
from grader.authoring.verify import verify
from grader.exercises import Exercise, exercise_key, load_exercises
from grader.results import ExerciseResult, Status
from grader.run import grade_submission
from grader.submission import submission_from_notebook
from tests.laws import broken_laws

JOBS = 2
SAID = "each finding says what to do"


def graded(notebook: Path, exercise: Exercise) -> ExerciseResult:
    submission = submission_from_notebook(notebook, exercise)
    assert submission.notes == ()
    return grade_submission(submission, exercise, hidden=True)


def test_there_is_an_exercise_for_each_source(root: Path) -> None:
    ids = [load_source(path).definition.id for path in source_paths(root)]
    assert ids
    apart = set(ids) ^ set(load_exercises(root))
    broken_laws(
        sorted(apart), "each source in solutions/ has its notebook in exercises/: `grader build`"
    )


def test_the_notebooks_are_as_their_sources_say(root: Path) -> None:
    broken_laws(build.check(root), "run `grader build`, and commit what it writes")


def test_nothing_else_lies_in_the_trees(root: Path) -> None:
    slugs = [path.stem for path in source_paths(root)]
    keys = [exercise_key(exercise_id) for exercise_id in load_exercises(root)]
    broken_laws(nothing_else(root, slugs=slugs, keys=keys), SAID)


def test_an_exercise_says_what_to_read_first_and_what_a_machine_with_ros_needs(
    root: Path, exercise: Exercise
) -> None:
    """In the lab the lectures lie in `lectures/`, beside the exercises."""
    text = (root / "solutions" / f"{exercise.slug}.md").read_text(encoding="utf-8")
    links = re.findall(r"\]\((lectures/\w+)\.ipynb#([^)]+)\)", text.split("**You will learn**")[0])
    assert links
    broken_laws(
        [
            f"{lecture}.md has no heading {heading!r}"
            for lecture, heading in links
            if f"\n##-{heading}\n"
            not in (root / f"{lecture}.md").read_text("utf-8").replace(" ", "-")
        ],
        f"correct the link under the title of solutions/{exercise.slug}.md",
    )
    assert "\n> **On a machine with ROS**\n" in text


def test_the_solution_passes_every_check(root: Path, exercise: Exercise) -> None:
    result = graded(root / "solutions" / f"{exercise.slug}.ipynb", exercise)
    broken_laws(
        {check.name: check.message for check in result.checks if check.message},
        f"mend the solution or its check: `grader verify --only {exercise.id}` shows the log",
    )
    assert {check.status for check in result.checks} == {Status.PASSED}
    assert result.points == result.max_points > 0
    assert {check.hidden for check in result.checks} == {False, True}


def test_the_untouched_exercise_is_not_attempted(root: Path, exercise: Exercise) -> None:
    result = graded(root / "exercises" / f"{exercise.slug}.ipynb", exercise)
    broken_laws(
        {c.name: c.status for c in result.checks if c.status is not Status.NOT_ATTEMPTED},
        "a check of what was not begun is not attempted: it asks for what the student writes, by a fixture",
    )
    assert result.points == 0


@pytest.mark.slow
def test_every_law_holds_and_each_variant_is_judged_as_its_file_says(
    root: Path, exercise_id: str
) -> None:
    findings = verify(root, jobs=JOBS, only=exercise_id)
    broken_laws(findings, SAID)
