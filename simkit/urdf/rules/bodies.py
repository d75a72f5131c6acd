"""Links as bodies: their shapes, mass and inertia, which of them are one body in Gazebo, and where all joints at 0 put them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from simkit.geometry import Matrix, Transform, Vector
from simkit.urdf.fixed_joints import KEEP_TAGS, TRUE, WORLD, leaders, merged_links
from simkit.urdf.inertia import body_of_shapes, transpose, turned
from simkit.urdf.model import Mesh
from simkit.urdf.placed_shape import PlacedShape, is_sound
from simkit.urdf.rules.entries import BodyEntry, InertialEntry, LinkEntry, OriginEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import tag_value

LIGHTEST = 1e-5
"""Gazebo takes a smaller mass [kg] for none."""

_FAR = 1e6
"Distances, masses and moments beyond this are slips of the pen, which other rules report."


def frame_of(origin: OriginEntry) -> Transform | None:
    """Where an `<origin>` puts something; None if that cannot be read."""
    if origin.xyz is None or origin.rpy is None:
        return None
    is_near = all(abs(value) < _FAR for value in (*origin.xyz, *origin.rpy))
    return Transform.from_rpy(origin.xyz, origin.rpy) if is_near else None


def placed_shape(body: BodyEntry) -> PlacedShape | None:
    """A visual or collision in the frame of its link; None if it is a mesh or cannot be read."""
    frame = frame_of(body.origin)
    if frame is None or body.shape is None or isinstance(body.shape, Mesh):
        return None
    return PlacedShape(body.shape, frame) if is_sound(body.shape) else None


def simple_parts(bodies: Iterable[BodyEntry]) -> tuple[PlacedShape, ...]:
    """The simple shapes among some visuals or collisions of a link, in its frame."""
    return tuple(shape for one in bodies if (shape := placed_shape(one)) is not None)


def simple_shapes(bodies: tuple[BodyEntry, ...]) -> tuple[PlacedShape, ...]:
    """The shapes of some visuals or collisions if every one is simple; else none."""
    shapes = simple_parts(bodies)
    return shapes if len(shapes) == len(bodies) else ()


def solid(link: LinkEntry) -> tuple[PlacedShape, ...]:
    """What the mass of a link most likely fills: its collisions, or its visuals if it has none.

    Returns:
        The shapes in the frame of the link; none if one of them is a mesh.
    """
    return simple_shapes(link.collisions or link.visuals)


def link_outline(link: LinkEntry) -> tuple[PlacedShape, ...]:
    """All that is seen and touched of a link, in its frame; nothing if any of it is a mesh."""
    return simple_shapes((*link.visuals, *link.collisions))


def mass_of(link: LinkEntry) -> float:
    """The mass of a link [kg] as Gazebo sees it: 0 if it has none, or one that counts as none."""
    mass = None if link.inertial is None else link.inertial.mass
    return mass if mass is not None and LIGHTEST < mass < _FAR else 0.0


def tensor_of(inertial: InertialEntry) -> Matrix | None:
    """The tensor as written, in the axes of the `<inertial>`; None if it cannot be read."""
    if inertial.tensor is None or any(abs(entry) > _FAR for entry in inertial.tensor):
        return None
    ixx, ixy, ixz, iyy, iyz, izz = inertial.tensor
    return ((ixx, ixy, ixz), (ixy, iyy, iyz), (ixz, iyz, izz))


def fitting_tensor(link: LinkEntry) -> Matrix | None:
    """The tensor that the mass of a link has if it fills its shapes evenly, in the axes of its `<inertial>`.

    Returns:
        About the middle of the shapes; None if link has no mass or no simple shapes.
    """
    shapes, mass = solid(link), mass_of(link)
    frame = None if link.inertial is None else frame_of(link.inertial.origin)
    if not shapes or not mass or frame is None:
        return None
    return turned(body_of_shapes(shapes, mass).tensor, transpose(frame.matrix))


def centre_of_mass(link: LinkEntry) -> Vector | None:
    """Where the mass of a link is, in its frame [m]; None if it has none or it cannot be read."""
    if link.inertial is None or not mass_of(link):
        return None
    frame = frame_of(link.inertial.origin)
    return None if frame is None else frame.translation


def reach(link: LinkEntry) -> float:
    """Distance from the centre of mass of a link to the farthest point of it [m]; 0 if that is not known."""
    centre = centre_of_mass(link)
    if centre is None:
        return 0.0
    return max((shape.farthest(centre) for shape in link_outline(link)), default=0.0)


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


@dataclass(frozen=True)
class Standing:
    """Where a link stands."""

    root: str
    """The root link that it hangs on, over however many joints."""
    frame: Transform
    """Its frame, seen from that root."""


def zero_pose(sheet: Sheet) -> dict[str, Standing]:
    """The links that hang together with a root, and where they stand, by name."""
    found: dict[str, Standing] = {}
    waiting = [
        (name, Standing(name, Transform()))
        for name in sheet.link_by_name
        if name not in sheet.joints_above
    ]
    while waiting:
        name, standing = waiting.pop()
        if name in found:
            continue
        found[name] = standing
        for joint in sheet.joints_below.get(name, ()):
            frame = frame_of(joint.origin)
            if frame is not None and joint.child in sheet.link_by_name and joint.child:
                below = Standing(standing.root, standing.frame @ frame)
                waiting.append((joint.child, below))
    return found


def standing_shapes(
    bodies: tuple[BodyEntry, ...], standing: Standing | None
) -> tuple[PlacedShape, ...]:
    """The simple shapes among some visuals or collisions of a link, seen from its root."""
    if standing is None:
        return ()
    return tuple(shape.seen_from(standing.frame) for shape in simple_parts(bodies))
