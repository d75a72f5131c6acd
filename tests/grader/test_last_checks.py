"""How far a student is."""

import json
from types import SimpleNamespace

import pytest

from grader.last_checks import RECORD, progress_of, remember
from grader.results import ExerciseResult, Status

ONE = SimpleNamespace(id="3.1", title="Broadcast", slug="3_01_broadcast")
TWO = SimpleNamespace(id="3.2", title="Frames", slug="3_02_frames")


def result(status, points, of=10.0):
    return ExerciseResult(exercise_id="3.1", status=status, points=points, max_points=of, checks=())


def test_the_last_check_counts(tmp_path):
    assert repr(progress_of(tmp_path, [ONE])) == "3.1   not checked yet"
    remember(tmp_path, result(Status.FAILED, 2.5))
    remember(tmp_path, result(Status.PASSED, 10.0))
    done = progress_of(tmp_path, [ONE, TWO])
    assert repr(done) == "3.1   10 of 10 points\n3.2   not checked yet"
    assert "| [3.1 Broadcast](3_01_broadcast.ipynb) | ✓ 10 of 10 points |" in done._repr_markdown_()


def test_what_was_not_begun_is_no_failure(tmp_path):
    remember(tmp_path, result(Status.NOT_ATTEMPTED, 0.0))
    assert repr(progress_of(tmp_path, [ONE])) == "3.1   not begun"


@pytest.mark.parametrize("text", ["", "[]", "{", '{"3.1": 5}', '{"3.1": {"points": "x"}}', "\x00"])
def test_a_broken_record_is_as_none(tmp_path, text):
    (tmp_path / RECORD).write_text(text)
    assert repr(progress_of(tmp_path, [ONE])) == "3.1   not checked yet"
    remember(tmp_path, result(Status.FAILED, 1.0))
    assert json.loads((tmp_path / RECORD).read_text())["3.1"]["points"] == 1.0


def test_a_folder_that_is_not_there_remembers_nothing(tmp_path):
    remember(tmp_path / "nowhere", result(Status.PASSED, 1.0))
    assert not (tmp_path / "nowhere").exists()


def test_the_package_offers_it_whatever_was_loaded_before():
    import grader.notebook  # noqa: F401 - it loads the module of the function
    from grader import progress

    assert callable(progress)
