"""The collision shapes of a lump, under the names that Gazebo gives them."""

from __future__ import annotations

from dataclasses import dataclass, field

from simkit.physics.bodies import check_pose
from simkit.physics.gazebo_tags import GazeboTags, LinkTags
from simkit.physics.lumps import Lump, Member
from simkit.physics.plan import ShapePlan
from simkit.physics.solids import PLACEHOLDER, with_solid
from simkit.urdf.model import Collision

FRICTION = 1.0
"""Of a link about which nothing is said."""


@dataclass(slots=True)
class _Shelf:
    """What is made of the shapes of one lump."""

    leader: str
    tags: GazeboTags
    shapes: list[ShapePlan] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    names: set[str] = field(default_factory=set)


def shapes_of(lump: Lump, tags: GazeboTags) -> tuple[tuple[ShapePlan, ...], list[str]]:
    """The shapes of a lump in its frame, and what is not as the file says.

    Raises:
        ModelError: A number of a shape is none.
    """
    shelf = _Shelf(lump.name, tags)
    for member in lump.members:
        for collision in member.link.collisions:
            _add(shelf, member, collision)
        link = tags.of_link(member.link.name)
        if member.link.collisions:
            note_friction(member.link.name, _friction(link), link.across, shelf.notes)
    return tuple(shelf.shapes), shelf.notes


def note_friction(link: str, friction: float, across: float | None, notes: list[str]) -> None:
    """Note that friction is the same in all directions here, if the file wants something else."""
    if across is not None and across != friction:
        notes.append(
            f"friction of {link} is {friction:g} all round: mu2 = {across:g} has no effect"
        )


def _add(shelf: _Shelf, member: Member, collision: Collision) -> None:
    link = member.link.name
    check_pose(collision.origin, f"a collision of link {link}")
    tags = shelf.tags.of_link(link)
    base = ShapePlan(
        name=_name(shelf, member, collision),
        link=link,
        solid=PLACEHOLDER,
        frame=member.frame @ collision.origin.transform,
        friction=_friction(tags),
        retro=tags.retro or 0.0,
    )
    shape = with_solid(base, collision.geometry, shelf.notes)
    if shape is not None:
        shelf.shapes.append(shape)


def _friction(tags: LinkTags) -> float:
    return FRICTION if tags.friction is None else tags.friction


def _name(shelf: _Shelf, member: Member, collision: Collision) -> str:
    """Name of a collision: that of its link or its own, with the name of the body that took it in.

    Source:
        sdformat's conversion: `<link>_collision`, further ones `_1`, `_2`; of a link that was lumped
        `<body>_fixed_joint_lump__<link>_collision`.
    """
    own = collision.name or member.link.name
    is_guest = member.link.name != shelf.leader
    is_one_of_many = bool(collision.name) and len(member.link.collisions) > 1
    prefix = f"{shelf.leader}_fixed_joint_lump__" if is_guest or is_one_of_many else ""
    name, number = f"{prefix}{own}_collision", 1
    while name in shelf.names:
        name, number = f"{prefix}{own}_collision_{number}", number + 1
    shelf.names.add(name)
    return name
