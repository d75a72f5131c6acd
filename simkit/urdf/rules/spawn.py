"""Rules about the robot as it stands when it is spawned, all joints at 0: in the floor, in itself, or as the ground."""

from __future__ import annotations

import math
from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.fixed_joints import WORLD
from simkit.urdf.model import Cylinder
from simkit.urdf.placed_shape import PlacedShape, extent, overlap
from simkit.urdf.rules.bodies import is_world, lumps, simple_shapes, standing_shapes, zero_pose
from simkit.urdf.rules.entries import JointEntry, LinkEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.tree_facts import is_whole
from simkit.urdf.rules.wording import four_digits, quoted
from simkit.urdf.wheel import is_wheel

_DEEP = 0.05
"Two shapes overlap if each reaches into the other by this share of the smaller one's size."
_COMPARED = 2000
"So many pairs of shapes are compared."
_BELOW = 1e-4
"The floor may be touched this deep [m]."


@rule(
    "GZ-W06",
    "a robot that reaches below z = 0",
    Severity.NOTE,
    here="Spawned at z = 0 it starts in the floor, which pushes it out.",
    gazebo="Spawned at z = 0 it starts in the floor, and jumps or tips over.",
)
def in_the_floor(sheet: Sheet) -> Iterator[Find]:
    """The robot reaches below z = 0, so it is spawned in the floor.

    Symptom: It jumps up, tips over or flies away as soon as the simulation starts.

    Cause: `spawn_model` puts the frame of the root link at the given place, by default at 0 0 0, and the floor is at z = 0.
    What hangs below the root link, wheels mostly, is then in the floor, and the engine pushes it out.

    Remedy: Spawn it higher, or give the robot a root link that lies on the floor, usually `base_footprint`.

    Right:

        rosrun gazebo_ros spawn_model -urdf -param robot_description -model m2wr -z 0.1
    """
    if not is_whole(sheet):
        return
    standing = zero_pose(sheet)
    lowest, body, name = 0.0, None, ""
    for link in sheet.links:
        where = standing.get(link.name or "")
        if where is None or is_world(sheet, where.root):
            continue
        for collision in link.collisions:
            for shape in standing_shapes((collision,), where):
                if shape.lowest() < lowest:
                    lowest, body, name = shape.lowest(), collision, link.name or ""
    height = _spawn_height(sheet)
    if body is None or lowest + (height or 0.0) > -_BELOW:
        return
    spawned = (
        "" if height is None else f", and the launch file spawns it at z = {four_digits(height)}"
    )
    yield Find(
        body.element,
        what=f"the robot reaches {four_digits(-lowest)} m below its root link (here, with {quoted(name)}){spawned}",
        remedy=f"Spawn it with -z {_up(-lowest)} or more.",
    )


@rule("URDF-I44", "links that reach into each other", Severity.NOTE)
def in_itself(sheet: Sheet) -> Iterator[Find]:
    """Links reach into each other.

    Symptom: In Gazebo and here nothing is seen of it, as long as the links of a robot do not touch each other. With
    self-collision the robot jerks apart at the start, or blocks; and a wheel that is inside of the body would not turn on a
    real robot.

    Cause: An `<origin>` of a joint is too short, or the collision shapes are larger than the parts. Links with a joint between
    them may overlap, as an arm and its socket do: neither Gazebo nor simkit lets them touch.

    Remedy: Move the joint, or make the collision shapes smaller.

    Wrong, for a wheel 0.04 m wide beside a body 0.3 m wide:

        <origin xyz="-0.05 0.15 0"/>

    Right:

        <origin xyz="-0.05 0.17 0"/>
    """
    if not is_whole(sheet):
        return
    connections = _Connections(sheet)
    near = list(_overlapping(sheet, connections))
    apart = [pair for pair in near if connections.may_touch(*pair)]
    if apart:
        yield Find(
            sheet.link_by_name[apart[0][1]].element,
            what=f"with all joints at 0, links reach into each other that no joint connects: {_shown(apart)}",
            here="Nothing happens: the links of a robot pass through each other.",
            gazebo="Nothing happens, unless a <gazebo> says <selfCollide>true</selfCollide>: then they push each other away.",
            remedy="If they are to touch each other, move a joint or make the collision shapes smaller.",
        )
    wheels = [pair for pair in near if connections.is_wheel_in_body(*pair)]
    if wheels:
        yield Find(
            sheet.link_by_name[wheels[0][1]].element,
            what=f"a wheel reaches into the body: {_shown(wheels)}",
            both="Nothing happens: links with a joint between them pass through each other.",
            remedy="A real wheel needs room: move its joint outward, or make the body narrower.",
        )


def _shown(pairs: list[tuple[str, str]]) -> str:
    more = f"; and {len(pairs) - 4} more" if len(pairs) > 4 else ""
    return "; ".join(f"{quoted(one)} and {quoted(other)}" for one, other in pairs[:4]) + more


