"""Reads the attributes of a start tag; what learners do to them is told apart in `attribute_faults`."""

from __future__ import annotations

import re
from typing import NamedTuple

from simkit.xml.attribute_faults import (
    MissingQuote,
    describe_junk,
    junk_end,
    missing_quote,
    unquoted_value,
)
from simkit.xml.document import Attribute, FaultKind, Span
from simkit.xml.letters import NAME, SPACE, WHITE, Pattern, short
from simkit.xml.references import TO_SPACE, replace_in_value
from simkit.xml.source import Source

_GOOD = Pattern(rf"{SPACE}++({NAME}){SPACE}*+={SPACE}*+(?:\"([^<&\"]*+)\"|'([^<&']*+)')")
_SPACES = Pattern(f"{SPACE}*+")
_NAME = Pattern(NAME)
_EQUALS = Pattern(rf"{SPACE}*+(=[={WHITE}]*+)?")
_QUOTED = Pattern(r"[\"']([^\"'\n<>]*+)")


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
            if self._mend(last):
                return
        start = self.after_space()
        name = _NAME.match(text, start)
        if name is not None:
            self._special(name, has_space=start > self.at)
            return
        self.at = junk_end(text, start)
        described = describe_junk(text[start : self.at])
        if described is not None:
            self.fault(start, self.at, what=described[0], remedy=described[1])
        self._is_quiet = True

    def _mend(self, last: _Place) -> bool:
        """Whether the fault lies in the attribute before, which looked right; if so it is read anew."""
        text = self._source.text
        cut = missing_quote(text, last.start, last.end)
        if cut is not None:
            self._cut(last, cut)
        return cut is not None

    def _special(self, name: re.Match[str], *, has_space: bool) -> None:
        """An attribute with a fault, or with references in its value."""
        text = self._source.text
        if not has_space:
            self.fault(
                *name.span(),
                what=f"there is no space before {short(name[0])}",
                remedy=f"Write a space before {short(name[0])}.",
                kind=FaultKind.LOOSE_ATTRIBUTE,
            )
        equals = _EQUALS.match(text, name.end())
        sign = (equals[1] if equals else None) or ""
        at = equals.end() if equals else name.end()
        is_quoted = text[at : at + 1] in ('"', "'")
        if sign.count("=") != 1:
            self._not_one_equals(name, sign, at)
        if is_quoted:
            self._quoted(name, at)
        elif sign:
            self._unquoted(name, at)
        else:
            self.at = name.end()

    def _not_one_equals(self, name: re.Match[str], sign: str, at: int) -> None:
        shown = short(_attribute_name(name))
        quoted = _QUOTED.match(self._source.text, at)
        remedy = f'Write {shown}="{short(quoted[1]) if quoted else "..."}"'
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
        cut = missing_quote(source.text, at + 1, end) if bracket >= 0 or end < 0 else None
        if cut is not None:
            self._cut(place, cut)
            return
        if bracket >= 0:
            source.fault(
                FaultKind.BAD_CHARACTER,
                bracket,
                bracket + 1,
                what=f"< cannot stand in the value of {short(name[0])}",
                remedy="Write &lt; instead.",
            )
        self._keep(place, *replace_in_value(source, at + 1, end))
        self.at = end + 1

    def _cut(self, place: _Place, cut: MissingQuote) -> None:
        """Let a value without a quotation mark at its end, the last one read, end earlier."""
        value = self._source.text[place.start : cut.end]
        self.fault(
            place.start - 1,
            cut.end,
            what=f"the value of {short(place.name)} has no quotation mark at its end",
            remedy=f'Write {short(place.name)}="{short(value)}"',
        )
        self._keep(_Place(place.name, place.name_at, place.start, cut.end), value)
        self._last = None
        self.at = cut.resume

    def _unquoted(self, name: re.Match[str], at: int) -> None:
        found = unquoted_value(self._source.text, at)
        if found is None:
            shown = short(name[0])
            self.fault(
                *name.span(),
                what=f"there is no value behind {shown}=",
                remedy=f'Write {shown}="...", or delete it.',
            )
            self.at = at
            return
        self.fault(
            at,
            found.end,
            what=f"the value of {short(name[0])} {found.what}",
            remedy=f'Write {short(name[0])}="{short(found.value)}"',
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
            what=f'{short(name)} stands twice in this tag: "{short(first.value)}" and "{short(value)}"',
            remedy=f"Delete one of the two {short(name)}=..., or rename the one that was meant to be another.",
            other=first.name_span,
        )
