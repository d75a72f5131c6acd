"""Reads the attributes of a start tag, and tells apart what learners do to them.

They forget quotation marks, or all of them, take those of a word processor, or leave junk between attributes.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from simkit.xml.document import Attribute, FaultKind, Span
from simkit.xml.letters import (
    NAME,
    NAME_START,
    QUOTES,
    SPACE,
    TO_SPACE,
    WHITE,
    Pattern,
    excerpt,
    is_foreign,
    replace_in_value,
    words_on_junk,
)
from simkit.xml.source import Source

_GOOD = Pattern(rf"{SPACE}++({NAME}){SPACE}*+={SPACE}*+(?:\"([^<&\"]*+)\"|'([^<&']*+)')")
_SPACES = Pattern(f"{SPACE}*+")
_NAME = Pattern(NAME)
_EQUALS = Pattern(rf"{SPACE}*+(=[={WHITE}]*+)?")
_QUOTED = Pattern(r"[\"']([^\"'\n<>]*+)")
_NEXT = rf"(?<![ \t])[ \t]++{NAME}[ \t]*+="
_CUT = Pattern(rf"{_NEXT}[ \t]*+[\"']|/?>|[\n<]")
_STOP = Pattern(rf"{_NEXT}|[/\\]?>|[\n<]")
_NEXT_NAME = Pattern(rf"(?:^|{WHITE[0]}|\t|\n){NAME}[ \t\n]*+=[ \t\n]*+$")
_JUNK = Pattern(rf"[\"'/\\=]|[^{NAME_START[1:-1]} \t\n<>\"'/\\=]++")
_NAME_LENGTH = 200


class _Cut(NamedTuple):
    """A value without a quotation mark at its end: index behind the value, most likely, and where reading goes on."""

    end: int
    resume: int


class _Unquoted(NamedTuple):
    """A value without quotation marks that XML knows: its place, what is meant, and what is wrong with it."""

    start: int
    end: int
    value: str
    what: str
    is_bare: bool


class _Place(NamedTuple):
    """Where an attribute stands: index of its name, and of its value's first letter and of the one behind it."""

    name: str
    name_at: int
    start: int
    end: int


def _attribute_name(name: re.Match[str]) -> str:
    """The name of an attribute; of `name: "x"` without the colon, which XML takes for a letter."""
    bare = name[0].rstrip(":")
    has_equals = _EQUALS.match(name.string, name.end())
    return name[0] if not bare or (has_equals and has_equals[1]) else bare


