"""Finds loops of joints, and links that hang on two joints."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from simkit.urdf.rules.entries import JointEntry
from simkit.urdf.rules.sheet import Sheet


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
    """Whether another joint before it has its name: the rule of names tells of that."""
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