def _overlapping(sheet: Sheet, connections: _Connections) -> Iterator[tuple[str, str]]:
    """Pairs of links that reach into each other and are worth a word, each pair once, in the order of the file."""
    boxes = sorted(_boxes(sheet), key=lambda box: box[0])
    active: list[tuple[float, str, PlacedShape]] = []
    found: dict[tuple[str, str], None] = {}
    compared = 0
    for low, high, name, shape in boxes:
        active = [one for one in active if one[0] > low]
        compared += len(active)
        if compared > _COMPARED:
            break
        for _, other_name, other in active:
            pair = connections.in_order(name, other_name)
            is_told = connections.may_touch(*pair) or connections.is_wheel_in_body(*pair)
            if is_told and pair not in found and _reach_into(shape, other):
                found[pair] = None
        active.append((high, name, shape))
    yield from sorted(found, key=lambda pair: [connections.number[name] for name in pair])


def _boxes(sheet: Sheet) -> Iterator[tuple[float, float, str, PlacedShape]]:
    """Collision shapes of the robot, with where each begins and ends along x [m]."""
    standing = zero_pose(sheet)
    for name, link in sheet.link_by_name.items():
        for shape in standing_shapes(link.collisions, standing.get(name)):
            low, high = shape.support((-1.0, 0.0, 0.0))[0], shape.support((1.0, 0.0, 0.0))[0]
            yield low, high, name, shape


def _reach_into(one: PlacedShape, other: PlacedShape) -> bool:
    return overlap(one, other, _DEEP * min(extent(one.shape), extent(other.shape)))


class _Connections:
    """Which links hang together directly, once Gazebo has lumped what is fixed."""

    def __init__(self, sheet: Sheet) -> None:
        self.number = {link.name: place for place, link in enumerate(sheet.links) if link.name}
        self._lump_of = {name: lump.leader.name or "" for name, lump in lumps(sheet).items()}
        self._joined = {
            frozenset((self._lump_of.get(joint.parent, ""), self._lump_of.get(joint.child, "")))
            for joint in sheet.joints
            if joint.parent and joint.child
        }
        self._wheels = {
            (self._lump_of.get(joint.parent or "", ""), joint.child)
            for joint in sheet.joints
            if joint.type == "continuous" and _is_wheel(sheet, joint)
        }
        self._root = {name: standing.root for name, standing in zero_pose(sheet).items()}

    def may_touch(self, one: str, other: str) -> bool:
        """Whether two links are neither of one lump, nor of two that a joint connects."""
        both = frozenset((self._lump_of[one], self._lump_of[other]))
        return len(both) == 2 and both not in self._joined and self._root[one] == self._root[other]

    def is_wheel_in_body(self, one: str, other: str) -> bool:
        """Whether one of two links is a wheel, and the other what it is mounted on."""
        pair = (self._lump_of[one], self._lump_of[other])
        return pair in self._wheels or pair[::-1] in self._wheels

    def in_order(self, one: str, other: str) -> tuple[str, str]:
        """The two names, the one that comes first in the file first."""
        return (one, other) if self.number[one] < self.number[other] else (other, one)


def _is_wheel(sheet: Sheet, joint: JointEntry) -> bool:
    """Whether a joint turns a wheel, and nothing else hangs on it."""
    link = sheet.link_by_name.get(joint.child or "")
    shapes = () if link is None else simple_shapes(link.collisions)
    if joint.axis is None or len(shapes) != 1 or joint.child in sheet.joints_below:
        return False
    shape, frame = shapes[0]
    origin = (0.0, 0.0, 0.0)
    return isinstance(shape, Cylinder) and is_wheel(shape, frame, axis=joint.axis, origin=origin)


def _spawn_height(sheet: Sheet) -> float | None:
    """How high a launch file beside the URDF spawns the robot [m]; None if there is none that does."""
    if not sheet.companions:
        return None
    from simkit.urdf.rules.companions import spawn_height  # most calls have no launch file

    return spawn_height(sheet)


def _up(height: float) -> str:
    """A height [m] in millimetres, rounded up but for what does not matter."""
    return f"{math.ceil((height - _BELOW) * 1000) / 1000:g}"


@rule(
    "GZ-W15",
    "a root link called world that has a shape or a mass",
    Severity.WARNING,
    here="rviz shows it; in a world it is left out, as in Gazebo, and the robot is tied to the ground.",
    gazebo="Gazebo leaves out the link with all that it has, and ties its joints to the ground, without a word.",
    remedy='Call it otherwise, e.g. name="base_link"; to tie it down, add <link name="world"/> and a fixed joint.',
)
def world_with_a_body(sheet: Sheet) -> Iterator[Find]:
    """A root link called `world` that has a shape or a mass.

    Symptom: RViz shows the base of the robot; in Gazebo it is missing, and the robot stands screwed to nothing.

    Cause: A root link of the name `world` is the ground of Gazebo. Gazebo makes no link of it, and drops its shapes and its
    mass; the joints below it tie the robot to the ground.

    Remedy: Leave `<link name="world"/>` empty. What is seen and touched belongs into a link of its own below it.

    Right:

        <link name="world"/>
        <joint name="stand" type="fixed">
          <parent link="world"/>
          <child link="base_link"/>
        </joint>
    """
    link = sheet.link_by_name.get(WORLD)
    if link is None or not is_world(sheet, WORLD) or not _parts(link):
        return
    yield Find(
        Part(link.element, "name"),
        what=f"the root link 'world' has {' and '.join(_parts(link))}, but Gazebo takes it for the ground",
    )


def _parts(link: LinkEntry) -> list[str]:
    parts = {
        "a visual": bool(link.visuals),
        "a collision": bool(link.collisions),
        "a mass": link.inertial is not None,
    }
    return [name for name, is_there in parts.items() if is_there]
