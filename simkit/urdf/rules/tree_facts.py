"""Which links the joints ask for in vain, and which links may be meant by that."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from simkit.urdf.rules.entries import JointEntry, LinkEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.xml import Attribute, Element

_MOST_LINKS = 200
"In a larger robot nobody looks for the link that a joint lacks; it takes long."


@dataclass(frozen=True, kw_only=True)
class Wanted:
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


def free_end(sheet: Sheet, joint: Element, role: str) -> str:
    """The link that a joint without one of its ends most likely joins, if only one comes into question; else nothing.

    Args:
        sheet: The robot.
        joint: The element of the joint.
        role: The end that it lacks, `parent` or `child`.
    """
    entry = sheet.joint_by_name.get(joint.get("name") or "")
    if entry is None or max(len(sheet.links), len(sheet.joints)) > _MOST_LINKS:
        return ""
    if role == "child":
        top = _top(sheet, entry.parent or "")
        likely = [name for name, link in sheet.link_by_name.items() if sheet.is_root(link)]
        likely = [name for name in likely if name != top]
    else:
        ends = [name for name in sheet.link_by_name if not sheet.joints_below.get(name)]
        likely = [name for name in ends if _top(sheet, name) != entry.child]
    return likely[0] if len(likely) == 1 else ""


def _top(sheet: Sheet, name: str) -> str:
    """The link that a link hangs on in the end; in a loop any of it."""
    seen: set[str] = set()
    while name not in seen and (above := sheet.joints_above.get(name)):
        seen.add(name)
        name = above[0].parent or name
    return name


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
