from __future__ import annotations

import io
import os
import time
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from grader.errors import GraderError, SubmissionError
from grader.exercises import Exercise
from grader.submission import FoundSubmission, discover

NAME = "3_01_broadcast_a_tf.ipynb"


def students(found: list[FoundSubmission]) -> dict[str, list[str]]:
    return {one.student: sorted(one.submissions) for one in found}


def make_zip(path: Path, entries: Mapping[str, str | bytes]) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(zip_bytes(entries))
    return path


def zip_bytes(entries: Mapping[str, str | bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, data in entries.items():
            archive.writestr(name, data)
    return buffer.getvalue()


@pytest.fixture
def text(make: Any) -> str:
    return str(make.json(make.writes()))


def test_a_folder_of_notebooks_is_one_submission(
    make: Any, exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    make.save(make.writes(), to=f"ada/{NAME}")
    make.save(make.writes("<launch/>", path=make.launch), to="ada/3_02_launch.ipynb", claims="3.2")
    assert students(discover([tmp_path / "ada"], exercises)) == {"ada": ["3.1", "3.2"]}


def test_a_folder_of_folders_and_archives_is_one_submission_each(
    make: Any, exercises: dict[str, Exercise], text: str, tmp_path: Path
) -> None:
    make.save(make.writes(), to=f"all/ada/{NAME}")
    make.save(make.writes(), to=f"all/bob/deep/er/{NAME}")
    make.save(make.writes(), to=f"all/ada/.ipynb_checkpoints/{NAME}")
    make_zip(tmp_path / "all" / "eve.zip", {f"work/{NAME}": text})
    (tmp_path / "all" / "lazy").mkdir()
    found = discover([tmp_path / "all"], exercises)
    assert students(found) == {"ada": ["3.1"], "bob": ["3.1"], "eve": ["3.1"], "lazy": []}
    assert found[3].problems == ("No notebook was found; hand in the .ipynb files.",)


def test_a_stray_notebook_beside_the_hand_ins_of_a_class_does_not_merge_them(
    make: Any, exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    for name in ("ada", "bob"):
        make.save(make.writes(), to=f"all/{name}/{NAME}")
    make.save(make.writes(), to=f"all/{NAME}")
    found = discover([tmp_path / "all"], exercises)
    assert students(found) == {"ada": ["3.1"], "all": ["3.1"], "bob": ["3.1"]}


def test_a_working_folder_is_one_student_whatever_packages_lie_in_it(
    make: Any, exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    make.save(make.writes(), to=f"work/{NAME}")
    (tmp_path / "work" / "hello_ros" / "scripts").mkdir(parents=True)
    assert students(discover([tmp_path / "work"], exercises)) == {"work": ["3.1"]}


def test_notebooks_given_one_by_one_belong_to_their_folder(
    make: Any, exercises: dict[str, Exercise]
) -> None:
    one = make.save(make.writes(), to=f"ada/{NAME}")
    two = make.save(make.cell("x"), to="ada/3_02_launch.ipynb", claims="3.2")
    three = make.save(make.writes(), to="bob.ipynb")
    found = discover([one, two, three], exercises)
    assert students(found) == {"ada": ["3.1", "3.2"], "bob": ["3.1"]}


def test_a_folder_of_one_notebook_per_student(
    make: Any, exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    for name in ("ada", "bob_3_01", "bob_3_02"):
        claims = "3.2" if name.endswith("2") else "3.1"
        make.save(make.writes(), to=f"all/{name}.ipynb", claims=claims)
    found = discover([tmp_path / "all"], exercises)
    assert students(found) == {"ada": ["3.1"], "bob": ["3.1", "3.2"]}


def test_downloads_of_moodle_and_canvas(
    make: Any, exercises: dict[str, Exercise], text: str, tmp_path: Path
) -> None:
    moodle = make_zip(
        tmp_path / "moodle.zip",
        {
            f"Ada L_12_assignsubmission_file_/{NAME}": text,
            "Ada L_34_assignsubmission_file_/work.zip": zip_bytes({NAME: text}),
            f"Bob_56_assignsubmission_file_{NAME}": text,
        },
    )
    canvas = make_zip(
        tmp_path / "canvas.zip",
        {
            f"knuthdon_LATE_1234_5678_{NAME}": text,
            "knuthdon_LATE_1234_5679_3_02_launch.ipynb": text.replace('"3.1"', '"3.2"'),
            "hamilton_1235_5680_work.zip": zip_bytes({f"x/{NAME}": text}),
        },
    )
    assert students(discover([moodle, canvas], exercises)) == {
        "Ada L (12)": ["3.1"],
        "Ada L (34)": ["3.1"],
        "Bob": ["3.1"],
        "knuthdon": ["3.1", "3.2"],
        "hamilton": ["3.1"],
    }


def test_a_class_in_a_folder_in_a_zip_file(
    exercises: dict[str, Exercise], text: str, tmp_path: Path
) -> None:
    path = make_zip(tmp_path / "class.zip", {f"c/ada/{NAME}": text, f"c/bob/{NAME}": text})
    assert students(discover([path], exercises)) == {"ada": ["3.1"], "bob": ["3.1"]}


def test_names_inside_a_hand_in_cannot_claim_another_student(
    exercises: dict[str, Exercise], text: str, tmp_path: Path
) -> None:
    names = [f"Bob_56_assignsubmission_file_/{NAME}", f"bob_1234_5678_{NAME}", f"bob/{NAME}"]
    make_zip(tmp_path / "all" / "eve.zip", dict.fromkeys(names, text))
    make_zip(tmp_path / "all" / "eva_123_456_x.zip", dict.fromkeys(names, text))
    found = discover([tmp_path / "all"], exercises)
    assert students(found) == {"eva": ["3.1"], "eve": ["3.1"]}
    lone = discover([tmp_path / "all" / "eva_123_456_x.zip"], exercises)
    assert students(lone) == {"eva": ["3.1"]}


def test_two_students_of_one_name_stay_two(
    make: Any, exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    for folder in ("a/ada", "b/ada", "b/Ada"):
        make.save(make.writes(), to=f"{folder}/{NAME}")
    found = discover([tmp_path / "a", tmp_path / "b"], exercises)
    assert sorted(students(found)) == ["Ada (2)", "ada", "ada (3)"]


def test_a_path_given_twice_counts_once(
    make: Any, exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    make.save(make.writes(), to=f"ada/{NAME}")
    found = discover([tmp_path / "ada", tmp_path / "ada"], exercises)
    assert students(found) == {"ada": ["3.1"]}
    assert found[0].submissions["3.1"].notes == ()


@pytest.mark.parametrize(
    ("name", "claims", "exercise_id"),
    [
        ("whatever.ipynb", "3.2", "3.2"),
        ("3_02_launch.ipynb", "3.1", "3.1"),
        ("3_02_launch (1).ipynb", "9.9", "3.2"),
        ("Exercise 3.2 final.ipynb", None, "3.2"),
        ("3-10.ipynb", None, "3.10"),
        ("3_1.ipynb", None, "3.1"),
        ("whatever.ipynb", None, "3.1"),
        ("13_2.ipynb", None, "3.1"),
    ],
)
def test_which_exercise_a_notebook_is_for(
    make: Any, exercises: dict[str, Exercise], name: str, claims: str | None, exercise_id: str
) -> None:
    path = make.save(make.writes(), to=f"ada/{name}", claims=claims)
    assert list(discover([path], exercises)[0].submissions) == [exercise_id]


def test_a_notebook_of_no_exercise_is_a_problem_not_an_error(
    make: Any, exercises: dict[str, Exercise]
) -> None:
    path = make.save(make.cell("x"), to="ada/notes.ipynb", claims=None)
    (found,) = discover([path.parent], exercises)
    assert found.problems == ("notes.ipynb belongs to no exercise that is graded here.",)
    empty = found.submission(exercises["3.1"])
    assert not empty.attempted(exercises["3.1"])
    assert empty.notes == ("No notebook for exercise 3.1 was handed in.", *found.problems)


def test_of_several_notebooks_the_one_with_work_is_graded(
    make: Any, exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    make.save(make.writes(make.stub), to=f"ada/{NAME}")
    make.save(make.writes("work"), to="ada/3_01_copy.ipynb")
    make.save(make.writes("older"), to="ada/old/3_01_copy.ipynb")
    (tmp_path / "ada" / "3_01_broken.ipynb").write_text("{")
    (found,) = discover([tmp_path / "ada"], exercises)
    submission = found.submission(exercises["3.1"])
    assert submission.student == "ada"
    assert submission.files[make.path] == "work\n"
    assert any("3_01_copy.ipynb was graded" in note for note in submission.notes)
    assert any("3_01_broken.ipynb is not a notebook" in note for note in submission.notes)


# -- what cannot be read ---------------------------------------------------------------------------


def test_each_unreadable_notebook_gives_its_reason_and_no_more(
    make: Any, exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    make.save(make.writes(), to=f"all/ada/{NAME}")
    secret = make.save(make.writes(), to="secret.ipynb")
    for name in ("bob", "cyd", "dan", "eve"):
        (tmp_path / "all" / name).mkdir()
    (tmp_path / "all" / "bob" / NAME).symlink_to(secret)
    (tmp_path / "all" / "cyd" / NAME).write_bytes(b"")
    (tmp_path / "all" / "dan" / NAME).mkdir()
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "all" / "eve" / NAME)
    (tmp_path / "all" / "fay").symlink_to(tmp_path / "all" / "ada")
    (tmp_path / "all" / "gil.zip").write_bytes(b"no zip")
    start = time.perf_counter()
    found = {one.student: one for one in discover([tmp_path / "all"], exercises)}
    assert time.perf_counter() - start < 10
    assert list(found) == ["ada", "bob", "cyd", "dan", "eve", "fay", "gil"]
    assert found["ada"].submissions
    for name, says in (("bob", "is a link"), ("cyd", "is empty"), ("eve", "not a regular file")):
        with pytest.raises(SubmissionError, match=says):
            found[name].submission(exercises["3.1"])
    assert "No notebook was found" in found["dan"].problems[0]
    assert "is a link" in found["fay"].problems[0]
    assert "gil cannot be read as a zip file" in found["gil"].problems[0]


def test_what_a_file_is_called_cannot_steer_a_terminal(
    exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    make_zip(tmp_path / "all" / "eve.zip", {"\x1b[31m\u202e3_01.ipynb": "{", "\x1b]0;.ipynb": "{"})
    (found,) = discover([tmp_path / "all"], exercises)
    texts = [found.student, *found.problems, *found.unreadable.values()]
    assert all(text.isprintable() for text in texts), texts


def test_many_broken_files_are_summed_up(exercises: dict[str, Exercise], tmp_path: Path) -> None:
    make_zip(tmp_path / "eve.zip", {f"{n}x.ipynb": "{" for n in range(500)})
    (found,) = discover([tmp_path / "eve.zip"], exercises)
    assert len(found.problems) == 21
    assert found.problems[-1] == "480 more files cannot be read."


def test_a_path_that_is_nothing_is_the_callers_error(
    exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    with pytest.raises(GraderError, match="no file or folder"):
        discover([tmp_path / "nowhere"], exercises)
    (tmp_path / "x.txt").write_text("")
    with pytest.raises(GraderError, match="neither a notebook"):
        discover([tmp_path / "x.txt"], exercises)


def test_a_link_as_the_path_itself_is_a_verdict(
    make: Any, exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    link = tmp_path / "drop" / NAME
    link.parent.mkdir()
    link.symlink_to(make.save(make.writes()))
    (found,) = discover([link], exercises)
    assert "is a link" in found.unreadable["3.1"]


def test_an_empty_folder_is_a_student_who_handed_in_nothing(
    exercises: dict[str, Exercise], tmp_path: Path
) -> None:
    (found,) = discover([tmp_path], exercises)
    assert found.student == tmp_path.name
    assert found.problems
