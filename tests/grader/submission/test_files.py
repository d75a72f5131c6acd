from __future__ import annotations

import time
from typing import Any

import pytest

from grader.submission import files as files_module
from grader.submission.files import CollectedFiles, collect_files, same_text


@pytest.fixture
def collect(make: Any) -> Any:
    def collected(*cells: dict[str, Any]) -> CollectedFiles:
        return collect_files(
            make.notebook(*cells),
            packages={"hello_ros"},
            wanted=(make.path,),
            stubs={make.path: make.stub},
        )

    return collected


def test_later_cells_win(make: Any, collect: Any) -> None:
    found = collect(make.writes("a"), make.writes("b"))
    assert found.files == {make.path: "b\n"}
    assert found.notes == [f"Two cells write {make.path}; the later one was taken."]


def test_an_untouched_stub_does_not_replace_work(make: Any, collect: Any) -> None:
    found = collect(make.writes("work"), make.writes(make.stub))
    assert found.files == {make.path: "work\n"}
    assert "Delete the later one" in found.notes[0]


def test_appending_goes_on_where_the_last_cell_ended(make: Any, collect: Any) -> None:
    found = collect(make.writes("a"), make.writes("b", path=f"-a {make.path}"))
    assert found.files == {make.path: "a\nb\n"}
    assert found.notes == []


def test_a_file_cannot_be_a_folder_or_differ_by_case(make: Any, collect: Any) -> None:
    found = collect(
        make.writes("a", path="hello_ros/x"),
        make.writes("b", path="hello_ros/x/y"),
        make.writes("c", path="hello_ros/X"),
    )
    assert found.files == {"hello_ros/x": "a\n"}
    assert len(found.notes) == 2


def test_files_are_counted_and_weighed(
    make: Any, collect: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(files_module, "MAX_FILES", 2)
    monkeypatch.setattr(files_module, "MAX_TOTAL_CHARACTERS", 10)
    found = collect(*[make.writes("a", path=f"hello_ros/{n}") for n in "xyz"])
    assert list(found.files) == ["hello_ros/x", "hello_ros/y"]
    assert collect(make.writes("a" * 11)).files == {}


def test_a_file_outside_the_package_is_left_out(make: Any, collect: Any) -> None:
    found = collect(make.writes("a", path="turtlesim/package.xml"))
    assert found.files == {}
    assert len(found.notes) == 1


def test_a_hostile_notebook_costs_little(make: Any, collect: Any) -> None:
    start = time.perf_counter()
    collect(make.writes("\n" * 900_000), *[make.writes(make.stub)] * 3_000)
    collect(*[make.writes("x" * 10_000, path=f"-a {make.path}")] * 3_000)
    collect(*[make.cell("%%writefile " + "x y " * 200_000)] * 20)
    assert time.perf_counter() - start < 10


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        ("a\nb\n", "a\r\nb", True),
        ("a  \nb\n\n\n", "a\nb", True),
        ("a\nb", "a\n b", False),
        ("a\n\nb", "a\nb", False),
    ],
)
def test_blanks_at_ends_do_not_make_a_difference(one: str, other: str, same: bool) -> None:
    assert same_text(one, other) is same
