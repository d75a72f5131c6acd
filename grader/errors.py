"""The errors of the grader, and the one that belongs to the student: CheckFailed."""

from __future__ import annotations


class GraderError(Exception):
    """Root of every error that the grader raises on purpose."""


class SourceError(GraderError):
    """A file that an author of exercises wrote has a fault; names file and line."""

    def __init__(self, text: str, *, file: str, line: int | None = None) -> None:
        self.text = text
        self.file = file
        self.line = line
        where = file if line is None else f"{file}:{line}"
        super().__init__(f"{where}: {text}")


class SubmissionError(GraderError):
    """A hand-in that cannot be read; the message is a sentence for the student."""


class ResultError(GraderError):
    """Something that claims to be a result of checks and is not."""


class SandboxError(GraderError):
    """The isolation that was asked for is not to be had on this machine."""


class CheckFailed(AssertionError):
    """A check's verdict on the student's work: never our own fault."""

    def __init__(
        self, message: str, *, expected: object = None, actual: object = None, hint: str = ""
    ) -> None:
        self.message = message
        self.expected = expected
        self.actual = actual
        self.hint = hint
        super().__init__(message)
