"""Facts on the tree of links: which links joints ask for in vain, and which joints close a loop."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from simkit.diagnostics import Part
from simkit.urdf.rules.entries import JointEntry, LinkEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.xml import Element

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
    at: Part
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
                yield Wanted(joint=joint, role=role, name=name, at=Part(element, "link"))


def spare_links(sheet: Sheet) -> list[LinkEntry]:
    """Links without a name, and those whose name another link has before them: most likely they should be called otherwise."""
    return [
        link
        for link in sheet.links
        if link.name is None or sheet.link_by_name[link.name] is not link
    ]


def names_for_spare_links(sheet: Sheet) -> dict[str, LinkEntry]:
    """Spare links by the name that some joint asks for, as far as that name looks like no other link's.

    So a link that lost its name is reported where it stands, and not once more where a joint asks for it.
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


@dataclass(frozen=True, kw_only=True)
class Loop:
    """Joints that lead from a link back to itself."""

    joints: tuple[JointEntry, ...]
    """Its joints, from parent to child; the last one closes it, and is the one that is most likely wrong."""
    is_entered: bool
    """Whether a joint leads into it from outside."""

    @property
    def links(self) -> tuple[str, ...]:
        """The parent of each joint."""
        return tuple(str(joint.parent) for joint in self.joints)


def loops(sheet: Sheet) -> list[Loop]:
    """One loop of each set of links that lead to each other, in the order of the file."""
    place = {id(joint): number for number, joint in enumerate(sheet.joints)}
    found = [_loop(sheet, knot, place) for knot in _knots(sheet)]
    return sorted(found, key=lambda loop: place[id(loop.joints[-1])])


def two_parents(sheet: Sheet) -> Iterator[tuple[JointEntry, JointEntry]]:
    """Each joint whose child has another parent before it, with that one; not those that close a loop."""
    knot_of = {name: number for number, knot in enumerate(_knots(sheet)) for name in knot}
    for name, joints in sheet.joints_above.items():
        knot = knot_of.get(name)
        outer = [one for one in joints if knot is None or knot_of.get(one.parent or "") != knot]
        for joint in outer[1:]:
            if not _is_copy(sheet, joint):
                yield joint, outer[0]


def _is_copy(sheet: Sheet, joint: JointEntry) -> bool:
    """Whether another joint before it has its name: the rule of names reports that."""
    return joint.name is not None and sheet.joint_by_name[joint.name] is not joint


def _knots(sheet: Sheet) -> list[list[str]]:
    """Sets of links that lead to each other.

    Source:
        Kosaraju's two walks: the links in the order in which a walk down leaves them; then, the last one first, what leads to
        each.
    """
    below = {
        name: [joint.child for joint in joints if joint.child is not None]
        for name, joints in sheet.joints_below.items()
    }
    above = {
        name: [joint.parent for joint in joints if joint.parent is not None]
        for name, joints in sheet.joints_above.items()
    }
    left = _in_order_of_leaving(below)
    seen: set[str] = set()
    knots = []
    for name in reversed(left):
        knot = _unseen_from(name, above, seen)
        if len(knot) > 1 or name in below.get(name, ()):
            knots.append(knot)
    return knots


def _in_order_of_leaving(below: Mapping[str, list[str]]) -> list[str]:
    """All links that have joints; each behind those that a walk down from it comes to first."""
    order: list[str] = []
    seen: set[str] = set()
    for start in below:
        steps = [(start, iter(below[start]))] if start not in seen else []
        seen.add(start)
        while steps:
            name, children = steps[-1]
            child = next((one for one in children if one not in seen), None)
            if child is None:
                order.append(name)
                steps.pop()
            else:
                seen.add(child)
                steps.append((child, iter(below.get(child, ()))))
    return order


def _unseen_from(start: str, above: Mapping[str, list[str]], seen: set[str]) -> list[str]:
    if start in seen:
        return []
    seen.add(start)
    found = [start]
    for name in found:  # grows while it is read
        for parent in above.get(name, ()):
            if parent not in seen:
                seen.add(parent)
                found.append(parent)
    return found


def _loop(sheet: Sheet, knot: list[str], place: Mapping[int, int]) -> Loop:
    members = set(knot)
    leading = [joint for name in knot for joint in sheet.joints_above[name]]
    leading.sort(key=lambda joint: place[id(joint)])
    entry = next((joint for joint in leading if joint.parent not in members), None)
    inner = [joint for joint in leading if joint.parent in members]
    start = str((entry or inner[-1]).child)
    return Loop(joints=_way_round(sheet, start, members), is_entered=entry is not None)


def _way_round(sheet: Sheet, start: str, members: set[str]) -> tuple[JointEntry, ...]:
    """The shortest way from a link of a knot back to it."""
    came: dict[str, JointEntry] = {}
    waiting = [start]
    for name in waiting:  # grows while it is read
        for joint in sheet.joints_below.get(name, ()):
            child = joint.child
            if child is not None and child in members and child not in came:
                came[child] = joint
                waiting.append(child)
    way = [came[start]]
    while way[-1].parent != start:
        way.append(came[str(way[-1].parent)])
    return tuple(reversed(way))
