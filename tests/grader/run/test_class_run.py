"""A class: notebooks in folders, to the gradebook."""

import pytest

from grader.results import Status
from grader.run.class_run import ClassRun, grade_class, tasks_of
from grader.sandbox import Sandbox
from grader.submission.discover import discover


@pytest.fixture
def grade_folder(workbook, tmp_path):
    """A function that grades what lies in the folder `in`; the gradebook and the JSON's bytes."""

    def grade(out="out", jobs=2, resume=False, hidden=True):
        folder = tmp_path / out
        folder.mkdir(exist_ok=True)
        run = ClassRun(
            sandbox=Sandbox(name="none"), hidden=hidden, jobs=jobs, resume=resume, folder=folder
        )
        exercises = {"9.1": workbook.exercise}
        tasks = tasks_of(discover([tmp_path / "in"], exercises), exercises, run)
        gradebook = grade_class(tasks, run, on_done=lambda task, result: None)
        return gradebook, (folder / "gradebook.json").read_bytes()

    return grade


@pytest.fixture
def hand_in(workbook, tmp_path):
    """A function that puts a notebook into the folder of a student."""

    def hand_in(student, text, name="9_01_talk.ipynb"):
        folder = tmp_path / "in" / student
        folder.mkdir(parents=True)
        (folder / name).write_text(text)

    return hand_in


@pytest.fixture
def group(hand_in, workbook):
    hand_in("ada", workbook.notebook("x = 1\n"))
    hand_in("bob", workbook.notebook("x = 1\n", answer='"map"'))
    hand_in("eve", "{ this is no notebook")
    hand_in("joe", (workbook.root / "exercises/9_01_talk.ipynb").read_text())
    hand_in("sue", "hello", name="essay.txt")


def test_every_student_gets_a_verdict_with_a_reason(group, grade_folder):
    gradebook, _ = grade_folder()
    statuses = {entry.student: entry.exercises[0].status for entry in gradebook.submissions}
    assert statuses == {
        "ada": Status.PASSED,
        "bob": Status.FAILED,
        "eve": Status.ERROR,
        "joe": Status.NOT_ATTEMPTED,
        "sue": Status.NOT_ATTEMPTED,
    }
    points = {entry.student: entry.points for entry in gradebook.submissions}
    assert points == {"ada": 4, "bob": 1, "eve": 0, "joe": 0, "sue": 0}
    assert {entry.max_points for entry in gradebook.submissions} == {4}
    reasons = {
        entry.student: entry.exercises[0].checks[0].message for entry in gradebook.submissions
    }
    assert "9_01_talk.ipynb" in reasons["eve"]
    assert "as they were given" in reasons["joe"]
    assert "No notebook for exercise 9.1" in reasons["sue"]


def test_jobs_order_and_resuming_do_not_change_a_byte(group, grade_folder):
    _, first = grade_folder(out="a", jobs=1)
    _, second = grade_folder(out="b", jobs=4)
    _, third = grade_folder(out="b", jobs=2, resume=True)
    assert first == second == third


def test_only_public_checks_if_asked(group, grade_folder):
    gradebook, _ = grade_folder(hidden=False)
    assert {entry.max_points for entry in gradebook.submissions} == {3}


def test_a_fault_of_ours_in_one_does_not_stop_the_others(group, grade_folder, monkeypatch):
    from grader.run import class_run

    real = class_run.grade_submission

    def broken(submission, *args, **kwargs):
        if submission.student == "bob":
            raise RuntimeError("a bug")
        return real(submission, *args, **kwargs)

    monkeypatch.setattr(class_run, "grade_submission", broken)
    gradebook, _ = grade_folder()
    by_name = {entry.student: entry.exercises[0] for entry in gradebook.submissions}
    assert by_name["bob"].status is Status.INFRASTRUCTURE
    assert "RuntimeError: a bug" in by_name["bob"].checks[0].message
    assert by_name["ada"].status is Status.PASSED
