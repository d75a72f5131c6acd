"""A workbook with one small exercise, made anew for each test, and ways to hand in and grade."""

import json
import textwrap
from pathlib import Path
from types import SimpleNamespace

import pytest

from grader.exercises import get_exercise
from grader.run import class_run, default_launcher, grade_submission
from grader.sandbox import Sandbox
from grader.submission import Submission

SCRIPT = "hello_ros/scripts/talk.py"
STUB = "#!/usr/bin/env python3\n# TODO: talk\n"
DEFINITION = {
    "id": "9.1",
    "title": "Talk",
    "package": "hello_ros",
    "files": [SCRIPT],
    "answers": ["fixed_frame"],
    "nodes_may": {"publish": ["/tf"], "services": [], "parameters": []},
}
PUBLIC = '''
from grader.checks import after, expect_equal, points

@points(2)
def test_answer(submission):
    """The answer names the fixed frame."""
    expect_equal(submission.answers.get("fixed_frame"), "world", what="fixed_frame", hint="Look.")

@after("test_answer")
def test_file(submission):
    """The file is there."""
    assert submission.files
'''
HIDDEN = '''
from grader.checks import expect

def test_hidden(submission):
    """The answer is short."""
    expect(len(submission.answers["fixed_frame"]) < 6, "The answer is long.")
'''


def notebook(*cells, metadata=None):
    """A notebook's JSON text; a cell is its source, or (source, tag)."""
    pairs = [cell if isinstance(cell, tuple) else (cell, None) for cell in cells]
    return json.dumps(
        {
            "cells": [
                {
                    "cell_type": "code",
                    "id": f"cell-{number}",
                    "metadata": {"tags": [tag]} if tag else {},
                    "execution_count": None,
                    "outputs": [],
                    "source": source,
                }
                for number, (source, tag) in enumerate(pairs)
            ],
            "metadata": metadata or {},
            "nbformat": 4,
            "nbformat_minor": 5,
        }
    )


class Workbook:
    """The folder of a course, and what its one exercise needs."""

    def __init__(self, root: Path):
        self.root = root
        (root / "exercises").mkdir(parents=True)
        (root / "solutions").mkdir()
        self.write("exercises/9_01_talk.ipynb", self.notebook(STUB, answer="..."))
        self.checks(PUBLIC, HIDDEN)

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file

    def checks(self, public, hidden=""):
        self.write("exercises/test_9_01.py", textwrap.dedent(public))
        self.write("solutions/test_9_01_hidden.py", textwrap.dedent(hidden))

    def notebook(self, script, answer='"world"'):
        cells = [f"%%writefile {SCRIPT}\n{script}", (f"fixed_frame = {answer}", "answer")]
        return notebook(*cells, metadata={"workbook": DEFINITION})

    @property
    def exercise(self):
        return get_exercise(self.root, "9.1")

    def submission(self, script="print('done')\n", student="ada", files=None, **answers):
        files = {SCRIPT: script} if files is None else files
        return Submission(student=student, exercise_id="9.1", files=files, answers=answers)

    def grade(self, submission, *, hidden=False, **options):
        options = {"sandbox": Sandbox(name="none"), "launcher": default_launcher()} | options
        return grade_submission(submission, self.exercise, hidden=hidden, **options)


@pytest.fixture
def workbook(tmp_path):
    return Workbook(tmp_path / "course")


@pytest.fixture
def run_checks(workbook):
    """A function that grades a submission by check functions given as text; results by name."""

    def run(checks, submission=None, **options):
        workbook.checks(f"from grader.checks import *\n{textwrap.dedent(checks)}")
        submission = submission or workbook.submission(fixed_frame="world")
        result = workbook.grade(submission, **options)
        return {check.name.removeprefix("test_"): check for check in result.checks}

    return run


@pytest.fixture(autouse=True)
def _one_warm_parent(monkeypatch):
    """Classes are graded by the checkers of this process: each of them would import all anew for its own."""
    monkeypatch.setattr(
        class_run,
        "new_launcher",
        lambda: SimpleNamespace(start=default_launcher().start, close=lambda: None),
    )
