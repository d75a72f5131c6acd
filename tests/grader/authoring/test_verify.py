"""Each law of the workbook holds for a sound workbook, and names file and remedy when broken."""

from __future__ import annotations

import itertools
from dataclasses import replace
from typing import Any

import pytest

from grader.authoring.laws_of_files import is_telling
from grader.authoring.verify import verify
from grader.errors import GraderError
from grader.results import ExerciseResult, Status


@pytest.fixture
def built(workbook: Any) -> Any:
    workbook.build()
    return workbook


def findings(workbook: Any, **options: Any) -> list[str]:
    options = {"grade": workbook.grade, "jobs": 2, **options}
    found = verify(workbook.root, **options)
    assert all(one.file and one.what and one.remedy for one in found)
    return [str(one) for one in found]


def the_one(workbook: Any, **options: Any) -> str:
    found = findings(workbook, **options)
    assert len(found) == 1, found
    return found[0]


def test_a_sound_workbook_has_no_findings(built: Any) -> None:
    assert findings(built) == []
    assert findings(built, only="3.1") == []


# -- files -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["checks", "hidden"])
def test_missing_checks(built: Any, name: str) -> None:
    file = getattr(built, name)
    (built.root / file).unlink()
    found = findings(built)
    assert found[0].startswith(f"{file}: is missing; write it")


def test_missing_variants(built: Any) -> None:
    (built.root / built.variants).unlink()
    assert the_one(built).startswith(f"{built.variants}: is missing")


def test_stale_and_missing_notebooks(built: Any) -> None:
    built.edit(built.student, "Some text", "Another text")
    (built.root / built.solution).unlink()
    assert findings(built) == [
        f"{built.student}: is stale; run `grader build`",
        f"{built.solution}: is missing; run `grader build`",
    ]


@pytest.mark.parametrize(
    "name",
    ["exercises/notes.txt", "exercises/test_3_02.py", "solutions/3_02_x.ipynb", "exercises/a/b.py"],
)
def test_an_unexpected_file(built: Any, name: str) -> None:
    built.write(name, "")
    assert the_one(built).startswith(f"{name}: belongs to no exercise")
    assert findings(built, only="3.1") == []


def test_litter_and_readmes_are_expected(built: Any) -> None:
    for name in ("README.md", "__pycache__/x.pyc", ".ipynb_checkpoints/y.ipynb"):
        built.write(f"exercises/{name}", "")
    assert findings(built) == []


def test_a_fault_in_a_source_is_a_finding_and_the_rest_is_verified(built: Any) -> None:
    built.write("solutions/3_02_broken.md", "---\nworkbook:\n  id: 3.2\n---\n")
    built.edit(built.student, "Some text", "Another text")
    found = findings(built)
    assert found[0].startswith("solutions/3_02_broken.md:3: `id` is missing")
    assert found[1].startswith(f"{built.student}: is stale")


def test_two_sources_with_one_number(built: Any) -> None:
    built.write("solutions/3_01_twin.md", built.read(built.source))
    assert "has the number of 3_01_say_it.md" in findings(built)[0]


def test_an_empty_workbook_and_an_unknown_exercise(built: Any, tmp_path: Any) -> None:
    assert [str(one) for one in verify(tmp_path / "empty")] == [
        "solutions/: has no source; begin one: `grader new`"
    ]
    with pytest.raises(GraderError, match=r"no source of exercise 3\.7"):
        verify(built.root, only="3.7", grade=built.grade)


def test_a_line_of_the_solution_in_the_students_notebook(built: Any) -> None:
    built.edit(built.source, "\ntalk()\n", '\nif 0:\n    word = "the right word"\ntalk()\n')
    built.build()
    found = findings(built)[0]
    assert "the solution's line 'word = \"the right word\"'" in found
    line = built.read(built.source).split("\n").index('    word = "the right word"') + 1
    assert found.startswith(f"{built.source}:{line}: ")


@pytest.mark.parametrize(
    ("line", "telling"),
    [
        ("", False),
        ("pass", False),
        ("return x", False),
        ("</transmission>", False),
        ('<geometry name="transmission">', False),
        ('<limit effort="1000.0" lower="0.0"/>', True),
        ("br = tf.TransformBroadcaster()", True),
    ],
)
def test_which_lines_tell_something(line: str, telling: bool) -> None:
    assert is_telling(line) is telling


# -- checks ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('    """The talker says the right word."""\n', "    pass\n", "test_word has no sentence"),
        ("right word.", "right word", "test_word has no sentence"),
        ("@points(2)\n", "", "test_word has no points"),
        ('"talk.launch"', '"other"', "no check looks at talk.launch"),
        ('"distance"', '"other"', "no check looks at distance"),
        ("def test_", "def check_", "has no check"),
        ("import points", "import (points", "is not Python"),
    ],
)
def test_a_check_has_sentence_points_and_matter(built: Any, old: str, new: str, says: str) -> None:
    built.edit(built.checks, old, new)
    found = findings(built)
    assert any(says in one and one.startswith(built.checks) for one in found), found


