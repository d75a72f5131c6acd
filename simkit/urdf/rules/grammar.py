"""Walks the elements of a robot together with the word that each is meant to be."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.urdf.rules.meaning import meant_word
from simkit.urdf.rules.vocabulary import OTHER_TONGUES, WORDS
from simkit.xml import Element


def in_context(robot: Element) -> Iterator[tuple[Element, str]]:
    """The robot and all elements of URDF below it, each with the word of URDF that it is meant to be.

    Elements that may not stand where they stand are left out with all that is in them, but for links and joints, which the
    sheet lists as well. What is in `<gazebo>` and its kin is not of URDF.

    Args:
        robot: The root.

    Yields:
        Elements in the order of the text.
    """
    waiting = [(robot, "robot")]
    while waiting:
        element, word = waiting.pop()
        if word in WORDS:
            yield element, word
        if word not in OTHER_TONGUES:
            waiting.extend(reversed(list(_below(element, word))))


def _below(element: Element, word: str) -> Iterator[tuple[Element, str]]:
    words = WORDS[word].children if word in WORDS else ()
    for child in element.children:
        meaning = meant_word(child, words)
        if meaning is None and child.name in ("link", "joint"):
            meaning = child.name
        if meaning is not None or child.name not in OTHER_TONGUES:
            yield child, meaning or ""
