"""Start tags, end tags and the text between them: what a file is made of. Reads tags, and gets over the faulty ones."""

from __future__ import annotations

import re
from typing import NamedTuple

from simkit.xml.attributes import AttributeList
from simkit.xml.document import Attribute, FaultKind
from simkit.xml.letters import NAME, SPACE, WHITE, Pattern, excerpt
from simkit.xml.source import Source


class StartTag(NamedTuple):
    """`<name attribute="value">` or `<name/>`."""

    name: str
    """Name of the element."""
    at: int
    """Where the name stands: index of its first letter."""
    end: int
    """Index behind the tag."""
    attributes: tuple[Attribute, ...]
    """Its attributes, each name once."""
    is_closed: bool
    """Whether it ends with `/>`."""
    is_broken: bool
    """Whether its end is faulty, and a fault says so: it may have been meant to end with `/>`."""


class EndTag(NamedTuple):
    """`</name>`."""

    name: str
    """Name of the element; empty if there is none, which a fault says."""
    at: int
    """Index of its `<`."""
    end: int
    """Index behind the tag."""


class Text(NamedTuple):
    """Text between tags."""

    value: str
    """The text, references replaced."""
    at: int
    """Index of its first letter in the file."""
    end: int
    """Index behind it."""
    is_plain: bool
    """Whether it is just letters: no reference, no CDATA section."""


Token = StartTag | EndTag | Text

_CLOSE = Pattern(rf"{SPACE}*+(/?)>")
_END_TAG = Pattern(rf"</({NAME}){SPACE}*+>")
_FAULTY_END_TAG = Pattern(rf"<{SPACE}*+[/\\]{SPACE}*+({NAME})?([^<>\n]*+)(>?)")
_NAME = Pattern(NAME)
_SLASH = Pattern(rf"([/\\]){SPACE}*+(>?)")


def read_start_tag(source: Source, at: int) -> StartTag:
    """The start tag whose name stands at `at`."""
    name = _NAME.match(source.text, at)
    assert name is not None, "the caller has seen a name here"
    attributes = AttributeList(source, name.end())
    close_at = _CLOSE.of(source.text).match
    while True:
        attributes.read_good_ones()
        close = close_at(source.text, attributes.at)
        if close is not None:
            found = tuple(attributes.found.values())
            return StartTag(name[0], at, close.end(), found, close[1] == "/", False)
        end = _faulty_end(source, name, attributes) or _end_of_file(source, name, attributes)
        if end is not None:
            return end
        attributes.get_over_fault()


def _start_tag(
    name: re.Match[str],
    attributes: AttributeList,
    end: int,
    *,
    is_closed: bool,
    is_broken: bool = False,
) -> StartTag:
    return StartTag(
        name=name[0],
        at=name.start(),
        end=end,
        attributes=tuple(attributes.found.values()),
        is_closed=is_closed,
        is_broken=is_broken,
    )


def _faulty_end(source: Source, name: re.Match[str], attributes: AttributeList) -> StartTag | None:
    """The tag, if it ends here in a faulty way: without `>`, or with a slash in the wrong place."""
    text, at = source.text, attributes.after_space()
    if at == len(text) or text[at] == "<":
        _missing_bracket(source, name, attributes)
        return _start_tag(name, attributes, at, is_closed=False, is_broken=True)
    slash = _SLASH.match(text, at)
    if slash is None:
        return None
    behind = text[slash.end() : slash.end() + 1]
    if slash[2]:
        attributes.fault(
            at,
            slash.end(),
            what=f"the tag <{excerpt(name[0])}> ends with {excerpt(slash[0])}, which is not />",
            remedy="Write />",
        )
        return _start_tag(name, attributes, slash.end(), is_closed=True)
    if behind in ("", "<"):
        _missing_bracket(source, name, attributes)
        return _start_tag(name, attributes, slash.end(), is_closed=True)
    return None


def _end_of_file(source: Source, name: re.Match[str], attributes: AttributeList) -> StartTag | None:
    """The tag, if the file ends in the middle of it."""
    if source.find(">", attributes.at) >= 0 or source.find("<", attributes.at) >= 0:
        return None
    end = len(source.text)
    last = len(source.text.rstrip(WHITE)) - 1
    attributes.fault(
        last,
        last + 1,
        what=f"the file ends in the middle of the tag <{excerpt(name[0])}>",
        remedy="Write the rest of the tag, and the end tags of all that is open.",
        other=source.span(*name.span()),
    )
    return _start_tag(name, attributes, end, is_closed=False, is_broken=True)


def _missing_bracket(source: Source, name: re.Match[str], attributes: AttributeList) -> None:
    """Note that a tag has no `>`, at the last letter that it has."""
    text, behind = source.text, attributes.after_space()
    if text[behind : behind + 1] in ("/", "\\"):
        behind += 1
    last = len(text[name.start() : behind].rstrip(WHITE)) + name.start() - 1
    where = "the file ends" if text.find("<", behind) < 0 else "the next tag begins"
    attributes.fault(
        last,
        last + 1,
        what=f"the tag <{excerpt(name[0])}> has no > at its end before {where}",
        remedy=f"Write > behind {excerpt(text[max(name.start(), last - 15) : last + 1])}"
        + ("" if text[last] == "/" else ", or /> if nothing stands in it."),
        other=source.span(name.start(), name.end()),
    )


def read_end_tag(source: Source, at: int) -> EndTag:
    """The end tag whose `<` stands at `at`."""
    found = _END_TAG.match(source.text, at)
    if found is not None:
        return EndTag(name=found[1], at=at, end=found.end())
    return _faulty_end_tag(source, at)


def is_faulty_end_tag(source: Source, at: int) -> bool:
    """Whether an end tag with a space before its slash, or with a backslash, stands here."""
    found = _FAULTY_END_TAG.match(source.text, at)
    return found is not None and found[1] is not None


def _faulty_end_tag(source: Source, at: int) -> EndTag:
    found = _FAULTY_END_TAG.match(source.text, at)
    assert found is not None, "the caller has seen </ here"
    name, rest = found[1] or "", found[2].strip(WHITE)
    end = found.end() if found[3] else found.end(1) if name else at + 2
    if not name:
        what, remedy = "this end tag has no name", "Write the name of the element that it closes."
    elif not found[3] and not rest:
        what, remedy = (
            f"the end tag </{excerpt(name)} has no > at its end",
            f"Write </{excerpt(name)}>",
        )
    elif rest:
        what = f"an end tag is only a name, but behind it stands {excerpt(rest)}"
        remedy = f"Write </{excerpt(name)}>"
    else:
        what = f"{excerpt(found[0])} is not an end tag: it begins with </ and then the name, without a space"
        remedy = f"Write </{excerpt(name)}>"
    source.fault(FaultKind.MALFORMED_TAG, at, max(at + 1, end), what=what, remedy=remedy)
    is_cut_off = not found[3] and source.find("<", end) < 0
    return EndTag(name="" if is_cut_off else name, at=at, end=end)
