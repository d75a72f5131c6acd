"""Lumps: links that Gazebo makes one body of, since fixed joints hold them together.

A link hangs on its parent by a fixed joint: Gazebo moves its mass, shapes and sensors into the parent, and the link
is gone. It does not do so where the parent is `world`, or where a `<gazebo>` of the joint asks it not to.
"""

from __future__ import annotations

from collections.abc import Mapping

from simkit.record import Record
from simkit.urdf.rules.bodies import mass_of
from simkit.urdf.rules.entries import LinkEntry
from simkit.urdf.rules.gazebo_words import tag_value
from simkit.urdf.rules.sheet import Sheet

WORLD = "world"
"""A root link of this name is the ground; what hangs on it by a fixed joint cannot move."""

_SMALL = 0.1
"The inertia of a link with a smaller share of the mass of its lump hardly counts."

KEEPING = ("preserveFixedJoint", "disableFixedJointLumping")
"""Tags of a joint that keep Gazebo from lumping."""


class Lump(Record):
    """One body of Gazebo."""

    leader: LinkEntry
    """The link that keeps its name: the one nearest to the root."""
    members: tuple[LinkEntry, ...]
    """All links in it, the leader too, in the order of the file."""
    mass: float
    """Mass of all [kg]; 0 if none of them has one."""

    is_held: bool
    """Whether a fixed joint ties it to `world`, so that it cannot move."""

    @property
    def touches(self) -> bool:
        """Whether any of its links has a collision shape."""
        return any(link.collisions for link in self.members)


def lumps(sheet: Sheet) -> dict[str, Lump]:
    """The lump of each link, by the name of the link; `world` is a lump of its own."""
    above = parents_by_fixed_joint(sheet)
    leaders: dict[str, str] = {}
    for name in sheet.link_by_name:
        _find_leader(name, above, leaders)
    groups: dict[str, list[LinkEntry]] = {}
    for name, link in sheet.link_by_name.items():
        groups.setdefault(leaders[name], []).append(link)
    made = {
        leader: Lump(
            leader=sheet.link_by_name[leader],
            members=tuple(sorted(links, key=lambda link: link.element.span)),
            mass=sum(mass_of(link) for link in links),
            is_held=_is_held(sheet, leader),
        )
        for leader, links in groups.items()
    }
    return {name: made[leader] for name, leader in leaders.items()}


def counts(lump: Lump | None, link: LinkEntry) -> bool:
    """Whether the inertia of a link matters: it can turn, and is not only a small part of something larger."""
    return lump is None or (not lump.is_held and mass_of(link) >= _SMALL * lump.mass)


def is_world(sheet: Sheet, name: str | None) -> bool:
    """Whether a link is the ground that a robot is screwed to."""
    return name == WORLD and WORLD in sheet.link_by_name and WORLD not in sheet.joints_above


def parents_by_fixed_joint(sheet: Sheet) -> dict[str, str]:
    """For each link that Gazebo merges into its parent: the parent."""
    kept = _kept_joints(sheet)
    above: dict[str, str] = {}
    for name in sheet.link_by_name:
        joint = next(iter(sheet.joints_above.get(name, ())), None)
        if joint is None or joint.type != "fixed" or joint.name in kept:
            continue
        parent = joint.parent
        if parent is not None and parent in sheet.link_by_name and not is_world(sheet, parent):
            above[name] = parent
    return above


def _is_held(sheet: Sheet, name: str) -> bool:
    joint = next(iter(sheet.joints_above.get(name, ())), None)
    return joint is not None and joint.type == "fixed" and is_world(sheet, joint.parent)


def _kept_joints(sheet: Sheet) -> set[str]:
    return {
        block.reference
        for block in sheet.gazebo
        for child in block.element.children
        if block.reference
        and child.name in KEEPING
        and tag_value(child).lower() in ("true", "1", "yes")
    }


def _find_leader(name: str, above: Mapping[str, str], leaders: dict[str, str]) -> None:
    """Note the leader of a link, and of all on the way to it; in a loop the first one asked for leads."""
    way: dict[str, None] = {}
    here = name
    while here not in leaders and here in above and here not in way:
        way[here] = None
        here = above[here]
    leader = leaders.setdefault(here, here)
    leaders.update((link, leader) for link in way)
