"""Which links the joints ask for in vain, and which links may be meant by that."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.record import Record
from simkit.urdf.rules.entries import JointEntry, LinkEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.xml import Attribute, Element


class Wanted(Record):
    """A joint names a link that does not exist."""

    joint: JointEntry
    role: str
    """`parent` or `child`."""
    name: str
    """The name that it asks for."""
    at: Attribute | Element
    """Where it does."""


def wanted_links(sheet: Sheet) -> Iterator[Wanted]:
    """Each place where a joint names a link that does not exist, in the order of the file."""
    for joint in sheet.joints:
        ends = (
            ("parent", joint.parent_element, joint.parent),
            ("child", joint.child_element, joint.child),
        )
        for role, element, name in ends:
            if element is not None and name is not None and name not in sheet.link_by_name:
                at = element.attribute("link") or element
                yield Wanted(joint=joint, role=role, name=name, at=at)


def spare_links(sheet: Sheet) -> list[LinkEntry]:
    """Links without a name, and those whose name another link has before them: most likely they should be called otherwise."""
    return [
        link
        for link in sheet.links
        if link.name is None or sheet.link_by_name[link.name] is not link
    ]


def names_for_spare_links(sheet: Sheet) -> dict[str, LinkEntry]:
    """Spare links by the name that some joint asks for, as far as that name looks like no other link's.

    So a link that lost its name is told of where it stands, and not once more where a joint asks for it.
    """
    spare = spare_links(sheet)
    found: dict[str, LinkEntry] = {}
    if spare:
        for wanted in wanted_links(sheet):
            if len(found) == len(spare):
                break
            if wanted.name not in found and not sheet.near(wanted.name, sheet.link_by_name):
                found[wanted.name] = spare[len(found)]
    return found


def is_whole(sheet: Sheet) -> bool:
    """Whether the links make one tree, so that rules about the whole robot make sense.

    Where a joint names a link that does not exist, or a link hangs on nothing, a find about that is enough.
    """
    roots = [link for link in sheet.link_by_name.values() if sheet.is_root(link)]
    if len(roots) != 1 or spare_links(sheet):
        return False
    seen = {str(roots[0].name)}
    waiting = list(seen)
    while waiting:
        for joint in sheet.joints_below.get(waiting.pop(), ()):
            if joint.child in seen or joint.child not in sheet.link_by_name:
                return False
            seen.add(str(joint.child))
            waiting.append(str(joint.child))
    return len(seen) == len(sheet.link_by_name)
