"""The hand-in as it lies on the student's own disk: what the notebook's `check()` grades."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from grader.errors import SubmissionError
from grader.submission.answers import NotAnAnswerError, plain_answer
from grader.submission.json_text import decode
from grader.submission.regular_file import read_regular_file
from grader.submission.submission import Submission

if TYPE_CHECKING:
    from grader.exercises import Exercise

MAX_FILE_BYTES = 1_000_000
"""Largest file that is read from the folder."""
_IMPORT = re.compile(r"^[ \t]*(?:from|import)[ \t]+([A-Za-z_]\w*)", re.MULTILINE)


def submission_from_folder(
    folder: Path, exercise: Exercise, answers: Mapping[str, object]
) -> Submission:
    """The hand-in that lies in a folder of packages.

    Read are the deliverables, the files that the released notebook writes, and Python files
    beside a deliverable that it imports.

    Args:
        folder: What the notebook calls its working folder (`work/`).
        exercise: Which exercise.
        answers: Name -> value, as the notebook knows them; unknown names, None and `...` are
            left out.
    """
    files: dict[str, str] = {}
    notes: list[str] = []
    for path in dict.fromkeys([*exercise.files, *exercise.stub_files]):
        _read(Path(folder), path, files, notes, wanted=path in exercise.files)
    for path in exercise.files:
        for helper in _imported(path, files.get(path, "")):
            if helper not in files and (Path(folder) / helper).is_file():
                _read(Path(folder), helper, files, notes, wanted=True)
                notes.append(
                    f"{helper} is used too; write it in this notebook with `%%writefile {helper}`,"
                    " or it is not handed in."
                )
    plain = _plain_answers(exercise, answers, notes)
    return Submission(
        student="",
        exercise_id=exercise.id,
        files=files,
        answers=plain,
        notes=tuple(notes),
    )


def _plain_answers(
    exercise: Exercise, answers: Mapping[str, object], notes: list[str]
) -> dict[str, object]:
    plain: dict[str, object] = {}
    for name in exercise.answers:
        try:
            value = plain_answer(answers.get(name))
        except NotAnAnswerError as error:
            notes.append(f"The answer {name} was not read: {error}.")
            continue
        if value is not None:
            plain[name] = value
    return plain


def _read(
    folder: Path, path: str, files: dict[str, str], notes: list[str], *, wanted: bool
) -> None:
    place = folder / path
    if not wanted and not place.exists():
        return
    try:
        text = decode(read_regular_file(place, MAX_FILE_BYTES))
    except SubmissionError as error:
        if not place.exists():
            notes.append(f"There is no file {path} yet; run the cell that writes it.")
        else:
            notes.append(f"{error}.")
        return
    files[path] = text.replace("\r\n", "\n").replace("\r", "\n")


def _imported(path: str, text: str) -> list[str]:
    """Paths where Python files that a script imports would lie beside it."""
    if not path.endswith(".py"):
        return []
    parent = path.rpartition("/")[0]
    return [f"{parent}/{name}.py" for name in dict.fromkeys(_IMPORT.findall(text))]
