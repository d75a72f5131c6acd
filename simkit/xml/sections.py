"""What is neither tag nor text: comments, CDATA sections, processing instructions, the XML declaration, the document type."""

from __future__ import annotations

import re

from simkit.xml.document import FaultKind
from simkit.xml.letters import NAME, SPACE, WHITE, Pattern, excerpt
from simkit.xml.source import Source

_INSTRUCTION = Pattern(rf"<\?({NAME})(?:{SPACE}|(?=\?>))")
_DECLARATION = Pattern(
    rf"<\?xml{SPACE}+version{SPACE}*=(?P<version>{SPACE}*(?:\"[-\w.]*+\"|'[-\w.]*+'))"
    rf"(?:{SPACE}+encoding{SPACE}*={SPACE}*(?:\"[A-Za-z][-\w.]*+\"|'[A-Za-z][-\w.]*+'))?"
    rf"(?:{SPACE}+standalone{SPACE}*={SPACE}*(?:\"(?:yes|no)\"|'(?:yes|no)'))?{SPACE}*\?>",
    re.ASCII,
)
_PUBLIC = r"(?:\"[-'()+,./:=?;!*#@$_%\w \n]*+\"|'[-()+,./:=?;!*#@$_%\w \n]*+')"
_LITERAL = "(?:\"[^\"]*+\"|'[^']*+')"
_DOCTYPE = Pattern(
    rf"<!DOCTYPE{SPACE}++{NAME}"
    rf"(?:{SPACE}++(?:SYSTEM{SPACE}++{_LITERAL}|PUBLIC{SPACE}++(?a:{_PUBLIC}){SPACE}++{_LITERAL}))?+"
    rf"{SPACE}*+(?:(>)|(\[))"
)
_IN_SUBSET = Pattern("[]<\"'>]")


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
            what=f"{excerpt(source.text[at : at + 30])} has no ?> at its end",
            remedy="Write ?> at its end, or delete it.",
        )
    return end + 2 if end >= 0 else end_of_line_or_bracket(source, at)


def end_of_line_or_bracket(source: Source, at: int) -> int:
    """Index behind the next `>` of this line; the end of the line, or the next `<`, if there is none before."""
    found = re.compile(r"[^>\n<]*+>?").match(source.text, at + 1)
    return found.end() if found else len(source.text.rstrip(WHITE))


def read_declaration(source: Source, at: int) -> int:
    """Index behind `<?xml ... ?>`, which begins at `at`."""
    found = _DECLARATION.match(source.text, at)
    end = source.find("?>", at)
    line_end = source.find("\n", at)
    has_end = end >= 0 and (line_end < 0 or end < line_end)
    behind = end + 2 if has_end else end_of_line_or_bracket(source, at)
    if at > 0 and source.text.startswith("<?", at):
        _misplaced(source, at)
    elif found is None:
        what = "the XML declaration is malformed"
        is_ended = source.text.startswith("<?", at) and source.text[behind - 1] == ">"
        source.fault(
            FaultKind.MARKUP if is_ended else FaultKind.MALFORMED_TAG,
            at,
            at + 5,
            what=what if has_end else "the XML declaration has no ?> at its end",
            remedy='Write <?xml version="1.0"?> or <?xml version="1.0" encoding="UTF-8"?>',
        )
    return behind if found is None else found.end()


def _misplaced(source: Source, at: int) -> None:
    if source.is_full:
        return
    before = source.text[:at]
    if "<" not in before and before.strip(WHITE):
        return  # the text before it is a fault; without it this is none
    if not before.strip(WHITE):
        what = "only white space stands before <?xml ... ?>, which must be the very beginning of the file"
        remedy = f"Delete the white space before it: {_extent(before)}."
    else:
        what = "<?xml ... ?> must be the very beginning of the file, but something stands before it"
        remedy = "Move <?xml ... ?> up to line 1, column 1, or delete it."
    first = len(before) - len(before.lstrip(WHITE))
    other = source.span(first, first + 1) if before.strip(WHITE) else None
    source.fault(FaultKind.DECLARATION, at, at + 5, what=what, remedy=remedy, other=other)


def _extent(white: str) -> str:
    lines, letters = white.count("\n"), len(white)
    if lines:
        return "1 line" if lines == 1 else f"{lines} lines"
    return "1 letter" if letters == 1 else f"{letters} letters"


def read_doctype(source: Source, at: int) -> int:
    """Index behind the document type that begins at `at`."""
    found = _DOCTYPE.match(source.text, at)
    if found is None:
        source.fault(
            FaultKind.MARKUP,
            at,
            at + 2,
            what="this is neither a comment nor a document type that can be read",
            remedy="Delete it, or write <!-- ... --> if it is a comment.",
        )
        return end_of_line_or_bracket(source, at)
    if found[2] is None:
        return found.end()
    return _read_subset(source, at, found.end())


def _read_subset(source: Source, at: int, start: int) -> int:
    """Skip `[ ... ]>`; definitions in it are refused: they can blow up a small file to gigabytes."""
    end, has_definitions = _subset_end(source, start)
    if has_definitions:
        source.has_definitions = True
        source.fault(
            FaultKind.ENTITY,
            at,
            at + len("<!DOCTYPE"),
            what="this document type has definitions of its own, which are not read",
            remedy="Delete what stands in [ ... ], and write the texts themselves instead of entities.",
        )
    close = re.compile(rf"{SPACE}*+>").match(source.text, end)
    if close is not None:
        return close.end()
    source.fault(
        FaultKind.MALFORMED_TAG,
        at,
        at + len("<!DOCTYPE"),
        what="this document type has no ]> at its end",
        remedy="Write ]> where it is to end, or delete it.",
    )
    return end


def _subset_end(source: Source, start: int) -> tuple[int, bool]:
    """Index behind the `]` of a document type, and whether it defines anything."""
    text, at, has_definitions = source.text, start, False
    while not source.is_full and (found := _IN_SUBSET.search(text, at)) is not None:
        has_definitions = has_definitions or bool(text[at : found.start()].strip(WHITE))
        at = found.end()
        if found[0] == "]":
            return at, has_definitions
        if text.startswith("<!--", found.start()):
            at = read_comment(source, found.start())
        elif text.startswith("<?", found.start()):
            at = read_instruction(source, found.start())
        elif found[0] in "\"'":
            close = source.find(found[0], at)
            at = close + 1 if close >= 0 else at
        else:
            has_definitions = True
    return len(text), has_definitions
