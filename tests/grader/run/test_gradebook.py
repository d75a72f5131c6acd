import json
import os

import pytest

from grader.errors import GraderError
from grader.results import CheckResult, ExerciseResult, Status
from grader.run.gradebook import Gradebook, StudentResult, write_gradebook


@pytest.fixture
def gradebook():
    check = CheckResult(
        name="test_a",
        title="Ä",
        status=Status.FAILED,
        max_points=2,
        hidden=True,
        message="m",
        hint="h",
    )
    result = ExerciseResult.from_checks("3.1", [check], notes=["n"])
    student = StudentResult(student="Ada Łovelace", exercises=(result, result))
    return Gradebook(sandbox="bubblewrap", submissions=(student,))


def test_the_schema(gradebook, tmp_path):
    write_gradebook(gradebook, tmp_path / "gradebook.json")
    check = {
        "name": "test_a",
        "title": "Ä",
        "status": "failed",
        "points": 0.0,
        "max_points": 2,
        "hidden": True,
        "message": "m",
        "hint": "h",
    }
    exercise = {
        "id": "3.1",
        "status": "failed",
        "points": 0.0,
        "max_points": 2.0,
        "checks": [check],
    }
    assert json.loads((tmp_path / "gradebook.json").read_text("utf-8")) == {
        "version": 1,
        "sandbox": "bubblewrap",
        "submissions": [
            {
                "student": "Ada Łovelace",
                "points": 0.0,
                "max_points": 4.0,
                "exercises": [exercise, exercise],
            }
        ],
    }


def test_equal_results_are_equal_bytes(gradebook, tmp_path):
    write_gradebook(gradebook, tmp_path / "a.json")
    write_gradebook(gradebook, tmp_path / "b.json")
    assert (tmp_path / "a.json").read_bytes() == (tmp_path / "b.json").read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.json", "b.json"]


def test_a_full_disk_leaves_the_old_gradebook(gradebook, tmp_path, monkeypatch):
    path = tmp_path / "gradebook.json"
    path.write_text("old")

    def full(descriptor):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(GraderError, match="No space left"):
        write_gradebook(gradebook, path)
    assert path.read_text() == "old"
    assert [file.name for file in tmp_path.iterdir()] == ["gradebook.json"]


def test_a_folder_that_is_not_there_is_an_error_in_words(gradebook, tmp_path):
    with pytest.raises(GraderError, match="cannot be written"):
        write_gradebook(gradebook, tmp_path / "nowhere" / "gradebook.json")
