import sqlite3

import pytest

from grader.errors import GraderError
from grader.results import CheckResult, ExerciseResult, Status
from grader.run.store import ResultStore, result_key
from grader.sandbox import Sandbox

PLAIN = Sandbox(name="none")


def result(points=1.0):
    check = CheckResult(name="a", title="ä", status=Status.PASSED, points=points, max_points=points)
    return ExerciseResult.from_checks("9.1", [check], notes=["odd"])


def test_what_was_stored_comes_back(tmp_path):
    store = ResultStore(tmp_path / "gradebook.sqlite")
    assert store.get("k") is None
    store.put("k", student="ada", result=result(1))
    store.put("k", student="ada", result=result(2))
    store.close()
    again = ResultStore(tmp_path / "gradebook.sqlite")
    assert again.get("k") == result(2)
    again.close()


def test_two_graders_at_once_do_not_hinder_each_other(tmp_path):
    one = ResultStore(tmp_path / "gradebook.sqlite")
    other = ResultStore(tmp_path / "gradebook.sqlite")
    one.put("a", student="ada", result=result())
    other.put("b", student="bob", result=result())
    assert one.get("b") == other.get("a") == result()
    one.close()
    other.close()


def test_something_else_in_its_place_is_an_error_in_words(tmp_path):
    (tmp_path / "gradebook.sqlite").write_text("no database, but a text of some length " * 10)
    with pytest.raises(GraderError, match="cannot be used as a gradebook"):
        ResultStore(tmp_path / "gradebook.sqlite")


def test_each_result_is_on_disk_at_once(tmp_path):
    store = ResultStore(tmp_path / "gradebook.sqlite")
    store.put("k", student="ada", result=result())
    other = sqlite3.connect(tmp_path / "gradebook.sqlite")
    assert other.execute("select student, exercise from result").fetchall() == [("ada", "9.1")]
    other.close()
    store.close()


def test_the_key_changes_with_all_that_a_result_depends_on(workbook):
    def key(submission, *, hidden=True, sandbox=PLAIN):
        return result_key(submission, workbook.exercise, hidden=hidden, sandbox=sandbox)

    def submission(**answers):
        return workbook.submission(fixed_frame="world", **answers)

    keys = [
        key(submission()),
        key(workbook.submission(fixed_frame="map")),
        key(workbook.submission("x = 1\n", fixed_frame="world")),
        key(workbook.submission(student="bob", fixed_frame="world")),
        key(submission(), hidden=False),
        key(submission(), sandbox=Sandbox(name="bubblewrap")),
    ]
    assert key(submission()) == keys[0]
    hidden = workbook.root / "solutions/test_9_01_hidden.py"
    hidden.write_text(hidden.read_text() + "\n# changed\n")
    assert key(submission(), hidden=False) == keys[4]
    keys.append(key(submission()))
    public = workbook.root / "exercises/test_9_01.py"
    public.write_text(public.read_text() + "\n# changed\n")
    keys.append(key(submission()))
    assert len(set(keys)) == len(keys)
