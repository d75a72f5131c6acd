"""Tells apart what learners do to attributes: forgotten quotation marks, none at all, those of a word processor, junk."""

from __future__ import annotations

from dataclasses import dataclass

from simkit.xml.letters import NAME, NAME_START, QUOTES, WHITE, Pattern, is_foreign, short, spoken

_NEXT = rf"(?<![ \t])[ \t]++{NAME}[ \t]*+="
_CUT = Pattern(rf"{_NEXT}[ \t]*+[\"']|/?>|[\n<]")
_STOP = Pattern(rf"{_NEXT}|[/\\]?>|[\n<]")
_NEXT_NAME = Pattern(rf"(?:^|{WHITE[0]}|\t|\n){NAME}[ \t\n]*+=[ \t\n]*+$")
_JUNK = Pattern(rf"[\"'/\\=]|[^{NAME_START[1:-1]} \t\n<>\"'/\\=]++")
_NAME_LENGTH = 200


@dataclass(frozen=True, kw_only=True)
class MissingQuote:
    """A value without a quotation mark at its end."""

    end: int
    """Where the value ends, most likely."""
    resume: int
    """Where reading goes on."""


@dataclass(frozen=True, kw_only=True)
class Unquoted:
    """A value without quotation marks that XML knows."""

    start: int
    """Where the value begins."""
    end: int
    """Where reading goes on."""
    value: str
    """The value that is meant."""
    what: str
    """What is wrong with it; follows on `the value of x`."""
    is_bare: bool
    """Whether nothing is wrong with it but that it stands in no quotation marks."""


def missing_quote(text: str, start: int, end: int) -> MissingQuote | None:
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
    return MissingQuote(end=start + len(value), resume=resume)


def unquoted_value(text: str, start: int) -> Unquoted | None:
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
    return Unquoted(start=first, end=end, value=value, what=what, is_bare=is_bare)


def junk_end(text: str, start: int) -> int:
    """Index behind something that does not belong into a tag."""
    found = _JUNK.match(text, start)
    return found.end() if found else start + 1


def describe_junk(junk: str) -> tuple[str, str] | None:
    """What is wrong with it, and what to do; None if it is nothing but letters that are a fault anywhere."""
    if all(map(is_foreign, junk)):
        return None
    if junk in ('"', "'"):
        return (
            f"there is a quotation mark {junk} too many",
            f"Delete it, or write name={junk}...{junk}",
        )
    if junk == "=":
        return "there is no name before this =", 'Write name="value"'
    if junk in (",", ";"):
        sign = {",": "commas", ";": "semicolons"}[junk]
        return f"attributes are separated by spaces, not by {sign}", f"Delete the {sign[:-1]}."
    if not junk.isascii() and len(set(junk)) == 1:
        return (
            f"in the tag stands {spoken(junk[0])}",
            "Delete it, and type a space where one is needed.",
        )
    return (
        f"{short(junk)} does not belong to an attribute",
        f'Delete it, or write name="{short(junk)}"',
    )
