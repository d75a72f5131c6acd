"""`check` as a student calls it, in the folder `work/` of a course."""

import sys
import types

import pytest

import grader
from grader import check
from grader.results import Status

SCRIPT = "hello_ros/scripts/talk.py"


@pytest.fixture
def work(workbook, monkeypatch):
    """The working folder, with a file that was written, as the current folder."""
    workbook.write(f"work/{SCRIPT}", "x = 1\n")
    monkeypatch.chdir(workbook.root / "work")
    return workbook.root / "work"


def test_it_is_what_the_package_offers():
    assert grader.__all__ == ["check", "progress"]
    assert grader.check is check


def test_the_public_checks_run_on_the_files_of_the_folder(work):
    report = check("9.1", answers={"fixed_frame": "world", "other": 1})
    assert report.passed
    assert [result.hidden for result in report.result.checks] == [False, False]
    assert "public checks: 2 of 2 passed" in repr(report)
    assert "hidden checks run when it is graded" in repr(report)
    assert "hidden checks run when it is graded" in report._repr_html_()


def test_a_failure_is_explained(work):
    report = check("9.1", answers={"fixed_frame": "map"})
    assert not report.passed
    assert "got: 'map'" in repr(report)


def test_answers_come_from_the_variables_of_the_notebook(work, monkeypatch):
    shell = types.SimpleNamespace(user_ns={"fixed_frame": "world"})
    ipython = types.SimpleNamespace(get_ipython=lambda: shell)
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    assert check("9.1").passed


def test_it_works_from_the_folder_of_the_course_too(work, workbook, monkeypatch):
    monkeypatch.chdir(workbook.root)
    assert check("9.1", answers={"fixed_frame": "world"}).passed


def test_what_was_not_saved_is_told(work, workbook):
    notebook = work / "9_01_talk.ipynb"
    notebook.write_text(workbook.notebook("x = 2\n", answer='"world"'))
    (note,) = check("9.1", answers={"fixed_frame": "world"}).result.notes
    assert SCRIPT in note
    assert "save the notebook" in note
    assert "fixed_frame" not in note
    notebook.write_text(workbook.notebook("x = 1\n", answer='"world"'))
    assert check("9.1", answers={"fixed_frame": "world"}).result.notes == ()


def test_an_untouched_exercise_is_not_attempted(work, workbook):
    workbook.write(f"work/{SCRIPT}", "#!/usr/bin/env python3\n# TODO: talk\n")
    report = check("9.1", answers={})
    assert report.result.status is Status.NOT_ATTEMPTED


@pytest.mark.parametrize("wrong", ["9.2", "", 3.5])
def test_an_unknown_exercise_is_a_sentence_and_no_stack(work, wrong):
    report = check(wrong)
    assert not report.passed
    assert "no exercise" in repr(report)
    assert "no exercise" in report._repr_html_()


def test_outside_of_a_course_it_says_so(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert "no workbook" in repr(check("9.1"))
