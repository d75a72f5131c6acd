"""Saving: what can be seen goes into a file of the kind that its name asks for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TypeAlias

from simkit.errors import UnknownNameError

Formats: TypeAlias = Mapping[str, Callable[[], str | bytes]]
"""What makes the content of a file, by its suffix, e.g. `.svg`."""


def save_as(path: str | Path, formats: Formats, *, kind: str = "picture format") -> None:
    """Write a file in the format of its suffix.

    Args:
        path: Where to.
        formats: What there is to choose from.
        kind: What a suffix chooses, for the message.

    Raises:
        UnknownNameError: There is no such format.
        OSError: The file cannot be written.
    """
    path = Path(path)
    make = formats.get(path.suffix.lower())
    if make is None:
        raise UnknownNameError(kind, path.suffix, formats)
    content = make()
    if isinstance(content, bytes):
        path.write_bytes(content)
    else:  # half a character, which a frame may have in its name, is written as what it is
        path.write_text(content, encoding="utf-8", errors="backslashreplace", newline="\n")
