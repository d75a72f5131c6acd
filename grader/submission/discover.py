"""Who has handed in what: from folders and zip files to one list of submissions.

A path of the command line may be

* a notebook;
* a folder or zip file with notebooks: one submission, named after it;
* a folder or zip file of folders or zip files: one submission each.

Whose a file is follows from these names (rules: `owners`); nothing in a notebook says it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from grader.errors import SubmissionError
from grader.submission.found_file import FoundFile, read_item
from grader.submission.owners import Owner, assign_owners
from grader.submission.scan import scan
from grader.submission.submission import Submission

if TYPE_CHECKING:
    from grader.exercises import Exercise

MAX_PROBLEMS = 20
"""So many files of a student are named that cannot be read."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FoundSubmission:
    """What one student has handed in."""

    student: str
    submissions: dict[str, Submission]
    """Exercise id -> hand-in, where a notebook could be read."""
    unreadable: dict[str, str]
    """Exercise id -> why its notebook could not be read, as a sentence."""
    problems: tuple[str, ...]
    """Sentences about files that belong to no exercise or could not be read."""

    def submission(self, exercise: Exercise) -> Submission:
        """The hand-in for one exercise; an empty one if there is no notebook for it.

        Raises:
            SubmissionError: There is one, but it cannot be read.
        """
        if exercise.id in self.submissions:
            return self.submissions[exercise.id]
        if exercise.id in self.unreadable:
            raise SubmissionError(self.unreadable[exercise.id])
        missing = f"No notebook for exercise {exercise.id} was handed in."
        return Submission(
            student=self.student,
            exercise_id=exercise.id,
            files={},
            answers={},
            notes=(missing, *self.problems),
        )


def discover(paths: Iterable[Path], exercises: Mapping[str, Exercise]) -> list[FoundSubmission]:
    """Every submission below the paths, by name of the student.

    Notebooks are read here and now, one at a time; what is kept are files and answers.

    Args:
        paths: As given on the command line.
        exercises: The known ones by id.

    Raises:
        GraderError: A path does not exist, or is nothing that could hold a submission.
    """
    by_owner: dict[Owner, list[FoundFile]] = {}
    for path in dict.fromkeys(Path(path) for path in paths):
        findings = [read_item(item, exercises, path_name=path.name) for item in scan(path)]
        for owner, finding in assign_owners(path, findings):
            by_owner.setdefault(owner, []).append(finding)
    names = _distinct_names(list(by_owner))
    found = [_found(names[owner], findings) for owner, findings in by_owner.items()]
    return sorted(found, key=lambda one: (one.student.casefold(), one.student))


def _distinct_names(owners: Sequence[Owner]) -> dict[Owner, str]:
    """A name for each owner that no other has, not even with another case."""
    shared = Counter(owner.name.casefold() for owner in owners)
    names: dict[Owner, str] = {}
    taken: set[str] = set()
    for owner in owners:
        name = owner.name
        if shared[name.casefold()] > 1 and owner.number:
            name = f"{name} ({owner.number})"
        base, count = name, 1
        while name.casefold() in taken:
            count += 1
            name = f"{base} ({count})"
        taken.add(name.casefold())
        names[owner] = name
    return names


def _found(student: str, findings: list[FoundFile]) -> FoundSubmission:
    by_exercise: dict[str, list[FoundFile]] = {}
    for finding in findings:
        if finding.exercise is not None:
            by_exercise.setdefault(finding.exercise.id, []).append(finding)
    submissions: dict[str, Submission] = {}
    unreadable: dict[str, str] = {}
    problems = [f"{one.problem}." for one in findings if one.problem and one.exercise is None]
    if len(problems) > MAX_PROBLEMS:
        problems[MAX_PROBLEMS:] = [f"{len(problems) - MAX_PROBLEMS} more files cannot be read."]
    for exercise_id, candidates in by_exercise.items():
        readable = [one for one in candidates if one.submission is not None]
        faults = [f"{one.problem}." for one in candidates if one.problem][:MAX_PROBLEMS]
        if readable:
            submissions[exercise_id] = _best(readable, student, faults)
        else:
            unreadable[exercise_id] = " ".join(faults)
    if not by_exercise and not problems:
        problems.append("No notebook was found; hand in the .ipynb files.")
    return FoundSubmission(
        student=student,
        submissions=submissions,
        unreadable=unreadable,
        problems=tuple(problems),
    )


def _best(candidates: list[FoundFile], student: str, faults: list[str]) -> Submission:
    """Of several notebooks for one exercise: one with work in it, with the released name."""
    best = max(candidates, key=_rank)
    assert best.submission is not None  # by the choice of candidates
    notes = [*best.submission.notes, *faults]
    if len(candidates) > 1:
        names = ", ".join(sorted(one.name for one in candidates))
        notes.append(
            f"Several notebooks were handed in for this exercise ({names}); {best.name} was graded."
        )
    return replace(best.submission, student=student, notes=tuple(notes))


def _rank(finding: FoundFile) -> tuple[bool, bool, int, str]:
    submission, exercise = finding.submission, finding.exercise
    return (
        submission is not None and exercise is not None and submission.attempted(exercise),
        exercise is not None and finding.own_name == f"{exercise.slug}.ipynb",
        -len(finding.parts),
        "/".join(finding.parts),
    )
