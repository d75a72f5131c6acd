"""What a checker process receives: one submission to one exercise, as JSON."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from grader.exercises import Exercise, NodesMay
from grader.sandbox import Sandbox
from grader.submission import Submission


@dataclass(frozen=True, slots=True, kw_only=True)
class Job:
    """One run of checks."""

    exercise: Exercise
    submission: Submission
    sandbox: Sandbox
    folder: Path
    """Empty folder for the files of this run."""
    hidden: bool
    """Whether the hidden checks run too."""
    only_list: bool = False
    """Whether to say which checks there are, and run none."""
    for_author: bool = False
    """Whether results are for the author of the checks: with logs, and faults of checks undisguised."""

    def check_files(self) -> list[Path]:
        """The files of checks, in the order of their results."""
        hidden = self.exercise.hidden_checks if self.hidden else None
        return [self.exercise.public_checks, *([hidden] if hidden is not None else [])]

    def dumps(self) -> bytes:
        """The job as JSON."""
        value = {
            "exercise": _plain(asdict(self.exercise)),
            "submission": asdict(self.submission),
            "sandbox": self.sandbox.to_json(),
            "folder": str(self.folder),
            "hidden": self.hidden,
            "only_list": self.only_list,
            "for_author": self.for_author,
        }
        return json.dumps(value).encode()

    @classmethod
    def loads(cls, data: bytes) -> Job:
        """The job that `dumps` wrote; it comes from the runner, which is trusted."""
        value = json.loads(data)
        return cls(
            exercise=_exercise(value["exercise"]),
            submission=_submission(value["submission"]),
            sandbox=Sandbox.from_json(value["sandbox"]),
            folder=Path(value["folder"]),
            hidden=value["hidden"],
            only_list=value["only_list"],
            for_author=value["for_author"],
        )


def _plain(value: dict[str, Any]) -> dict[str, Any]:
    return {key: str(item) if isinstance(item, Path) else item for key, item in value.items()}


def _exercise(value: dict[str, Any]) -> Exercise:
    may = {key: tuple(names) for key, names in value["permissions"].items()}
    hidden = value["hidden_checks"]
    return Exercise(
        id=value["id"],
        slug=value["slug"],
        title=value["title"],
        package=value["package"],
        files=tuple(value["files"]),
        answers=tuple(value["answers"]),
        permissions=NodesMay(**may),
        public_checks=Path(value["public_checks"]),
        hidden_checks=Path(hidden) if hidden is not None else None,
        stub_files=value["stub_files"],
    )


def _submission(value: dict[str, Any]) -> Submission:
    return Submission(
        student=value["student"],
        exercise_id=value["exercise_id"],
        files=value["files"],
        answers=value["answers"],
        notes=tuple(value["notes"]),
    )
