"""From what a student hands in to files and answers, without running any of it."""

from grader.submission.discover import FoundSubmission, discover
from grader.submission.folder import submission_from_folder
from grader.submission.notebook import Cell, Notebook, notebook_from_bytes, read_notebook
from grader.submission.submission import (
    Submission,
    submission_from_notebook,
    submission_of,
)

__all__ = [
    "Cell",
    "FoundSubmission",
    "Notebook",
    "Submission",
    "discover",
    "notebook_from_bytes",
    "read_notebook",
    "submission_from_folder",
    "submission_from_notebook",
    "submission_of",
]
