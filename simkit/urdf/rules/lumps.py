"""Lumps: links that Gazebo makes one body of, since fixed joints hold them together."""

from __future__ import annotations

from dataclasses import dataclass

from simkit.urdf.fixed_joints import KEEP_TAGS, TRUE, WORLD, leaders, merged_links
from simkit.urdf.rules.bodies import mass_of
from simkit.urdf.rules.entries import LinkEntry
from simkit.urdf.rules.gazebo_words import tag_value
from simkit.urdf.rules.sheet import Sheet

_SMALL = 0.1
"The inertia of a link with a smaller share of the mass of its lump hardly counts."


@dataclass(frozen=True, kw_only=True)
class Lump:
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
    leader_of = leaders(sheet.link_by_name, parents_by_fixed_joint(sheet))
    groups: dict[str, list[LinkEntry]] = {}
    for name, link in sheet.link_by_name.items():
        groups.setdefault(leader_of[name], []).append(link)
    made = {
        leader: Lump(
            leader=sheet.link_by_name[leader],
            members=tuple(sorted(links, key=lambda link: link.element.span)),
            mass=sum(mass_of(link) for link in links),
            is_held=_is_held(sheet, leader),
        )
        for leader, links in groups.items()
    }
    return {name: made[leader] for name, leader in leader_of.items()}


def counts(lump: Lump | None, link: LinkEntry) -> bool:
    """Whether the inertia of a link matters: it can turn, and is not only a small part of something larger."""
    return lump is None or (not lump.is_held and mass_of(link) >= _SMALL * lump.mass)


def is_world(sheet: Sheet, name: str | None) -> bool:
    """Whether a link is the ground that a robot is screwed to."""
    return name == WORLD and WORLD in sheet.link_by_name and WORLD not in sheet.joints_above


def parents_by_fixed_joint(sheet: Sheet) -> dict[str, str]:
    """For each link that Gazebo merges into its parent: the parent."""
    above = (
        (name, next(iter(sheet.joints_above.get(name, ())), None)) for name in sheet.link_by_name
    )
    fixed = [
        (joint.name, joint.parent, name)
        for name, joint in above
        if joint is not None and joint.type == "fixed" and joint.parent in sheet.link_by_name
    ]
    return merged_links(
        [(name, parent, child) for name, parent, child in fixed if parent is not None],
        kept=_kept_joints(sheet),
        has_ground=is_world(sheet, WORLD),
    )


def _is_held(sheet: Sheet, name: str) -> bool:
    joint = next(iter(sheet.joints_above.get(name, ())), None)
    return joint is not None and joint.type == "fixed" and is_world(sheet, joint.parent)


def _kept_joints(sheet: Sheet) -> set[str | None]:
    return {
        block.reference
        for block in sheet.gazebo
        for child in block.element.children
        if block.reference and child.name in KEEP_TAGS and tag_value(child).lower() in TRUE
    }