class AttributeList:
    """The attributes of one start tag, read one by one.

    Of one mistake only one fault is reported: behind a fault, further ones count only after an attribute that is right.

    Args:
        source: The text.
        at: Index behind the tag's name.
    """

    def __init__(self, source: Source, at: int) -> None:
        self.at = at
        """Index of the first letter that is not read yet."""
        self.found: dict[str, Attribute] = {}
        """Attributes by name, in the order of the text."""
        self._source = source
        self._is_quiet = False
        self._last: _Place | None = None

    def after_space(self) -> int:
        """Index of the first letter not read yet that is not white space."""
        found = _SPACES.match(self._source.text, self.at)
        return found.end() if found else self.at

    def fault(
        self,
        start: int,
        end: int,
        *,
        what: str,
        remedy: str,
        other: Span | None = None,
        kind: FaultKind = FaultKind.MALFORMED_TAG,
    ) -> None:
        """Note that the tag is malformed, unless that follows from a fault right before."""
        if not self._is_quiet:
            self._source.fault(kind, start, end, what=what, remedy=remedy, other=other)
        self._is_quiet = True

    def read_good_ones(self) -> None:
        """Read attributes as long as there is nothing special about them."""
        text = self._source.text
        match, last = _GOOD.of(text).match, None
        while (found := match(text, self.at)) is not None:
            last = found
            self.at = end = found.end()
            name, value, other = found.groups()
            written = value if other is None else other
            name_at, start = found.start(1), end - 1 - len(written)
            if name in self.found or "\n" in written or "\t" in written:
                self._keep(_Place(name, name_at, start, end - 1), written)
            else:
                self.found[name] = Attribute(
                    name, written, written, name_at, start, end - 1, self._source
                )
        if last is not None:
            start, end = last.span(2 if last[3] is None else 3)
            self._last = _Place(last[1], last.start(1), start, end)
            self._is_quiet = False

    def get_over_fault(self) -> None:
        """Read at least one letter of something that is no simple attribute."""
        text, last = self._source.text, self._last
        if last is not None and last.end + 1 == self.at:
            self._last = None
            cut = _missing_quote(text, last.start, last.end)
            if cut is not None:  # the fault lies in the attribute before, which looked right
                self._cut(last, cut)
                return
        start = self.after_space()
        name = _NAME.match(text, start)
        if name is not None:
            self._special(name, has_space=start > self.at)
            return
        self.at = _junk_end(text, start)
        junk = text[start : self.at]
        if not all(map(is_foreign, junk)):  # which are faults anywhere
            what, remedy = words_on_junk(junk)
            self.fault(start, self.at, what=what, remedy=remedy)
        self._is_quiet = True

    def _special(self, name: re.Match[str], *, has_space: bool) -> None:
        """An attribute with a fault, or with references in its value."""
        text = self._source.text
        if not has_space:
            self.fault(
                *name.span(),
                what=f"there is no space before {excerpt(name[0])}",
                remedy=f"Write a space before {excerpt(name[0])}.",
                kind=FaultKind.LOOSE_ATTRIBUTE,
            )
        equals = _EQUALS.match(text, name.end())
        sign = (equals[1] if equals else None) or ""
        at = equals.end() if equals else name.end()
        if sign.count("=") != 1:
            self._not_one_equals(name, sign, at)
        if text[at : at + 1] in ('"', "'"):
            self._quoted(name, at)
        elif sign:
            self._unquoted(name, at)
        else:
            self.at = name.end()

    def _not_one_equals(self, name: re.Match[str], sign: str, at: int) -> None:
        shown = excerpt(_attribute_name(name))
        quoted = _QUOTED.match(self._source.text, at)
        remedy = f'Write {shown}="{excerpt(quoted[1]) if quoted else "..."}"'
        if sign:
            what = f"{shown} has more than one ="
        elif self._source.text[at : at + 1] in ('"', "'"):
            what = f"there is no = between {shown} and its value"
        else:
            what = f"{shown} stands here without a value"
            remedy = f'Write {shown}="...", or delete it.'
        self.fault(*name.span(), what=what, remedy=remedy)

    def _quoted(self, name: re.Match[str], at: int) -> None:
        """A value that begins with the quotation mark at `at`; perhaps without one at its end."""
        source = self._source
        end = source.find(source.text[at], at + 1)
        self._last = place = _Place(_attribute_name(name), name.start(), at + 1, end)
        bracket = source.text.find("<", at + 1, end) if end >= 0 else -1
        cut = _missing_quote(source.text, at + 1, end) if bracket >= 0 or end < 0 else None
        if cut is not None:
            self._cut(place, cut)
            return
        if bracket >= 0:
            what = f"< cannot stand in the value of {excerpt(name[0])}"
            remedy, kind = "Write &lt; instead.", FaultKind.BAD_CHARACTER
            source.fault(kind, bracket, bracket + 1, what=what, remedy=remedy)
        self._keep(place, *replace_in_value(source, at + 1, end))
        self.at = end + 1

    def _cut(self, place: _Place, cut: _Cut) -> None:
        """Let a value without a quotation mark at its end, the last one read, end earlier."""
        value = self._source.text[place.start : cut.end]
        self.fault(
            place.start - 1,
            cut.end,
            what=f"the value of {excerpt(place.name)} has no quotation mark at its end",
            remedy=f'Write {excerpt(place.name)}="{excerpt(value)}"',
        )
        self._keep(_Place(place.name, place.name_at, place.start, cut.end), value)
        self._last = None
        self.at = cut.resume

    def _unquoted(self, name: re.Match[str], at: int) -> None:
        found, shown = _unquoted_value(self._source.text, at), excerpt(name[0])
        if found is None:
            what = f"there is no value behind {shown}="
            self.fault(*name.span(), what=what, remedy=f'Write {shown}="...", or delete it.')
            self.at = at
            return
        self.fault(
            at,
            found.end,
            what=f"the value of {shown} {found.what}",
            remedy=f'Write {shown}="{excerpt(found.value)}"',
            kind=FaultKind.LOOSE_ATTRIBUTE if found.is_bare else FaultKind.MALFORMED_TAG,
        )
        end = found.start + len(found.value)
        self._keep(_Place(name[0], name.start(), found.start, end), found.value)
        self._last = None
        self.at = found.end

    def _keep(self, place: _Place, written: str, normalised: str | None = None) -> None:
        """Keep an attribute; of several of one name the first."""
        source, name = self._source, place.name
        value = written if normalised is None else normalised
        if normalised is None and ("\n" in written or "\t" in written):
            value = written.translate(TO_SPACE)
        one = Attribute(name, value, written, place.name_at, place.start, place.end, source)
        first = self.found.get(name)
        if first is None or first.name_at == one.name_at:
            self.found[name] = one
            return
        source.fault_at(
            FaultKind.DUPLICATE_ATTRIBUTE,
            one.name_span,
            what=f'{excerpt(name)} stands twice in this tag: "{excerpt(first.value)}" and "{excerpt(value)}"',
            remedy=f"Delete one of the two {excerpt(name)}=..., or rename the one that was meant to be another.",
            other=first.name_span,
        )


