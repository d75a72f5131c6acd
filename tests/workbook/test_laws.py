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

JOBS = 2


def graded(notebook: Path, exercise: Exercise) -> ExerciseResult:
    submission = submission_from_notebook(notebook, exercise)
    assert submission.notes == ()
    return grade_submission(submission, exercise, hidden=True)


def test_there_is_an_exercise_for_each_source(root: Path) -> None:
    ids = [load_source(path).definition.id for path in source_paths(root)]
    assert ids
    assert ids == list(load_exercises(root))


def test_the_notebooks_are_as_their_sources_say(root: Path) -> None:
    assert build.check(root) == []


def test_nothing_else_lies_in_the_trees(root: Path) -> None:
    slugs = [path.stem for path in source_paths(root)]
    keys = [exercise_key(exercise_id) for exercise_id in load_exercises(root)]
    assert [str(finding) for finding in nothing_else(root, slugs=slugs, keys=keys)] == []


def test_an_exercise_says_what_to_read_first_and_what_a_machine_with_ros_needs(
    root: Path, exercise: Exercise
) -> None:
    """In the lab the lectures lie in `lectures/`, beside the exercises."""
    text = (root / "solutions" / f"{exercise.slug}.md").read_text(encoding="utf-8")
    links = re.findall(r"\]\((lectures/\w+)\.ipynb#([^)]+)\)", text.split("**You will learn**")[0])
    assert links
    for lecture, heading in links:
        headings = (root / f"{lecture}.md").read_text(encoding="utf-8").replace(" ", "-")
        assert f"\n##-{heading}\n" in headings
    assert "\n> **On a machine with ROS.** " in text


def test_the_solution_passes_every_check(root: Path, exercise: Exercise) -> None:
    result = graded(root / "solutions" / f"{exercise.slug}.ipynb", exercise)
    assert {check.name: check.message for check in result.checks if check.message} == {}
    assert {check.status for check in result.checks} == {Status.PASSED}
    assert result.points == result.max_points > 0
    assert {check.hidden for check in result.checks} == {False, True}


def test_the_untouched_exercise_is_not_attempted(root: Path, exercise: Exercise) -> None:
    result = graded(root / "exercises" / f"{exercise.slug}.ipynb", exercise)
    assert {check.status for check in result.checks} == {Status.NOT_ATTEMPTED}
    assert result.points == 0


@pytest.mark.slow
def test_every_law_holds_and_variants_are_told_apart(root: Path, exercise_id: str) -> None:
    findings = verify(root, jobs=JOBS, only=exercise_id)
    assert [str(finding) for finding in findings] == []
