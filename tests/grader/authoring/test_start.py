from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from grader.authoring.start import start, start_lectures, start_page_of
from simkit.errors import UnknownNameError


@pytest.fixture
def built(workbook: Any) -> Any:
    workbook.build()
    return workbook


def change_release(workbook: Any) -> None:
    workbook.edit(workbook.source, "Some text.", "Some better text.")
    workbook.build()


def write_answer(notebook: Path, text: str) -> None:
    value = json.loads(notebook.read_text())
    value["cells"][5]["source"] = text
    notebook.write_text(json.dumps(value))


def test_the_notebook_and_the_folders_of_the_package_are_made(built: Any) -> None:
    done = start(built.root, "3.1")
    work = built.root / "work"
    assert done.notebook == work / "3_01_say_it.ipynb"
    assert done.notebook.read_bytes() == (built.root / built.student).read_bytes()
    assert done.messages == (
        "copied exercise 3.1 to 3_01_say_it.ipynb",
        "made the ROS package hello_ros",
    )
    assert "<name>hello_ros</name>" in (work / "hello_ros" / "package.xml").read_text()
    assert (work / "hello_ros" / "scripts").is_dir()
    assert (work / "hello_ros" / "launch").is_dir()


def test_another_working_folder(built: Any, tmp_path: Path) -> None:
    assert start(built.root, "3.1", work=tmp_path / "mine").notebook.parent == tmp_path / "mine"


def test_work_is_never_overwritten(built: Any) -> None:
    notebook = start(built.root, "3.1").notebook
    manifest = notebook.parent / "hello_ros" / "package.xml"
    manifest.write_text("mine")
    write_answer(notebook, 'fixed_frame = "mine"')
    mine = notebook.read_bytes()
    assert start(built.root, "3.1").messages == (
        "3_01_say_it.ipynb is there already and was left as it is",
    )
    change_release(built)
    said = start(built.root, "3.1").messages[0]
    assert "lies beside it as 3_01_say_it (new).ipynb" in said
    assert notebook.read_bytes() == mine
    assert manifest.read_text() == "mine"
    new = notebook.with_name("3_01_say_it (new).ipynb")
    assert new.read_bytes() == (built.root / built.student).read_bytes()
    assert "left as it is" in start(built.root, "3.1").messages[0]


def test_a_second_change_does_not_overwrite_work_in_the_new_copy(built: Any) -> None:
    notebook = start(built.root, "3.1").notebook
    write_answer(notebook, 'fixed_frame = "mine"')
    change_release(built)
    start(built.root, "3.1")
    new = notebook.with_name("3_01_say_it (new).ipynb")
    write_answer(new, 'fixed_frame = "also mine"')
    built.edit(built.source, "better", "best")
    built.build()
    assert "(new 2).ipynb" in start(built.root, "3.1").messages[0]
    assert "also mine" in new.read_text()


def test_an_untouched_copy_is_renewed_even_if_it_was_run(built: Any) -> None:
    notebook = start(built.root, "3.1").notebook
    value = json.loads(notebook.read_text())
    value["cells"][1]["outputs"] = [{"output_type": "stream", "name": "stdout", "text": "x"}]
    notebook.write_text(json.dumps(value))
    change_release(built)
    assert "is now the new version" in start(built.root, "3.1").messages[0]
    assert notebook.read_bytes() == (built.root / built.student).read_bytes()


def test_a_copy_of_unknown_origin_or_broken_is_left_alone(built: Any) -> None:
    notebook = start(built.root, "3.1").notebook
    (notebook.parent / ".started.json").write_text("{")
    notebook.write_text("not a notebook")
    assert "beside it" in start(built.root, "3.1").messages[0]
    assert notebook.read_text() == "not a notebook"


def test_an_unknown_exercise_is_refused(built: Any) -> None:
    with pytest.raises(UnknownNameError, match=r"no exercise '3\.7'"):
        start(built.root, "3.7")


def test_lectures_are_laid_beside_the_exercises_by_the_same_rules(built: Any) -> None:
    source = built.root / "lectures" / "1_frames.md"
    source.parent.mkdir(exist_ok=True)
    source.write_text("# Frames\n\nA frame has an origin.\n")
    assert start_lectures(built.root) == ()  # nothing is built yet
    built.build()
    assert start_lectures(built.root) == ("copied lecture 1_frames to lectures/1_frames.ipynb",)
    mine = built.root / "work" / "lectures" / "1_frames.ipynb"
    assert mine.read_bytes() == source.with_suffix(".ipynb").read_bytes()
    mine.write_text("mine")
    source.write_text("# Frames\n\nA frame has an origin and axes.\n")
    built.build()
    (said,) = start_lectures(built.root)
    assert "lies beside it as 1_frames (new).ipynb" in said
    assert mine.read_text() == "mine"


def test_the_start_page_links_what_there_is_and_knows_what_is_done(built: Any) -> None:
    work = built.root / "work"
    start(built.root, "3.1")
    assert start_page_of(built.root) == ("begin with Start here.ipynb",)
    page = work / "Start here.ipynb"
    links = re.findall(r"\]\(([^)]+)\)", page.read_text())
    assert "3_01_say_it.ipynb" in links
    assert all((work / link).is_file() for link in links)
    assert "not checked yet" in page.read_text()
    (work / ".checked.json").write_text('{"3.1": {"points": 2, "of": 2, "status": "passed"}}')
    start_page_of(built.root)
    assert "2 of 2 points" in page.read_text()


def test_a_start_page_with_notes_of_the_student_is_left_alone(built: Any) -> None:
    start(built.root, "3.1")
    start_page_of(built.root)
    page = built.root / "work" / "Start here.ipynb"
    page.write_text(page.read_text().replace("# Welcome", "# My notes"))
    mine = page.read_bytes()
    assert start_page_of(built.root) == ()
    assert page.read_bytes() == mine
