"""Puts a start tag back that somebody deleted, so that one lost `<visual>` is one find and not five.

What stood in the element lies loose in the element around it, before an end tag that closes nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from simkit.urdf.rules.vocabulary import WORDS
from simkit.xml import Attribute, Document, Element, Fault, FaultKind, Span

_MOST = 40
"""Nobody loses more start tags; each costs a walk through the file."""


def with_lost_tags(document: Document) -> Element | None:
    """The root of a document; of one with lost start tags a copy of the whole in which they are back."""
    lost = [fault for fault in document.faults if fault.kind is FaultKind.STRAY_END]
    root = document.root
    if root is None or not lost or root.name not in WORDS:
        return root
    root = _copy(root)
    for fault in lost[:_MOST]:
        line = document.line(fault.span.line)[fault.span.column - 1 :]
        word = line[: fault.span.length].strip("</> ")
        if word in WORDS:
            _put_back(root, word, fault)
        elif word == "gazebo":
            _put_gazebo_back(root, fault)
    return root


def _copy(root: Element) -> Element:
    copies: dict[int, Element] = {}
    for element in root.walk():
        parent = None if element is root else copies[id(element.parent)]
        copy = Element(
            name=element.name,
            span=element.span,
            attributes=element.attributes,
            text=element.text,
            text_span=element.text_span,
            parent=parent,
        )
        copies[id(element)] = copy
        if parent is not None:
            parent.children.append(copy)
    return copies[id(root)]


def _put_back(root: Element, word: str, fault: Fault) -> None:
    """Wrap what lies loose before an end tag into an element of its name."""
    loose = _loose(root, word, fault.span)
    if loose:
        _wrap(loose, word, tuple(_attributes(root, word, fault.span, _kind(loose))))


def _put_gazebo_back(root: Element, fault: Fault) -> None:
    """Wrap what lies loose in the robot, and is none of its parts, into a `<gazebo>`: of a link, unless there is a plugin."""
    loose: list[Element] = []
    for child in reversed([child for child in root.children if child.span < fault.span]):
        is_part = child.name in WORDS["robot"].children and child.get("name") is not None
        if is_part or child.name == "gazebo":
            break
        loose.insert(0, child)
    link = next((link.get("name") for link in root.all("link")), None)
    is_of_robot = link is None or any(child.name == "plugin" for child in loose)
    span = fault.span
    of_link = Attribute(
        name="reference", value=link or "", name_span=span, value_span=span, written=""
    )
    if loose:
        _wrap(loose, "gazebo", () if is_of_robot else (of_link,))


def _wrap(loose: list[Element], word: str, attributes: tuple[Attribute, ...]) -> None:
    parent = loose[0].parent
    if parent is None:
        return
    span = loose[0].span
    back = Element(name=word, span=span, attributes=attributes, children=loose, parent=parent)
    place = next(number for number, one in enumerate(parent.children) if one is loose[0])
    parent.children[place : place + len(loose)] = [back]
    for child in loose:
        child.parent = back


def _loose(root: Element, word: str, end: Span) -> list[Element]:
    """The siblings just before an end tag that may stand in the element that it closes, and not where they stand."""
    before = [element for element in root.walk() if element.span < end]
    step: Element | None = before[-1] if before else None
    while step is not None and not _is_loose(step, word):
        step = step.parent
    if step is None or step.parent is None:
        return []
    earlier = [child for child in step.parent.children if child.span <= step.span]
    found: list[Element] = []
    while earlier and _is_loose(earlier[-1], word):
        found.append(earlier.pop())
    return found[::-1]


def _is_loose(element: Element, word: str) -> bool:
    around = None if element.parent is None else WORDS.get(element.parent.name)
    if around is None:
        return False
    fits_there = element.name in around.children
    return word in around.children and element.name in WORDS[word].children and not fits_there


def _kind(loose: list[Element]) -> str:
    """The type that a joint of these parts must have had."""
    parts = {child.name: child for child in loose}
    if "limit" in parts and parts["limit"].attribute("lower") is not None:
        return "revolute"
    return "continuous" if "limit" in parts or "axis" in parts else "fixed"


def _attributes(root: Element, word: str, span: Span, kind: str) -> Iterator[Attribute]:
    """The attributes that the lost tag must have had, with values that raise no other finds."""
    wanted = {"link": _wanted_links, "material": _wanted_materials}.get(word)
    name = next(wanted(root), "") if wanted is not None else ""
    values = {"name": name or f"{word}_of_line_{span.line}", "type": kind}
    for attribute in WORDS[word].required:
        value = values.get(attribute, "")
        yield Attribute(name=attribute, value=value, name_span=span, value_span=span, written="")


def _wanted_links(root: Element) -> Iterator[str]:
    """Links that a joint names and nobody defines."""
    links = {link.get("name") for link in root.all("link")}
    ends = [end for joint in root.all("joint") for end in joint.children]
    named = (end.get("link") for end in ends if end.name in ("parent", "child"))
    return (name for name in named if name and name not in links)


def _wanted_materials(root: Element) -> Iterator[str]:
    """Materials that a visual names and nobody defines."""
    used: Iterable[Element] = (one for one in root.walk() if one.name == "material")
    materials = list(used)
    defined = {one.get("name") for one in materials if one.children}
    return (
        name for one in materials if (name := one.get("name")) is not None and name not in defined
    )
