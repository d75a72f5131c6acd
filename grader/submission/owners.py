"""Whose a file is, by where it lies.

1. A name that Moodle or Canvas gave says it, but only at the top: what is below a student's own
   folder or archive was named by the student, who may claim anything.
2. Else a folder or archive is a student, and all below it is theirs. An archive on the command
   line that holds nothing but one folder is looked at inside that folder.
3. Notebooks beside each other at the top belong to one student, named after the folder or
   archive. But if two of them are for the same exercise, and neither name begins with the number
   of an exercise, their names are taken for students: alice.ipynb, alice_3_02.ipynb, bob.ipynb.
4. Folders and archives beside such notebooks are that student's too (old copies, packages),
   unless two of them hold the same exercise: then each is a student.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from grader.submission.found_file import FoundFile
from grader.submission.labels import label
from grader.submission.lms import lms_name

_NUMBER = re.compile(r"(?i)(?<![0-9a-z])[0-9s][ _.-]0?[0-9]{1,2}(?![0-9])")
"""The number of an exercise in the name of a file: 3_01, 3.1, S-1."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Owner:
    """A student, as far as names of files tell."""

    place: str
    """Path of the folder or archive on disk; two students of two places are never one."""
    name: str
    number: str = ""
    """What a learning management system knows them by, if it named the file."""


def assign_owners(path: Path, findings: list[FoundFile]) -> Iterator[tuple[Owner, FoundFile]]:
    """The owner of each thing that was found below a path of the command line.

    Args:
        path: That path.
        findings: What was found there.
    """
    if path.is_dir():
        place, name = path.resolve(), path.resolve().name
    elif path.suffix.lower() == ".zip":
        place, name = path.absolute(), path.stem
        findings = _inside_single_folder(findings)
    else:
        yield from ((_owner_of_notebook(path.absolute(), finding), finding) for finding in findings)
        return
    container = _named(str(place), name)
    own_files = _files_named_after_students(findings)
    owned = [(_owner(container, finding, own_files), finding) for finding in findings]
    if not _is_class(container, owned):
        owned = [(container, finding) for finding in findings]
    yield from owned
    if not owned:
        yield container, FoundFile(parts=(), own_name=container.name, is_folder=True)


def _named(place: str, name: str) -> Owner:
    """The owner that a name of a folder, archive or notebook says."""
    lms = lms_name(name)
    if lms is not None:
        return Owner(place=place, name=lms.student, number=lms.number)
    return Owner(place=place, name=label(name))


def _owner_of_notebook(path: Path, finding: FoundFile) -> Owner:
    place = str(path.parent)
    if lms_name(path.name) is None and _NUMBER.match(finding.own_name):
        return _named(place, path.parent.name)
    return _named(place, path.stem)


def _owner(container: Owner, finding: FoundFile, own_files: frozenset[str]) -> Owner:
    parts = finding.parts
    if container.number or not parts:
        return container
    if len(parts) > 1 or finding.is_folder or lms_name(parts[0]) is not None:
        return _named(container.place, parts[0])
    if parts[0] in own_files:
        return _named(container.place, _student_in(Path(parts[0]).stem))
    return container


def _student_in(stem: str) -> str:
    """The student in the name of a notebook: "alice" in "alice_3_01_final"."""
    number = _NUMBER.search(stem.replace("_", " "))
    return (stem[: number.start()].strip(" _.-") if number else "") or stem


def _inside_single_folder(findings: list[FoundFile]) -> list[FoundFile]:
    """The same findings without the folders that hold all of an archive."""
    while True:
        tops = {finding.parts[:1] for finding in findings}
        if len(tops) != 1 or tops == {()} or lms_name(findings[0].parts[0]) is not None:
            return findings
        if any(len(one.parts) == 1 and not one.is_folder for one in findings):
            return findings
        inner = [one for one in findings if len(one.parts) > 1]
        findings = [replace(one, parts=one.parts[1:]) for one in inner]


def _files_named_after_students(findings: list[FoundFile]) -> frozenset[str]:
    """Names of the notebooks at the top that stand for a student each (rule 3)."""
    unnumbered = [
        one
        for one in findings
        if len(one.parts) == 1 and one.exercise is not None and not _NUMBER.match(one.own_name)
    ]
    count = Counter(one.exercise.id for one in unnumbered if one.exercise is not None)
    if not any(number > 1 for number in count.values()):
        return frozenset()
    return frozenset(one.parts[0] for one in unnumbered)


def _is_class(container: Owner, owned: list[tuple[Owner, FoundFile]]) -> bool:
    """Whether what lies here are several students rather than one (rule 4)."""
    if all(owner != container for owner, _ in owned):
        return True
    others = {
        (owner, finding.exercise.id)
        for owner, finding in owned
        if owner != container and finding.exercise is not None
    }
    count = Counter(exercise_id for _, exercise_id in others)
    return any(number > 1 for number in count.values())
