"""The XML declaration and the document type: what may stand before the root element."""

from __future__ import annotations

import re

from simkit.xml.document import FaultKind
from simkit.xml.letters import NAME, SPACE, WHITE
from simkit.xml.pattern import Pattern
from simkit.xml.sections import end_of_line_or_bracket, read_comment, read_instruction
from simkit.xml.source import Source

_VALUE = r"=\s*(?:\"([^\"]*+)\"|'([^']*+)')".replace(r"\s", SPACE)
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
