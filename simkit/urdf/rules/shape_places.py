"""Rules on where the shapes of a link are: what is seen, what is touched, where the mass lies."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from simkit.diagnostics import Find, Severity, rule
from simkit.geometry import Vector
from simkit.urdf.placed_shape import PlacedShape, extent
from simkit.urdf.rules.bodies import centre_of_mass, is_world, link_outline, lumps, placed_shape
from simkit.urdf.rules.entries import BodyEntry, LinkEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import called, four_digits, listed, quoted, triple

_OFF = 0.1
"Shapes whose surfaces differ by less than this share of their size are in the same place."
_OUTSIDE = 0.02
"A centre of mass may stick out by this share of the size of the link."
_PAIRS = 200
"A link with more visuals times collisions than this is not compared."

_Y: Vector = (0.0, 1.0, 0.0)
_AXES: dict[str, Vector] = {
    "in front of": (1.0, 0.0, 0.0),
    "behind": (-1.0, 0.0, 0.0),
    "to the left of": _Y,
    "to the right of": (0.0, -1.0, 0.0),
    "above": (0.0, 0.0, 1.0),
    "below": (0.0, 0.0, -1.0),
}
_SLANT = 1.0 / math.sqrt(3.0)
_CORNERS = [
    (x, y, z) for x in (-_SLANT, _SLANT) for y in (-_SLANT, _SLANT) for z in (-_SLANT, _SLANT)
]


@rule(
    "URDF-I14",
    "the centre of mass outside of the link",
    Severity.NOTE,
    here="simkit puts the mass there.",
    gazebo="Gazebo puts the mass there; View > Center of Mass shows it.",
)
def mass_beside_shape(sheet: Sheet) -> Iterator[Find]:
    """The centre of mass hovers outside of the link.

    Symptom: The robot tilts, or falls over where it should stand.

    Cause: The `<origin>` of the `<inertial>` says where the centre of mass is, seen from the link. Mostly the `<origin>` of
    the shape was changed and this one was not, or it was meant to lift the whole link, as `<pose>` does in SDF.

    Remedy: The centre of a link that is filled evenly is that of its shape: copy the `xyz` of the shape. To lift a link,
    change the `<origin>` of its joint.

    Right:

        <inertial><origin xyz="0 0 0.25"/> ... </inertial>
        <collision><origin xyz="0 0 0.25"/> ... </collision>
    """
    for link in sheet.links:
        centre, shapes = centre_of_mass(link), link_outline(link)
        if centre is None or not shapes or link.inertial is None:
            continue
        where, distance = max(
            ((word, _beyond(centre, shapes, axis)) for word, axis in _AXES.items()),
            key=lambda pair: pair[1],
        )
        if distance <= 0.001 + _OUTSIDE * max(extent(shape.shape) for shape in shapes):
            continue
        middle = (link.collisions or link.visuals)[0].origin.xyz or (0.0, 0.0, 0.0)
        yield Find(
            link.inertial.origin.element or link.inertial.element,
            what=f"the centre of mass of {called(link.element)} lies {four_digits(distance)} m {where} the link (axes of the "
            "link)",
            remedy=f'Write <origin xyz="{triple(middle)}"/> in the <inertial>, as the shape has it.',
        )


@rule("URDF-W15", "a <visual> without a <collision>", Severity.WARNING)
def no_collision(sheet: Sheet) -> Iterator[Find]:
    """A link is seen, but cannot be touched.

    Symptom: The link sinks into the floor, passes through others, and lasers do not see it.

    Cause: It has a `<visual>` and no `<collision>`. The first is only paint; what touches is the second.

    Remedy: A `<collision>` with the same `<origin>` and `<geometry>`. A robot for RViz alone needs none, and small parts,
    such as a camera that is bolted to the robot, may do without.

    Right:

        <collision>
          <origin xyz="0 0 0.25"/>
          <geometry><cylinder radius="0.05" length="0.5"/></geometry>
        </collision>
    """
    bare = [link for link in sheet.links if link.visuals and not link.collisions]
    if not any(link.collisions for link in sheet.links):
        if bare and any(link.inertial for link in sheet.links):
            yield _touches_nothing(sheet, bare[0])
        return
    lump_of = lumps(sheet)
    for link in bare:
        if link.name is None or is_world(sheet, link.name):
            continue
        lump = lump_of[link.name]
        yield Find(
            link.visuals[0].element,
            severity=Severity.NOTE if lump.touches else Severity.WARNING,
            what=f"{called(link.element)} is seen, but cannot be touched: it has a <visual> and no <collision>",
            both="Other things, and the beams of lasers, pass through it.",
            remedy=_collision_remedy(link),
        )


@rule(
    "URDF-I16",
    "<visual> and <collision> in different places",
    Severity.NOTE,
    here="simkit touches with the one and draws the other.",
    gazebo="Gazebo touches with the one and draws the other; View > Collisions shows it.",
)
def seen_elsewhere(sheet: Sheet) -> Iterator[Find]:
    """What is seen of a link and what is touched of it are in different places.

    Symptom: The robot rolls on nothing, hits something before it gets there, or sinks into the floor.

    Cause: The `<origin>` of the `<visual>` was changed and that of the `<collision>` was not, or the other way round. Often
    it is only the `rpy` of a wheel.

    Remedy: The same `<origin>` in both. In RViz tick "Collision Enabled" of the RobotModel to see what is touched.

    Right:

        <visual>    <origin xyz="0.2 0 -0.05"/> <geometry><sphere radius="0.05"/></geometry></visual>
        <collision> <origin xyz="0.2 0 -0.05"/> <geometry><sphere radius="0.05"/></geometry></collision>
    """
    for link in sheet.links:
        if len(link.visuals) * len(link.collisions) > _PAIRS:
            continue
        for collision, visual in _pairs(link):
            touched, seen = placed_shape(collision), placed_shape(visual)
            if touched is None or seen is None:
                continue
            distance = _apart(touched, seen)
            if distance <= _OFF * max(extent(touched.shape), extent(seen.shape)):
                continue
            yield Find(
                collision.origin.element or collision.element,
                what=f"what is touched of {called(link.element)} is {four_digits(distance)} m off what is seen of it",
                remedy=f"Give both the same <origin>: {_origin_text(visual)} is that of the visual.",
                related=[(visual.origin.element or visual.element, "seen here")],
            )


def _touches_nothing(sheet: Sheet, link: LinkEntry) -> Find:
    names = [one.name for one in sheet.links if one.visuals and one.name]
    return Find(
        link.visuals[0].element,
        severity=Severity.NOTE,
        what=f"no link can be touched: {listed(names)} have masses and visuals, but no <collision>",
        both="The robot falls through floors, unless it is fixed to the world.",
        remedy=_collision_remedy(link),
    )


def _collision_remedy(link: LinkEntry) -> str:
    visual = link.visuals[0]
    shape = visual.shape_element
    if shape is None:
        return "Add a <collision> with a <geometry>."
    attributes = " ".join(f'{one.name}="{one.value}"' for one in shape.attributes)
    if len(attributes) > 100:
        return "Add a <collision> with the same <origin> and <geometry> as the visual."
    return (
        f"Add <collision>{_origin_text(visual)}<geometry><{shape.name} {attributes}/></geometry></collision> "
        f"to link {quoted(link.name)}."
    )


def _origin_text(body: BodyEntry) -> str:
    zero = (0.0, 0.0, 0.0)
    return (
        f'<origin xyz="{triple(body.origin.xyz or zero)}" rpy="{triple(body.origin.rpy or zero)}"/>'
    )


def _pairs(link: LinkEntry) -> Iterator[tuple[BodyEntry, BodyEntry]]:
    """Collisions and visuals that are meant to be the same thing: equal shapes, or the only two of a link.

    Of several equal ones the nearest; one that has its twin in the right place is in no pair.
    """
    if len(link.collisions) == 1 and len(link.visuals) == 1:
        yield link.collisions[0], link.visuals[0]
        return
    free = list(link.visuals)
    for collision in link.collisions:
        touched = placed_shape(collision)
        twins = [one for one in free if touched is not None and one.shape == collision.shape]
        shapes = [(shape, one) for one in twins if (shape := placed_shape(one)) is not None]
        if touched is not None and shapes:
            _, visual = min(shapes, key=lambda pair: _apart(touched, pair[0]))
            free.remove(visual)
            yield collision, visual


def _apart(one: PlacedShape, other: PlacedShape) -> float:
    """How far the surfaces of two equal shapes, or the middles of two others, are apart [m]."""
    distance = math.dist(one.frame.translation, other.frame.translation)
    if one.shape != other.shape:
        return distance
    ways = [*_AXES.values(), *_CORNERS]
    return max(distance, *(_height(one, way) - _height(other, way) for way in ways))


def _height(shape: PlacedShape, way: Vector) -> float:
    """How far a shape reaches in a direction of length 1 [m]."""
    x, y, z = shape.support(way)
    return x * way[0] + y * way[1] + z * way[2]


def _beyond(point: Vector, shapes: Sequence[PlacedShape], axis: Vector) -> float:
    """How far a point lies beyond all of some shapes in a direction of length 1 [m]."""
    height = point[0] * axis[0] + point[1] * axis[1] + point[2] * axis[2]
    return height - max(_height(shape, axis) for shape in shapes)
