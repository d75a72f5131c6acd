from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

from grader.exercises import Exercise
from grader.submission import submission_from_folder, submission_from_notebook


def test_files_and_answers_of_a_notebook(make: Any, exercise: Exercise) -> None:
    path = make.save(make.cell("text", "markdown"), make.writes(), make.answer())
    found = submission_from_notebook(path, exercise, student="ada")
    assert found.student == "ada"
    assert found.exercise_id == "3.1"
    assert found.files == {make.path: make.solved}
    assert found.answers == {"fixed_frame": "world", "distance": 2.0}
    assert found.notes == ()
    assert found.attempted(exercise)


def test_the_notebook_as_given_is_not_attempted(make: Any, exercise: Exercise) -> None:
    stub = make.stub.replace("\n", "  \r\n") + "\n\n"
    path = make.save(make.writes(stub), make.answer("fixed_frame = ...\ndistance = None"))
    found = submission_from_notebook(path, exercise)
    assert not found.attempted(exercise)
    assert not found.attempted_file(make.path, exercise)


def test_one_answer_is_an_attempt(make: Any, exercise: Exercise) -> None:
    path = make.save(make.writes(make.stub), make.answer("distance = 1"))
    assert submission_from_notebook(path, exercise).attempted(exercise)


def test_a_missing_file_is_named_with_the_one_that_was_meant(make: Any, exercise: Exercise) -> None:
    missing = submission_from_notebook(make.save(make.cell("x")), exercise)
    assert f"`%%writefile {make.path}`" in missing.notes[0]
    near = make.path.replace("broadcaster", "brodcaster")
    misspelt = submission_from_notebook(make.save(make.writes(path=near)), exercise)
    assert misspelt.notes == (
        f"No cell writes {make.path}, but one writes {near}; did you mean the former?",
    )


# -- the folder that the notebook's check reads ---------------------------------------------------


def test_the_folder_gives_the_same_submission(
    make: Any, exercise: Exercise, tmp_path: Path
) -> None:
    path = tmp_path / make.path
    path.parent.mkdir(parents=True)
    path.write_bytes(make.solved.replace("\n", "\r\n").encode())
    folder = submission_from_folder(
        tmp_path, exercise, {"fixed_frame": "world", "distance": (1, 2), "other": object()}
    )
    assert folder.files == {make.path: make.solved}
    assert folder.answers == {"fixed_frame": "world", "distance": [1, 2]}
    assert folder.notes == ()


def test_a_file_not_yet_written_and_a_wrong_answer_are_named(
    exercise: Exercise, tmp_path: Path
) -> None:
    found = submission_from_folder(tmp_path, exercise, {"fixed_frame": ..., "distance": object()})
    assert not found.attempted(exercise)
    assert "run the cell that writes it" in found.notes[0]
    assert found.notes[1].startswith("The answer distance was not read")


def test_a_helper_that_is_imported_comes_along(
    make: Any, exercise: Exercise, tmp_path: Path
) -> None:
    folder = tmp_path / "hello_ros" / "scripts"
    folder.mkdir(parents=True)
    (tmp_path / make.path).write_text("import my_tools\nimport rospy\n")
    (folder / "my_tools.py").write_text("x = 1\n")
    (folder / "other.py").write_text("y = 1\n")
    found = submission_from_folder(tmp_path, exercise, {})
    assert set(found.files) == {make.path, "hello_ros/scripts/my_tools.py"}
    assert "or it is not handed in" in found.notes[0]


def test_reading_needs_none_of_the_slow_imports() -> None:
    code = (
        "import sys, grader.exercises, grader.submission, grader.results;"
        "print(sorted({'nbformat', 'jsonschema', 'jupytext', 'pytest', 'numpy'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