def _missing_quote(text: str, start: int, end: int) -> _Cut | None:
    """Whether a value that begins at `start`, and ends before the quotation mark at `end`, was meant to end earlier.

    Its closing quotation mark is then the opening one of another attribute. `end` is -1 if there is none at all.
    """
    value = text[start : len(text) if end < 0 else end]
    behind = text[end + 1 : end + 2]
    reaches_on = "<" in value and ("\n" in value or (behind not in WHITE and behind not in "/>"))
    if end >= 0 and not reaches_on and _NEXT_NAME.search(value[-_NAME_LENGTH:]) is None:
        return None
    cut = _CUT.search(text, start)
    resume = cut.start() if cut else len(text)
    value = text[start:resume].rstrip(WHITE)
    other = "'" if text[start - 1] == '"' else '"'
    value = value[:-1] if value.endswith(other) and value.count(other) == 1 else value
    return _Cut(end=start + len(value), resume=resume)


def _unquoted_value(text: str, start: int) -> _Unquoted | None:
    """The value that begins at `start` without a quotation mark; None if there is none."""
    stop = _STOP.search(text, start)
    end = stop.start() if stop else len(text)
    raw = text[start:end].rstrip(WHITE)
    value = raw.strip(QUOTES + "\"'")
    if not value:
        return None
    if raw[0] in QUOTES:
        what = f"stands between {raw[0]} {raw[-1]}, quotation marks of a word processor; XML has \" and '"
    elif raw[-1] in "\"'":
        what = "has no quotation mark at its beginning"
    else:
        what = "does not stand in quotation marks"
    first = start + raw.index(value[0]) if raw[0] in QUOTES else start
    is_bare = raw == value and not any(letter in WHITE for letter in value)
    return _Unquoted(start=first, end=end, value=value, what=what, is_bare=is_bare)


def _junk_end(text: str, start: int) -> int:
    """Index behind something that does not belong into a tag."""
    found = _JUNK.match(text, start)
    return found.end() if found else start + 1
