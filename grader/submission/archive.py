"""Notebooks inside zip files, read one by one in memory; nothing is ever unpacked to disk.

A name in an archive is a claim, its sizes are another, and its entries may be links: so names are
only labels here, bytes are counted while they come, and everything but a regular entry is refused.
"""

from __future__ import annotations

import io
import stat
import zipfile
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import IO

from grader.errors import SubmissionError
from grader.submission.notebook import MAX_NOTEBOOK_BYTES
from grader.submission.regular_file import too_large

MAX_ENTRIES = 20_000
"""Most entries of an archive, those of archives stored in it included."""
MAX_BYTES_PER_STUDENT = 256_000_000
"""Most bytes unpacked for one top folder or file of an archive."""
MAX_INNER_ARCHIVE_BYTES = 128_000_000
"""Largest archive inside an archive."""
MAX_PARTS = 12
"""Deepest path in an archive."""
_ENTRY_SIGNATURE = b"PK\x01\x02"
_READ_ERRORS = (
    zipfile.BadZipFile,
    zlib.error,
    OSError,
    EOFError,
    ValueError,
    RuntimeError,
    NotImplementedError,
    UnicodeError,
    OverflowError,
    IndexError,
    KeyError,
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """A file that was found: a notebook's bytes, or why there are none."""

    parts: tuple[str, ...]
    """Folders and name, for people; an archive counts as a folder named without its ending."""
    data: bytes | None = None
    problem: str = ""
    """A sentence, if there are no bytes."""
    is_folder: bool = False
    """Whether this says that a folder is there, or why it cannot be read."""


@dataclass(slots=True)
class _Budget:
    """Bytes that may still be unpacked, per top name of the outer archive."""

    left: dict[str, int] = field(default_factory=dict)

    def limit(self, top: str, most: int) -> int:
        return min(most, self.left.setdefault(top, MAX_BYTES_PER_STUDENT))

    def spend(self, top: str, size: int) -> None:
        self.left[top] -= size


def archive_items(file: IO[bytes], parts: tuple[str, ...]) -> Iterator[Item]:
    """Every notebook in an archive, and in the archives that it holds (one level).

    Args:
        file: The archive, seekable.
        parts: What to put before the names in it.
    """
    yield from _items(file, parts, budget=_Budget(), top=None)


def _items(
    file: IO[bytes], parts: tuple[str, ...], *, budget: _Budget, top: str | None
) -> Iterator[Item]:
    try:
        if _count_entries(file) > MAX_ENTRIES:
            raise SubmissionError(f"it holds more than {MAX_ENTRIES} files")
        archive = zipfile.ZipFile(file)
    except (SubmissionError, *_READ_ERRORS) as error:
        name = parts[-1] if parts else "the zip file"
        problem = f"{name} cannot be read as a zip file: {error}"
        yield Item(parts=parts, problem=problem, is_folder=True)
        return
    with archive:
        for info in sorted(archive.infolist(), key=lambda info: info.filename):
            yield from _entry(archive, info, parts, budget=budget, top=top)


def _count_entries(file: IO[bytes]) -> int:
    """At least the number of entries, known before the index of the archive is built."""
    file.seek(0)
    count, kept = 0, b""
    while block := file.read(1 << 20):
        block = kept + block
        count += block.count(_ENTRY_SIGNATURE)
        kept = block[-3:]
    file.seek(0)
    return count


def _entry(
    archive: zipfile.ZipFile,
    info: zipfile.ZipInfo,
    parts: tuple[str, ...],
    *,
    budget: _Budget,
    top: str | None,
) -> Iterator[Item]:
    try:
        names = _safe_parts(info.filename)
    except SubmissionError as error:
        yield Item(parts=(*parts, "?"), problem=str(error))
        return
    if not names or is_ignored(names):
        return
    here = (*parts, *names)
    if info.is_dir():
        yield Item(parts=here, is_folder=True)
        return
    kind = names[-1].rpartition(".")[2].lower()
    if kind != "ipynb" and (kind != "zip" or top is not None):
        return
    owner = top or names[0]
    most = MAX_NOTEBOOK_BYTES if kind == "ipynb" else MAX_INNER_ARCHIVE_BYTES
    try:
        data = _read(archive, info, budget.limit(owner, most), name=names[-1])
    except SubmissionError as error:
        yield Item(parts=here, problem=str(error))
        return
    budget.spend(owner, len(data))
    if kind == "ipynb":
        yield Item(parts=here, data=data)
    else:
        inside = (*here[:-1], here[-1][: -len(".zip")])
        yield Item(parts=inside, is_folder=True)
        yield from _items(io.BytesIO(data), inside, budget=budget, top=owner)


def is_ignored(names: tuple[str, ...]) -> bool:
    """Whether a path is litter of an operating system or of Jupyter, or hidden."""
    return any(name.startswith(".") or name == "__MACOSX" for name in names)


def _safe_parts(filename: str) -> tuple[str, ...]:
    names = [name for name in filename.replace("\\", "/").split("/") if name not in ("", ".")]
    if ".." in names or filename.startswith(("/", "\\")) or filename[1:2] == ":":
        raise SubmissionError(f"{filename[:80]!r} in the zip file leads out of it; not read")
    if len(names) > MAX_PARTS or len(filename) > 1000:
        raise SubmissionError(f"{filename[:80]!r} in the zip file lies too deep; not read")
    return tuple(names)


def _read(archive: zipfile.ZipFile, info: zipfile.ZipInfo, limit: int, *, name: str) -> bytes:
    mode = info.external_attr >> 16
    if stat.S_IFMT(mode) not in (0, stat.S_IFREG):
        raise SubmissionError(f"{name} is a link or no regular file; hand in the file itself")
    if info.flag_bits & 1:
        raise SubmissionError(f"{name} is locked with a password")
    if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise SubmissionError(f"{name} is packed in an unusual way; make a plain zip file")
    try:
        with archive.open(info) as file:
            data = file.read(limit + 1)
    except _READ_ERRORS as error:
        raise SubmissionError(f"{name} is damaged in the zip file ({error})") from error
    if len(data) > limit:
        raise SubmissionError(too_large(name, limit))
    return data
