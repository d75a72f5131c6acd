"""How the rules name things in sentences, and what they say of things that ROS loses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from simkit.diagnostics import Severity
from simkit.diagnostics.table import Loss
from simkit.urdf.rules.meaning import nearest
from simkit.urdf.rules.values import shown
from simkit.xml import Element

_PARTS = ("inertial", "visual", "collision")
_HOLDERS = (*_PARTS, "material", "joint", "link", "robot")


def quoted(name: str | None) -> str:
    """A name of the file in a sentence, not too long."""
    return repr(shown(name or ""))


def listed(names: Iterable[str], most: int = 6) -> str:
    """Some names in a sentence: `'a', 'b', 'c' and 3 more`."""
    known = list(names)
    more = f" and {len(known) - most} more" if len(known) > most else ""
    return ", ".join(quoted(name) for name in known[:most]) + more


def called(element: Element) -> str:
    """An element in a sentence: `joint 'hip'`, `a link without a name`, `the robot`."""
    if element.parent is None:
        return "the robot"
    word = nearest(element.name, _HOLDERS) or shown(element.name)
    name = element.get("name")
    return f"a {word} without a name" if not name else f"{word} {quoted(name)}"


def owner(element: Element) -> Element:
    """The link, joint or material that an element is a part of, or itself if it is none; at last the robot."""
    while element.parent is not None and element.parent.parent is not None:
        element = element.parent
    return element


def part_of(element: Element) -> str:
    """Where an element stands, for a sentence: `the collision of link 'torso'`, `joint 'hip'`."""
    whole = called(owner(element))
    part = next((word for word in _words_up(element) if word in _PARTS), "")
    return f"the {part} of {whole}" if part else whole


def meant(near: Iterable[str]) -> str:
    """`Did you mean 'a' or 'b'? ` of some near names; nothing of none."""
    names = [quoted(name) for name in near]
    return f"Did you mean {' or '.join(names)}? " if names else ""


REFUSED = Loss(
    here="simkit refuses the file too.",
    gazebo="ROS refuses the whole file.",
    severity=Severity.ERROR,
)
"""What follows if ROS refuses the whole file."""


def loss(element: Element) -> Loss:
    """What follows if an element, or something in it, cannot be read.

    Source:
        urdfdom reads of a link the inertial, then the visuals, then the collisions, and stops at the first fault; a fault in a
        joint makes it refuse the file.
    """
    link = called(owner(element))
    here = "simkit loses the same."
    lost = {
        "inertial": f"ROS stops reading {link} here: its mass, all its visuals and all its collisions are lost, and yet "
        "the file is accepted.",
        "visual": f"ROS stops reading {link} here: this visual, those after it and all its collisions are lost, and yet "
        "the file is accepted.",
        "collision": f"ROS stops reading {link} here: this collision and those after it are lost, and yet the file is "
        "accepted.",
    }
    holder = _holder(element)
    if holder in lost:
        return Loss(severity=Severity.ERROR, here=here, gazebo=lost[holder])
    if holder == "material":
        return Loss(
            severity=Severity.WARNING, here=here, gazebo="ROS goes on without this material."
        )
    return REFUSED


def _words_up(element: Element | None) -> Iterator[str | None]:
    """The words of `_HOLDERS` that an element and those around it are, from the inside."""
    while element is not None:
        yield nearest(element.name, _HOLDERS)
        element = element.parent


def _holder(element: Element) -> str:
    """Which word of `_HOLDERS` holds an element.

    A visual goes without a material whose colour is faulty; a fault of the material itself costs the visual.
    """
    step: Element | None = element
    while step is not None:
        word = nearest(step.name, _HOLDERS)
        is_whole = step is element and step.parent is not None and step.parent.parent is not None
        if word is not None and not (word == "material" and is_whole):
            return word
        step = step.parent
    return "robot"
