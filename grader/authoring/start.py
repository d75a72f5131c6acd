"""Give a student their own copy of an exercise, without ever touching what they wrote."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path

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
    try:
        folders = _make_packages(exercise, work)
        notebook, message = _copy(exercise, root, work)
    except OSError as error:
        raise GraderError(f"cannot write to {work}: {error}") from error
    return Started(notebook=notebook, messages=(message, *folders))


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


def _copy(exercise: Exercise, root: Path, work: Path) -> tuple[Path, str]:
    released = root / "exercises" / f"{exercise.slug}.ipynb"
    mine = work / released.name
    record = _read_record(work)
    new = _fingerprint(released)
    if not mine.exists():
        _write(mine, released)
        _write_record(work, record | {exercise.slug: new})
        return mine, f"copied exercise {exercise.id} to {mine.name}"
    old = _fingerprint(mine)
    if new in (old, record.get(exercise.slug)):
        return mine, f"{mine.name} is there already and was left as it is"
    if old == record.get(exercise.slug):
        _write(mine, released)
        _write_record(work, record | {exercise.slug: new})
        return mine, f"{mine.name} was as given and is now the new version of the exercise"
    beside = _write_beside(mine, released)
    _write_record(work, record | {exercise.slug: new})
    return mine, (
        f"the exercise has changed since you began; your {mine.name} was left as it is, and the"
        f" new version lies beside it as {beside.name}"
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