def test_a_name_in_a_docstring_is_no_check(built: Any) -> None:
    built.edit(built.checks, 'LAUNCH = "talk.launch"', "")
    built.edit(built.checks, "The answers are right.", "The answers in talk.launch are right.")
    assert "no check looks at talk.launch" in the_one(built)


def test_all_files_of_the_exercise_at_once_are_looked_at(built: Any) -> None:
    built.edit(built.checks, 'LAUNCH = "talk.launch"', "def paths(exercise):\n    exercise.files\n")
    assert findings(built) == []


# -- grades ----------------------------------------------------------------------------------------


def test_a_solution_that_fails(built: Any) -> None:
    built.edit(built.source, 'word = "the right word"', 'word = "nothing"')
    built.edit(built.variants, "the right word", "nothing")
    built.build()
    found = findings(built)
    assert found[0].startswith(
        f"{built.source}: the solution does not pass test_word (failed): this"
    )


def test_what_is_skipped_is_counted_and_the_log_is_shown_once_and_no_variant_is_tried(
    built: Any,
) -> None:
    graded: list[str] = []

    def grade(submission: Any, exercise: Any) -> ExerciseResult:
        graded.append(submission.student)
        result: ExerciseResult = built.grade(submission, exercise)
        if submission.student != "solution":
            return result
        one, other, third = (
            replace(check, status=Status.FAILED, points=0.0, log="ERROR") for check in result.checks
        )
        checks = [
            replace(one, message="nothing came"),
            replace(other, message="nothing came either"),
            replace(third, status=Status.SKIPPED, message="it builds on another check"),
        ]
        return ExerciseResult.from_checks("3.1", checks)

    assert findings(built, grade=grade) == [
        f"{built.source}: the solution does not pass test_word (failed): nothing came; "
        "correct the check or the solution\n    log: ERROR",
        f"{built.source}: the solution does not pass test_answers (failed): nothing came either; "
        "correct the check or the solution; 1 more skipped, since they build on it",
    ]
    assert sorted(graded) == ["solution", "solution", "stub"]


def test_a_check_that_a_variant_breaks_has_a_fault_of_its_own(built: Any) -> None:
    def grade(submission: Any, exercise: Any) -> ExerciseResult:
        result: ExerciseResult = built.grade(submission, exercise)
        if submission.answers.get("fixed_frame") != "map":
            return result
        fault = replace(
            result.checks[1], status=Status.INFRASTRUCTURE, message="AttributeError: text"
        )
        return ExerciseResult.from_checks("3.1", [result.checks[0], fault, result.checks[2]])

    found = the_one(built, grade=grade)
    assert "'another frame' breaks test_answers: AttributeError: text; correct the check" in found


def test_a_solution_whose_results_differ(built: Any) -> None:
    count = itertools.count()

    def grade(submission: Any, exercise: Any) -> ExerciseResult:
        result: ExerciseResult = built.grade(submission, exercise)
        return replace(result, notes=(str(next(count)),))

    assert "the solution's two results differ" in the_one(built, grade=grade)


def test_a_stub_that_earns_something(built: Any) -> None:
    def grade(submission: Any, exercise: Any) -> ExerciseResult:
        result: ExerciseResult = built.grade(submission, exercise)
        if submission.attempted(exercise):
            return result
        lucky = replace(result.checks[0], status=Status.PASSED, points=1.0)
        return ExerciseResult.from_checks("3.1", [lucky, *result.checks[1:]])

    found = the_one(built, grade=grade)
    assert "the untouched exercise is 'failed' with 1 points test_word" in found


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('new = "a wrong one"', 'new = "the right word!"', "is 'passed' in test_word, rejected by: no"),
        ('check = "test_answers"', 'check = "test_word"', "rejected by: ['test_answers']"),
        ('check = "test_answers"', 'check = "test_nothing"', "no check test_nothing"),
        ('says = "fixed_frame"', 'says = "distance"', "no 'distance'"),
        ('print("the right word")', "print()", "the right variant 'shorter' does not pass test_word"),
        ('old = "the right word"', 'old = "word"', "occurs 3 times"),
        ('expect = "accept"', 'expect = "maybe"', "`expect` is"),
    ],
)  # fmt: skip
def test_a_variant_that_is_not_judged_as_it_should(
    built: Any, old: str, new: str, says: str
) -> None:
    built.edit(built.variants, old, new)
    found = the_one(built)
    assert says in found
    assert found.startswith(f"{built.variants}:")


def test_a_rejection_without_a_hint(built: Any) -> None:
    def grade(submission: Any, exercise: Any) -> ExerciseResult:
        result: ExerciseResult = built.grade(submission, exercise)
        return ExerciseResult.from_checks("3.1", [replace(one, hint="") for one in result.checks])

    assert [one.split(" gets ")[1] for one in findings(built, grade=grade)] == [
        "no hint from test_word; give its expectation one",
        "no hint from test_answers; give its expectation one",
    ]


def test_variants_without_a_wrong_one(built: Any) -> None:
    text = built.read(built.variants)
    built.write(built.variants, text[text.rindex("[[variant]]") :])
    assert the_one(built).startswith(f"{built.variants}: has no wrong variant")
