"""Give a student their own copy of an exercise, without ever touching what they wrote."""

from __future__ import annotations

import contextlib
import hashlib
import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from grader.authoring.lectures import FOLDER, lecture_paths
from grader.authoring.start_page import NAME, start_page
from grader.errors import GraderError, SubmissionError
from grader.exercises import Exercise, get_exercise
from grader.submission import read_notebook

RECORD = ".started.json"
"""File in the working folder: which state of each exercise was copied there."""
_PACKAGE = """\
<?xml version="1.0"?>
<package format="2">
  <name>{name}</name>
  <version>0.1.0</version>
  <description>Exercises of the workbook.</description>
  <maintainer email="student@example.com">student</maintainer>
  <license>BSD-3-Clause</license>
  <buildtool_depend>catkin</buildtool_depend>
  <exec_depend>rospy</exec_depend>
  <exec_depend>tf</exec_depend>
</package>
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Started:
    """What `start` did."""

    notebook: Path
    """The notebook to open."""
    messages: tuple[str, ...]
    """Sentences for the student."""


def start(root: Path, exercise_id: str, *, work: Path | None = None) -> Started:
    """Copy the notebook of an exercise to the working folder and make its package folders.

    Args:
        root: Folder of the workbook.
        exercise_id: E.g. "3.1".
        work: The working folder; `root/work` if None.

    Raises:
        UnknownNameError: There is no such exercise.
        GraderError: The working folder cannot be written.
    """
    exercise = get_exercise(root, exercise_id)
    work = work if work is not None else root / "work"
    with _written(work):
        folders = _make_packages(exercise, work)
        released = root / "exercises" / f"{exercise.slug}.ipynb"
        notebook = work / released.name
        what = f"exercise {exercise.id}"
        message = _copy(released, notebook, work, key=exercise.slug, what=what)
    return Started(notebook=notebook, messages=(message, *folders))


def start_lectures(root: Path, *, work: Path | None = None) -> tuple[str, ...]:
    """Copy the lectures to `lectures/` in the working folder, by the rules of `start`.

    Args:
        root: Folder of the workbook.
        work: The working folder; `root/work` if None.

    Returns:
        Sentences for the student.

    Raises:
        GraderError: The working folder cannot be written.
    """
    work = work if work is not None else root / "work"
    folder = work / FOLDER
    with _written(work):
        folder.mkdir(parents=True, exist_ok=True)
        return tuple(
            _copy(
                released, folder / released.name, work, key=f"{FOLDER}/{released.stem}", what=what
            )
            for released, what in _lectures(root)
        )


def start_page_of(root: Path, *, work: Path | None = None) -> tuple[str, ...]:
    """Lay the start page into the working folder, unless the student has made it their own.

    Args:
        root: Folder of the workbook.
        work: The working folder; `root/work` if None.

    Returns:
        Sentences for the student.

    Raises:
        GraderError: The working folder cannot be written.
    """
    work = work if work is not None else root / "work"
    page = work / NAME
    record = _read_record(work)
    if page.exists() and _fingerprint(page) != record.get(NAME):
        return ()
    with _written(work):
        page.write_text(start_page(root, work), encoding="utf-8", newline="\n")
        _write_record(work, record | {NAME: _fingerprint(page)})
    return (f"begin with {page.name}",)


@contextlib.contextmanager
def _written(work: Path) -> Iterator[None]:
    """Say in one sentence that the working folder cannot be written."""
    try:
        yield
    except OSError as error:
        raise GraderError(f"cannot write to {work}: {error}") from error


def _lectures(root: Path) -> Iterator[tuple[Path, str]]:
    """The notebook of each lecture that was built, and what it is."""
    for source in lecture_paths(root):
        notebook = source.with_suffix(".ipynb")
        if notebook.is_file():
            yield notebook, f"lecture {notebook.stem}"


def _make_packages(exercise: Exercise, work: Path) -> list[str]:
    messages = []
    for name in sorted(exercise.packages):
        manifest = work / name / "package.xml"
        manifest.parent.mkdir(parents=True, exist_ok=True)
        if not manifest.exists():
            manifest.write_text(_PACKAGE.format(name=name), encoding="utf-8")
            messages.append(f"made the ROS package {name}")
    for path in (*exercise.files, *exercise.stub_files):
        (work / path).parent.mkdir(parents=True, exist_ok=True)
    return messages


def _copy(released: Path, mine: Path, work: Path, *, key: str, what: str) -> str:
    """Lay a notebook into the working folder; what is said of it.

    Args:
        released: The notebook of the workbook.
        mine: The student's own copy of it.
        work: The working folder, which holds the record.
        key: Its name in the record.
        what: What it is, for the sentence: "exercise 3.1".
    """
    record = _read_record(work)
    new = _fingerprint(released)
    if not mine.exists():
        _write(mine, released)
        _write_record(work, record | {key: new})
        return f"copied {what} to {mine.relative_to(work).as_posix()}"
    old = _fingerprint(mine)
    if new in (old, record.get(key)):
        return f"{mine.name} is there already and was left as it is"
    if old == record.get(key):
        _write(mine, released)
        _write_record(work, record | {key: new})
        return f"{mine.name} was as given and is now the new version of the {what.split()[0]}"
    beside = _write_beside(mine, released)
    _write_record(work, record | {key: new})
    return (
        f"the {what.split()[0]} has changed since you began; your {mine.name} was left as it is,"
        f" and the new version lies beside it as {beside.name}"
    )


def _fingerprint(path: Path) -> str:
    """What the cells of a notebook say, as a short text; running them does not change it."""
    try:
        notebook = read_notebook(path)
    except SubmissionError:
        return "unreadable"
    cells = [[cell.kind, cell.source] for cell in notebook.cells]
    return hashlib.sha256(json.dumps(cells).encode()).hexdigest()


def _write(target: Path, released: Path) -> None:
    target.write_bytes(released.read_bytes())


def _write_beside(mine: Path, released: Path) -> Path:
    number = 1
    while True:
        name = f"{mine.stem} (new{'' if number == 1 else f' {number}'}).ipynb"
        target = mine.with_name(name)
        if not target.exists():
            _write(target, released)
            return target
        if _fingerprint(target) == _fingerprint(released):
            return target
        number += 1


def _read_record(work: Path) -> dict[str, str]:
    try:
        record = json.loads((work / RECORD).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return record if isinstance(record, dict) else {}


def _write_record(work: Path, record: dict[str, str]) -> None:
    text = json.dumps(record, indent=1, sort_keys=True) + "\n"
    (work / RECORD).write_text(text, encoding="utf-8")
