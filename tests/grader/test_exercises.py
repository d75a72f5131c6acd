from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from grader.errors import GraderError, SourceError
from grader.exercises import (
    NodesMay,
    exercise_key,
    find_root,
    get_exercise,
    load_exercises,
    require_definition,
)
from simkit.errors import UnknownNameError

DEFINITION: dict[str, Any] = {
    "id": "3.1",
    "title": "Broadcast a TF",
    "package": "hello_ros",
    "files": ["hello_ros/scripts/a.py"],
    "answers": ["fixed_frame"],
    "nodes_may": {"publish": ["/tf"]},
}


def release(root: Path, slug: str, **changes: Any) -> None:
    cells = [
        {"cell_type": "code", "source": "%%writefile hello_ros/scripts/a.py\nstub\n"},
        {"cell_type": "code", "source": "%%writefile hello_ros/launch/given.launch\n<launch/>"},
    ]
    metadata = {"workbook": {**DEFINITION, **changes}}
    folder = root / "exercises"
    folder.mkdir(exist_ok=True)
    text = json.dumps({"cells": cells, "metadata": metadata})
    (folder / f"{slug}.ipynb").write_text(text)


def test_the_released_notebook_defines_the_exercise(tmp_path: Path) -> None:
    release(tmp_path, "3_01_broadcast")
    exercise = get_exercise(tmp_path, "3.1")
    assert exercise.slug == "3_01_broadcast"
    assert exercise.permissions == NodesMay(publish=("/tf",))
    assert exercise.public_checks == tmp_path / "exercises" / "test_3_01.py"
    assert exercise.hidden_checks is None
    assert exercise.stub_files == {
        "hello_ros/scripts/a.py": "stub\n",
        "hello_ros/launch/given.launch": "<launch/>\n",
    }
    assert exercise.packages == {"hello_ros"}


def test_hidden_checks_are_there_where_the_solutions_are(tmp_path: Path) -> None:
    release(tmp_path, "s_01_spawn", id="S.1")
    hidden = tmp_path / "solutions" / "test_s_01_hidden.py"
    hidden.parent.mkdir()
    hidden.write_text("")
    assert get_exercise(tmp_path, "S.1").hidden_checks == hidden


def test_exercises_come_in_their_order(tmp_path: Path) -> None:
    for number in ("3.10", "S.1", "3.2"):
        release(tmp_path, f"{exercise_key(number)}_x", id=number)
    assert list(load_exercises(tmp_path)) == ["3.2", "3.10", "S.1"]


def test_an_unknown_exercise_lists_those_that_exist(tmp_path: Path) -> None:
    release(tmp_path, "3_01_broadcast")
    with pytest.raises(UnknownNameError, match=r"no exercise '3\.11'.*did you mean '3\.1'"):
        get_exercise(tmp_path, "3.11")


def test_one_id_for_two_notebooks_is_refused(tmp_path: Path) -> None:
    release(tmp_path, "3_01_a")
    release(tmp_path, "3_01_b")
    with pytest.raises(SourceError, match=r"3_01_b\.ipynb: 3\.1 is also the id of 3_01_a"):
        load_exercises(tmp_path)


def test_the_root_is_found_from_below_and_missed_with_advice(tmp_path: Path) -> None:
    release(tmp_path, "3_01_a")
    below = tmp_path / "work" / "hello_ros"
    below.mkdir(parents=True)
    assert find_root(below) == tmp_path.resolve()
    with pytest.raises(GraderError, match="--root"):
        find_root(Path(tmp_path.anchor))


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"id": 3.1}, "quotes"),
        ({"id": "3"}, "is not like"),
        ({"id": "../x"}, "is not like"),
        ({"title": ""}, "title"),
        ({"files": "x"}, "files"),
        ({"files": ["a", "a"]}, "twice"),
        ({"files": [], "answers": []}, "nothing would be handed in"),
        ({"nodes_may": {"topics": []}}, "nodes_may"),
        ({"colour": 1}, "unknown key `colour`"),
    ],
)
def test_a_wrong_definition_is_refused_by_name(changes: dict[str, Any], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        require_definition({**DEFINITION, **changes})


@pytest.mark.parametrize("table", [None, [], "x"])
def test_a_missing_definition_is_refused(table: object) -> None:
    with pytest.raises(ValueError, match="no table"):
        require_definition(table)


def test_nodes_may_write_nothing_unless_it_says_so() -> None:
    table = {key: value for key, value in DEFINITION.items() if key != "nodes_may"}
    assert require_definition(table).nodes_may == NodesMay()


@pytest.mark.parametrize(("number", "key"), [("3.1", "3_01"), ("3.10", "3_10"), ("S.1", "s_01")])
def test_the_key_in_file_names(number: str, key: str) -> None:
    assert exercise_key(number) == key
