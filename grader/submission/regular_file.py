"""Reading a file of a student: regular, not a link, not larger than allowed, never blocking."""

from __future__ import annotations

import os
import stat
from pathlib import Path
from typing import IO

from grader.errors import SubmissionError
from grader.submission.labels import label


def read_regular_file(path: Path, max_bytes: int) -> bytes:
    """The bytes of a regular file.

    Args:
        path: The file; a link in its last part is refused, not followed.
        max_bytes: Largest size that is read.

    Raises:
        SubmissionError: It is missing, a link, a pipe, a device, a folder, or too large.
    """
    with open_regular_file(path) as file:
        data = file.read(max_bytes + 1)
    if len(data) > max_bytes:
        raise SubmissionError(too_large(label(path.name), max_bytes))
    return data


def open_regular_file(path: Path) -> IO[bytes]:
    """A regular file, open for reading.

    Raises:
        SubmissionError: It is missing, a link, a pipe, a device or a folder.
    """
    name = label(path.name)
    # Without O_NONBLOCK the mere opening of a pipe would wait for its writer for ever.
    flags = os.O_RDONLY
    for flag in ("O_NOFOLLOW", "O_NONBLOCK", "O_CLOEXEC", "O_BINARY"):
        flags |= getattr(os, flag, 0)
    if path.is_symlink():
        raise SubmissionError(f"{name} is a link; hand in the file itself")
    try:
        descriptor = os.open(path, flags)
    except (OSError, ValueError) as error:
        raise SubmissionError(f"{name} cannot be read: {_reason(error)}") from error
    if not stat.S_ISREG(os.fstat(descriptor).st_mode):
        os.close(descriptor)
        raise SubmissionError(f"{name} is not a regular file; hand in the file itself")
    return os.fdopen(descriptor, "rb")


def too_large(name: str, max_bytes: int) -> str:
    """The sentence about a file larger than `max_bytes`."""
    return (
        f"{name} is larger than {max_bytes // 1_000_000} MB; in a notebook, clear the outputs"
        " (Edit > Clear Outputs of All Cells) and save"
    )


def _reason(error: Exception) -> str:
    return (error.strerror or str(error)) if isinstance(error, OSError) else str(error)
