"""How finds look on a terminal, and as JSON."""

from __future__ import annotations

import os
import sys
import textwrap
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import IO, Any

from simkit.diagnostics.diagnostic import Diagnostic, Related, Severity
from simkit.diagnostics.snippet import snippet, visible
from simkit.xml import Span

WIDTH = 100
"""Columns that are used if nobody says how many there are."""
NARROWEST = 40
"""Fewer columns are not believed."""
VERSION = 1
"""Of the JSON: it changes when a key changes its meaning or goes."""

_LONGEST_SOURCE = 1000
_INDENT = "      "
_BOLD, _END = "\x1b[1m", "\x1b[0m"
_COLOURS = {
    Severity.ERROR: "\x1b[1;31m",
    Severity.WARNING: "\x1b[1;33m",
    Severity.NOTE: "\x1b[1;36m",
}


@dataclass(frozen=True, kw_only=True)
class Layout:
    """How finds are laid out."""

    width: int = WIDTH
    """Columns that there are."""
    colour: bool = False
    """Whether to use the colours of a terminal."""
    wraps_heads: bool = True
    """Whether the first line of a find is wrapped, too: editors, grep and CI want it on one line, however long."""

    @classmethod
    def of(cls, stream: IO[str]) -> Layout:
        """What suits a stream; `COLUMNS`, `NO_COLOR` and `TERM` of the environment are obeyed."""
        is_terminal = stream.isatty()
        plain = "NO_COLOR" in os.environ or os.environ.get("TERM") == "dumb"
        columns = os.environ.get("COLUMNS", "")
        width = int(columns) if columns.isdecimal() and int(columns) else WIDTH
        if not columns and is_terminal:
            with suppress(OSError):  # a terminal that does not say
                width = min(WIDTH, os.get_terminal_size(stream.fileno()).columns or WIDTH)
        return cls(
            width=max(NARROWEST, width),
            colour=is_terminal and not plain,
            wraps_heads=is_terminal,
        )


def as_text(
    diagnostics: Sequence[Diagnostic], *, colour: bool = False, layout: Layout | None = None
) -> str:
    """Finds for people: each with its line underlined, what follows from it, and what would be right.

    Args:
        diagnostics: What was found; shown in this order.
        colour: Whether to use the colours of a terminal, in a layout that is not given.
        layout: How to lay them out.
    """
    layout = layout or Layout(colour=colour)
    return "\n".join("\n".join(_block(one, layout)) + "\n" for one in diagnostics)


def as_json(diagnostics: Sequence[Diagnostic]) -> str:
    """Finds for programs: one JSON object, its keys in a fixed order.

    Lines and columns count from 1, columns and lengths in letters. Of a very long line the beginning is given.
    """
    counts = {f"{severity.value}s": _count(diagnostics, severity) for severity in Severity}
    listed = {
        "version": VERSION,
        "diagnostics": [_plain(one) for one in diagnostics],
        "summary": counts,
    }
    import json  # only programs ask for it

    return json.dumps(listed, indent=2)


def count_text(diagnostics: Sequence[Diagnostic]) -> str:
    """How many there are: `2 errors, 1 warning`, or `no faults found`."""
    counts = [(_count(diagnostics, severity), severity.value) for severity in Severity]
    parts = [f"{count} {word}{'' if count == 1 else 's'}" for count, word in counts if count]
    return ", ".join(parts) or "no faults found"


def _count(diagnostics: Sequence[Diagnostic], severity: Severity) -> int:
    return sum(one.severity is severity for one in diagnostics)


def _block(one: Diagnostic, layout: Layout) -> Iterator[str]:
    """The lines of one find."""
    paint = _COLOURS[one.severity] if layout.colour else ""
    yield from _headline(one, paint, layout)
    yield from _source_lines(one.source, one.span, paint, layout)
    sentences = (
        ("in", one.path),
        ("here", one.here),
        ("in ROS and Gazebo", one.gazebo),
        ("remedy", one.remedy),
    )
    for label, sentence in sentences:
        yield from _labelled(label, sentence, layout)
    for related in one.related:
        yield from _related(related, layout)


def _headline(one: Diagnostic, paint: str, layout: Layout) -> Iterator[str]:
    place = f"{visible(one.file)}:{one.span.line}:{one.span.column}:"
    kind = f"{one.severity.value} [{one.rule}]"
    width = layout.width if layout.wraps_heads else sys.maxsize
    lines = _wrapped(f"{place} {kind}", one.what, width)
    if paint:
        rest = lines[0].removeprefix(f"{place} {kind}")
        lines[0] = f"{_BOLD}{place}{_END} {paint}{kind}{_END}{rest}"
    yield from lines


def _labelled(label: str, sentence: str, layout: Layout) -> Iterator[str]:
    """A sentence behind its label; nothing if there is none."""
    if not sentence:
        return
    head = f"{_INDENT}{label}:"
    lines = _wrapped(head, sentence, layout.width)
    if layout.colour:
        lines[0] = f"{_INDENT}{_BOLD}{label}:{_END}{lines[0].removeprefix(head)}"
    yield from lines


def _wrapped(head: str, sentence: str, width: int) -> list[str]:
    """Text behind a head, in lines that hang below it."""
    return textwrap.wrap(
        visible(sentence.replace("\n", " ")),
        width,
        initial_indent=f"{head} ",
        subsequent_indent=f"{_INDENT}  ",
        break_long_words=False,
        break_on_hyphens=False,
    ) or [head]


def _source_lines(line: str, span: Span, paint: str, layout: Layout) -> Iterator[str]:
    """The line of the file with its number, and the line that underlines."""
    if not line:
        return
    gutter = f"{span.line:5} | "
    shown, underline = snippet(line, span, layout.width - len(gutter))
    yield (gutter + shown).rstrip()
    under = " " * (len(gutter) - 2) + "| "
    mark = underline.lstrip(" ")
    blank = underline[: len(underline) - len(mark)]
    yield f"{under}{blank}{paint}{mark}{_END if paint else ''}"


def _related(related: Related, layout: Layout) -> Iterator[str]:
    place = f"{related.file}:{related.span.line}:{related.span.column}: {related.text}"
    yield from _labelled("see", place, layout)
    yield from _source_lines(related.source, related.span, _BOLD if layout.colour else "", layout)


def _plain(one: Diagnostic) -> dict[str, Any]:
    """A find as JSON's values."""
    return {
        "rule": one.rule,
        "severity": one.severity.value,
        "file": one.file,
        **_place(one.span),
        "path": one.path,
        "what": one.what,
        "here": one.here,
        "gazebo": one.gazebo,
        "remedy": one.remedy,
        "source": one.source[:_LONGEST_SOURCE],
        "related": [
            {
                "file": related.file,
                **_place(related.span),
                "text": related.text,
                "source": related.source[:_LONGEST_SOURCE],
            }
            for related in one.related
        ],
    }


def _place(span: Span) -> dict[str, int]:
    return {"line": span.line, "column": span.column, "length": span.length}
