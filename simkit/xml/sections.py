"""What is neither tag nor text: comments, CDATA sections, processing instructions."""

from __future__ import annotations

import re

from simkit.xml.document import FaultKind
from simkit.xml.letters import NAME, SPACE, WHITE, short
from simkit.xml.pattern import Pattern
from simkit.xml.source import Source

_INSTRUCTION = Pattern(rf"<\?({NAME})(?:{SPACE}|(?=\?>))")


def read_comment(source: Source, at: int) -> int:
    """Index behind the comment that begins at `at`."""
    text = source.text
    end, inner = source.find("-->", at + 4), source.find("<!--", at + 4)
    if end < 0 or at + 4 <= inner <= end - 4:
        return _unclosed_comment(source, at, end, inner)
    dashes = text.find("--", at + 4, end + 2)
    if 0 <= dashes < end:
        source.fault(
            FaultKind.BAD_CHARACTER,
            dashes,
            dashes + 2,
            what="two hyphens cannot stand together inside of a comment",
            remedy="Write one hyphen, or = or ~ for a line.",
        )
    return end + 3


def _unclosed_comment(source: Source, at: int, end: int, inner: int) -> int:
    """Two comments, the first of which has no end; or one inside of another."""
    outer_end = source.find("-->", end + 3, is_ahead=True) if end >= 0 else -1
    third = source.find("<!--", end + 3, is_ahead=True) if end >= 0 else -1
    if outer_end >= 0 and (third < 0 or outer_end < third):
        source.fault(
            FaultKind.BAD_CHARACTER,
            inner,
            inner + 4,
            what="a comment cannot stand inside of another comment",
            remedy="Delete this <!-- and the --> that belongs to it.",
            other=source.span(at, at + 4),
        )
        return outer_end + 3
    line_end = source.find("\n", at)
    resume = len(source.text) if line_end < 0 else line_end
    if at + 4 <= inner < resume:
        resume = inner
    source.fault(
        FaultKind.UNCLOSED_SECTION,
        at,
        at + 4,
        what="this comment has no --> at its end",
        remedy="Write --> where the comment is to end.",
        other=source.span(inner, inner + 4) if inner >= at + 4 else None,
    )
    return resume


def read_cdata(source: Source, at: int) -> tuple[str, int]:
    """The text of the CDATA section that begins at `at`, and the index behind it."""
    start = at + len("<![CDATA[")
    end = source.find("]]>", start)
    if end >= 0:
        return source.text[start:end], end + 3
    source.fault(
        FaultKind.UNCLOSED_SECTION,
        at,
        start,
        what="this CDATA section has no ]]> at its end",
        remedy="Write ]]> where the text is to end.",
    )
    following = source.text.find("<", start)
    end = len(source.text) if following < 0 else following
    return source.text[start:end], end


def read_instruction(source: Source, at: int) -> int:
    """Index behind the processing instruction that begins at `at`."""
    name = _INSTRUCTION.match(source.text, at)
    end = source.find("?>", at + 2)
    if name is None or name[1].lower() == "xml":
        source.fault(
            FaultKind.MARKUP,
            at,
            at + 2,
            what="<? begins a processing instruction, but no name that it can have follows",
            remedy='Delete it; only <?xml version="1.0"?> at the beginning of the file is of use.',
        )
    elif end < 0:
        source.fault(
            FaultKind.UNCLOSED_SECTION,
            at,
            at + 2,
            what=f"{short(source.text[at : at + 30])} has no ?> at its end",
            remedy="Write ?> at its end, or delete it.",
        )
    return end + 2 if end >= 0 else end_of_line_or_bracket(source, at)


def end_of_line_or_bracket(source: Source, at: int) -> int:
    """Index behind the next `>` of this line; the end of the line, or the next `<`, if there is none before."""
    found = re.compile(r"[^>\n<]*+>?").match(source.text, at + 1)
    return found.end() if found else len(source.text.rstrip(WHITE))
