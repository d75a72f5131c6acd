"""Numbers of one's own."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.checks.personal import base_of, crate_of, name_of, pose_of
from grader.errors import CheckFailed
from grader.submission import Submission


def test_a_name_gives_the_same_numbers_however_it_is_written():
    assert base_of("Ada Lovelace") == base_of("  ada   LOVELACE ")


def test_other_names_give_other_numbers():
    tasks = {repr(base_of(f"student {number}")) for number in range(100)}
    assert len(tasks) > 60


@given(st.text())
def test_any_name_gives_a_base_that_is_not_the_books(name):
    task = base_of(name)
    assert 0.12 <= task.radius <= 0.2
    assert 0.03 <= task.length <= 0.08
    assert (task.radius, task.length) != (0.1, 0.05)
    assert all(0.0 <= part <= 1.0 for part in task.rgba)
    assert f"radius {task.radius:g} m" in repr(task)


@given(st.text())
def test_any_name_gives_a_crate_with_three_different_sides(name):
    task = crate_of(name)
    assert task == crate_of(f" {name} ")
    assert len(set(task.size)) == 3
    assert 1.0 < task.x <= 2.0
    # The practice car, 0.3 m long ahead of its origin, does not stand in it.
    assert task.x - task.size[0] / 2 > 0.3
    assert f"{task.mass:g} kg" in repr(task)


def test_other_names_give_other_crates():
    assert len({repr(crate_of(f"student {number}")) for number in range(100)}) > 80


@given(st.text())
def test_any_name_gives_a_pose_that_is_not_plain(name):
    task = pose_of(name)
    assert task == pose_of(f" {name} ")
    assert 0.4 <= abs(task.hip) < 1.3
    assert 0.4 <= abs(task.shoulder) < 1.1
    assert f"{task.hip:g} rad" in repr(task)


def test_other_names_give_other_poses():
    assert len({repr(pose_of(f"student {number}")) for number in range(100)}) > 90


def submission(**answers) -> Submission:
    return Submission(student="s", exercise_id="3.6", files={}, answers=answers)


def test_the_name_is_an_answer():
    assert name_of(submission(student="Ada"), "student") == "Ada"


@pytest.mark.parametrize("name", [7, "", "   ", "...", ["Ada"], None])
def test_what_is_no_name_is_refused(name):
    with pytest.raises(CheckFailed, match="student is not a name"):
        name_of(submission(student=name), "student")
