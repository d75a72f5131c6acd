from __future__ import annotations

from pathlib import Path

import pytest

from grader.authoring.build import build
from grader.authoring.new import new_exercise
from grader.authoring.verify import verify
from grader.errors import GraderError
from grader.exercises import get_exercise
from grader.results import CheckResult, ExerciseResult, Status

ROOT = Path(__file__).resolve().parents[3]


def test_a_scaffold_builds_and_verify_says_what_is_to_be_filled_in(tmp_path: Path) -> None:
    written = new_exercise(tmp_path, "3.11", title="Follow  the wall")
    assert [path.relative_to(tmp_path).as_posix() for path in written] == [
        "solutions/3_11_follow_the_wall.md",
        "exercises/test_3_11.py",
        "solutions/test_3_11_hidden.py",
        "solutions/variants_3_11.toml",
    ]
    build(tmp_path)
    exercise = get_exercise(tmp_path, "3.11")
    assert exercise.title == "Follow the wall"
    assert exercise.hidden_checks is not None

    def grade(submission: object, exercise: object) -> ExerciseResult:
        result = CheckResult(name="test_fill_in_public", title="x.", status=Status.PASSED)
        return ExerciseResult.from_checks("3.11", [result])

    findings = verify(tmp_path, grade=grade)
    filled = {finding.file.split(":")[0] for finding in findings if "FILL IN" in finding.what}
    assert filled == {path.relative_to(tmp_path).as_posix() for path in written}
    others = [finding for finding in findings if "scaffold" not in finding.what]
    assert {finding.file.split(":")[0] for finding in others} == {
        "solutions/3_11_follow_the_wall.md",  # this grader passes everything, also the stub
        "solutions/variants_3_11.toml",
    }


def test_a_scaffold_is_graded_by_its_own_checks(tmp_path: Path) -> None:
    new_exercise(tmp_path, "3.11", title="Follow the wall")
    build(tmp_path)
    findings = verify(tmp_path, jobs=2)
    assert [finding.what for finding in findings] == ["the scaffold still says FILL IN"] * 4


def test_a_copy_of_another_exercise_works_at_once_and_says_what_waits(tmp_path: Path) -> None:
    for pattern in ("exercises/oracles/*.py", "exercises/test_3_06.py", "solutions/*3_06*[!b]"):
        for path in ROOT.glob(pattern):
            copy = tmp_path / path.relative_to(ROOT)
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(path.read_bytes())
    new_exercise(tmp_path, "3.12", title="Two arms", like="3.6")
    build(tmp_path)
    assert get_exercise(tmp_path, "3.12").title == "Two arms"
    findings = verify(tmp_path, jobs=2, only="3.12")
    assert [finding.what for finding in findings] == ["the scaffold still says FILL IN"] * 4
    assert 'check("3.12")' in (tmp_path / "solutions/3_12_two_arms.md").read_text("utf-8")


def test_a_copy_of_nothing_is_refused(tmp_path: Path) -> None:
    with pytest.raises(GraderError, match=r"no exercise 3\.9 to begin with"):
        new_exercise(tmp_path, "3.12", title="Two turtles", like="3.9")


@pytest.mark.parametrize(
    ("number", "title"),
    [("3", "x"), ("3.1.1", "x"), ("../3.1", "x"), ("3.1", ""), ("3.1", "a: b"), ("3.1", "{x}")],
)
def test_odd_numbers_and_titles_are_refused(tmp_path: Path, number: str, title: str) -> None:
    with pytest.raises(GraderError):
        new_exercise(tmp_path, number, title=title)
    assert list(tmp_path.iterdir()) == []


def test_nothing_is_overwritten(tmp_path: Path) -> None:
    new_exercise(tmp_path, "3.11", title="One")
    with pytest.raises(GraderError, match="is there already"):
        new_exercise(tmp_path, "3.11", title="Two")
    (tmp_path / "exercises" / "test_3_12.py").write_text("mine")
    with pytest.raises(GraderError, match=r"test_3_12\.py is there already"):
        new_exercise(tmp_path, "3.12", title="Three")
    assert not list((tmp_path / "solutions").glob("*3_12*"))
