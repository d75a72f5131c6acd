"""One launch file as XML, and what roslaunch says if it is none: the words of expat."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from simkit.launch.errors import Kind, LaunchPlace, LaunchRefused, Lesson
from simkit.launch.rules import SYNTAX
from simkit.xml import Document, Element, Fault, FaultKind, Span, parse_xml
from simkit.xml.parser import words_of_expat

_ROOT = "Invalid roslaunch XML syntax: no root <launch> tag"


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class LaunchFile:
    """One launch file."""

    name: str
    """How roslaunch names it: its path as it was given."""
    document: Document
    """What is in it."""
    data: bytes
    """The same, as it was read."""
    included_at: LaunchPlace | None = None
    """The `<include>` that names it; None for the file that was asked for."""

    def chain(self) -> list[LaunchPlace]:
        """The places that include it, the nearest first."""
        places = []
        place = self.included_at
        while place is not None:
            places.append(place)
            place = place.launch_file.included_at
        return places

    def xml_of(self, element: Element) -> str:
        """An element as roslaunch's messages show it: written anew, on the attributes' one line."""
        from xml.dom import minidom

        assert self.document.root is not None
        number = next(n for n, one in enumerate(self.document.root.walk()) if one is element)
        return minidom.parseString(self.data).getElementsByTagName("*")[number].toxml()


def read_launch_file(
    data: bytes, *, name: str, shown: str, included_at: LaunchPlace | None = None
) -> tuple[LaunchFile, Element]:
    """A launch file and its `<launch>` element.

    Args:
        data: The file's content.
        name: How roslaunch names it.
        shown: How it is shown to people.
        included_at: The `<include>` that names it.

    Raises:
        LaunchRefused: It is not XML, or no launch file.
    """
    document = parse_xml(data, file=shown)
    launch_file = LaunchFile(name=name, document=document, data=data, included_at=included_at)
    words = words_of_expat(document)
    if document.faults or words is not None:
        raise _not_xml(launch_file, words)
    assert document.root is not None
    found = [element for element in document.root.walk() if element.name == "launch"]
    if len(found) != 1:
        raise LaunchRefused(Kind.SYNTAX, _ROOT, _no_root(found)).at(
            LaunchPlace(launch_file=launch_file, span=(found[1] if found else document.root).span)
        )
    return launch_file, found[0]


def _not_xml(launch_file: LaunchFile, words: str | None) -> LaunchRefused:
    faults = launch_file.document.faults
    if faults:
        first = _cause_of(faults)
        what, remedy, span = first.what, first.remedy, first.span
    else:
        what, remedy, span = f"this is not XML: {words}", "Look at this place.", _place(words or "")
    text = f"Invalid roslaunch XML syntax: {words or what}"
    kind = Kind.SYNTAX if words else Kind.OURS
    return LaunchRefused(
        kind,
        text,
        Lesson(rule=SYNTAX, what=what, remedy=remedy),
        place=LaunchPlace(launch_file=launch_file, span=span),
    )


def _cause_of(faults: Sequence[Fault]) -> Fault:
    """The first fault, or the one that it follows from: a tag that is torn counts as not closed, too."""
    first = faults[0]
    if first.kind is not FaultKind.UNCLOSED:
        return first
    torn = (one for one in faults[1:] if one.kind is FaultKind.MALFORMED_TAG)
    return next((one for one in torn if one.span.line == first.span.line), first)


def _place(words: str) -> Span:
    """Line and column at the end of expat's words, in our counting."""
    numbers = [int(word) for word in words.replace(",", " ").split() if word.isdigit()]
    return Span(numbers[-2], numbers[-1] + 1) if len(numbers) >= 2 else Span(1, 1)


def _no_root(found: list[Element]) -> Lesson:
    what = (
        "a launch file has one <launch>, and here are several" if found else "here is no <launch>"
    )
    return Lesson(rule=SYNTAX, what=what, remedy="Put everything between <launch> and </launch>.")
