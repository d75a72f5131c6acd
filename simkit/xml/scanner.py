"""Cuts a text into tags and text; what does not look like either is noted and got over."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.xml.document import FaultKind
from simkit.xml.letters import (
    FOREIGN_LETTERS,
    NAME,
    NAME_START,
    SPACE,
    WHITE,
    Pattern,
    excerpt,
    replace_references,
    spoken,
)
from simkit.xml.sections import (
    read_cdata,
    read_comment,
    read_declaration,
    read_doctype,
    read_instruction,
)
from simkit.xml.source import Source
from simkit.xml.tags import (
    EndTag,
    StartTag,
    Text,
    Token,
    is_faulty_end_tag,
    read_end_tag,
    read_start_tag,
)

_NAME_START = Pattern(NAME_START)
_SPACED_TAG = Pattern(rf"<{SPACE}++({NAME})(?!{SPACE}*+=)(?=[^<>]*+>)")
_NAMELESS_TAG = Pattern(rf"<{SPACE}*+(?:{NAME}{SPACE}*+=[^<>]*+)?>")
_XML_TAG = Pattern(rf"<xml{SPACE}++version[^<>]*+(?<!/)>")
_DECLARATION = Pattern(rf"<\?xml(?:{SPACE}|\?>)")
_CONFLICT = Pattern(r"(?<![^\n])<{7}(?: [^<\n]*)?(?=\n)")
_FOREIGN = Pattern(FOREIGN_LETTERS)
_SPACES = Pattern(f"{SPACE}*+")
_MAX_FOREIGN = 20
_MAX_OPEN = 10_000
"""Start tags without an end tag; with more of them reading ends, since nothing that deep is kept."""


def tokens_of(source: Source) -> list[Token]:
    """All tags and texts of a source, in order."""
    _note_foreign_letters(source)
    return list(_Scanner(source).tokens())


def _note_foreign_letters(source: Source) -> None:
    for number, found in enumerate(_FOREIGN.finditer(source.text)):
        if number == _MAX_FOREIGN:
            return
        source.fault(
            FaultKind.BAD_CHARACTER,
            *found.span(),
            what=f"{spoken(found[0])} cannot stand in an XML file",
            remedy="Delete it; it was most likely copied from somewhere else.",
        )


class _Scanner:
    def __init__(self, source: Source) -> None:
        self._source = source
        self._at = 0
        self._is_name_start = _NAME_START.of(source.text).match
        self._open = 0
        self._seen_element = False
        self._seen_doctype = False

    def tokens(self) -> Iterator[Token]:
        source, text = self._source, self._source.text
        while self._at < len(text) and not source.is_full and self._open < _MAX_OPEN:
            bracket = text.find("<", self._at)
            end = len(text) if bracket < 0 else bracket
            if end > self._at:
                yield self._text(self._at, end)
                self._at = end
            if bracket < 0:
                break
            faults = len(source.faults)
            following = text[bracket + 1 : bracket + 2]
            if following == "/":
                yield self._end_tag(bracket)
            elif self._seen_element and self._is_name_start(following):
                yield self._start_tag(bracket + 1)
            else:
                yield from self._markup(bracket)
            if len(source.faults) > faults:
                source.cut_off = self._is_cut_off()
        source.cut_off = source.cut_off or self._at < len(text)

    def _is_cut_off(self) -> bool:
        """Whether the text ends here, and not with a tag."""
        end = _SPACES.match(self._source.text, self._at)
        is_end = end is not None and end.end() == len(self._source.text)
        return is_end and not self._source.text.endswith(">", 0, self._at)

    def _text(self, start: int, end: int) -> Text:
        text = self._source.text
        value = text[start:end]
        if not value.strip(WHITE):  # as most texts are
            return Text(value, start, end, True)
        if text.find("]]>", start, end) >= 0:
            self._section_end(text.find("]]>", start, end))
        is_plain = text.find("&", start, end) < 0
        value = value if is_plain else replace_references(self._source, start, end)
        return Text(value=value, at=start, end=end, is_plain=is_plain)

    def _section_end(self, at: int) -> None:
        self._source.fault(
            FaultKind.BAD_CHARACTER,
            at,
            at + 3,
            what="]]> cannot stand in a text; it ends a CDATA section",
            remedy="Write ]]&gt; instead.",
        )

    def _markup(self, at: int) -> Iterator[Token]:
        """What begins with the `<` at `at`, which is no end tag."""
        source, text = self._source, self._source.text
        following = text[at + 1 : at + 2]
        if not self._seen_element and self._is_xml_tag(at):
            self._at = read_declaration(source, at)
        elif self._is_name_start(following):
            yield self._start_tag(at + 1)
        elif following == "?":
            reads = read_declaration if _DECLARATION.match(text, at) else read_instruction
            self._at = reads(source, at)
        elif following == "!":
            yield from self._declared(at)
        elif is_faulty_end_tag(source, at):
            yield self._end_tag(at)
        else:
            yield from self._bare_bracket(at)

    def _is_xml_tag(self, at: int) -> bool:
        """Whether an XML declaration stands here that begins with `<xml`."""
        found = _XML_TAG.match(self._source.text, at)
        return found is not None and self._source.find("</xml", at) < 0

    def _end_tag(self, at: int) -> EndTag:
        tag = read_end_tag(self._source, at)
        self._at = tag.end
        self._open -= self._open > 0
        return tag

    def _start_tag(self, name_at: int) -> StartTag:
        tag = read_start_tag(self._source, name_at)
        self._at = tag.end
        self._open += not tag.is_closed
        self._seen_element = True
        return tag

    def _declared(self, at: int) -> Iterator[Token]:
        """What begins with `<!`."""
        source, text = self._source, self._source.text
        if text.startswith("<!--", at):
            self._at = read_comment(source, at)
        elif text.startswith("<![CDATA[", at):
            value, self._at = read_cdata(source, at)
            yield Text(value=value, at=at, end=self._at, is_plain=False)
        else:
            if text.startswith("<!DOCTYPE", at) and (self._seen_doctype or self._seen_element):
                self._late_doctype(at)
            self._seen_doctype = True
            self._at = read_doctype(source, at)

    def _late_doctype(self, at: int) -> None:
        self._source.fault(
            FaultKind.MARKUP,
            at,
            at + len("<!DOCTYPE"),
            what="a document type can stand only once, and only before the first element",
            remedy="Delete it.",
        )

    def _bare_bracket(self, at: int) -> Iterator[Token]:
        """A `<` that begins nothing that XML knows."""
        source, text = self._source, self._source.text
        if (marker := _CONFLICT.match(text, at)) is not None:
            self._at = marker.end()
            what = "git has left a conflict here: two versions of this place, between <<<<<<< and >>>>>>>"
            remedy = "Keep one of the two, and delete the lines with <<<<<<<, ======= and >>>>>>>."
            source.fault(FaultKind.CONFLICT, at, self._at, what=what, remedy=remedy)
            return
        spaced = _SPACED_TAG.match(text, at)
        if spaced is not None:
            self._fault(
                at,
                spaced.end(),
                what=f"there is white space between < and {excerpt(spaced[1])}",
                remedy=f"Write <{excerpt(spaced[1])} without the space.",
            )
            yield self._start_tag(spaced.start(1))
            return
        nameless = _NAMELESS_TAG.match(text, at)
        if nameless is not None:
            self._at = nameless.end()
            remedy = "Write the name of the element behind <, or delete the tag."
            what = "this tag has no name"
            source.fault(FaultKind.MARKUP, at, self._at, what=what, remedy=remedy)
            return
        what = "< begins a tag, but no name follows"
        following = text[at + 1 : at + 2]
        if following.strip(WHITE):
            what = f"< begins a tag, but {spoken(following)} follows, and no name"
        source.fault(
            FaultKind.MALFORMED_TAG,
            at,
            at + 1,
            what=what,
            remedy="Delete it." if following == "<" else "Write &lt; for the sign <, or delete it.",
        )
        self._at = at + 1
        yield Text(value="<", at=at, end=at + 1, is_plain=True)

    def _fault(self, start: int, end: int, *, what: str, remedy: str) -> None:
        self._source.fault(FaultKind.MALFORMED_TAG, start, end, what=what, remedy=remedy)
