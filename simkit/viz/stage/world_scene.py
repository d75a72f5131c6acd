"""A world as a scene: its models where they are, on a ground, before a camera."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

from simkit.geometry import IDENTITY, Transform, Vector, rotate
from simkit.physics import Model
from simkit.urdf import Box
from simkit.viz.stage.camera import AXIS_SHARE_OF_ROBOT, Stage, bounds, fitted, stage_for
from simkit.viz.stage.frames import FramePose, TfScene
from simkit.viz.stage.parts import Marks, Role, Solid, corners
from simkit.viz.stage.scene import Displays, PlacedSolid, Scene, Window
from simkit.viz.stage.world_bodies import body_solids
from simkit.viz.stage.world_models import Ground, ModelShapes, Thing, link_frame, model_shapes


@dataclass(frozen=True, slots=True, kw_only=True)
class WorldSettings:
    """Which displays are on at first; a person may turn them on and off in the view."""

    models: bool = True
    """What is seen of the models."""
    collisions: bool = False
    """What others touch of them."""
    contacts: bool = False
    """Where models touch each other, and how hard."""
    center_of_mass: bool = False
    """The centre of mass of each link."""
    inertias: bool = False
    """A box of equal inertia for each link."""
    joints: bool = False
    """The axes of joints."""
    link_frames: bool = False
    """Axes and names of the links."""
    scans: bool = True
    """What lasers see."""
    grid: bool = True
    """The grid on the ground."""
    transparent: bool | None = None
    """Whether one sees through the models; if None, when something inside of them is shown."""
    look_at: str = ""
    """Model that the camera looks at; all of them if empty."""

    @property
    def displays(self) -> Displays:
        """What is seen at first."""
        roles = {
            Role.COLLISION: self.collisions,
            Role.CENTRE: self.center_of_mass,
            Role.INERTIA: self.inertias,
            Role.JOINT: self.joints,
            Role.GROUND: True,
        }
        is_inner = self.center_of_mass or self.inertias or self.joints
        return Displays(
            grid=self.grid,
            tf=self.link_frames,
            robot=Role.VISUAL if self.models else None,
            also=tuple(role for role, is_on in roles.items() if is_on),
            transparent=is_inner if self.transparent is None else self.transparent,
        )


WORLD: Final = "world"
"""The frame that everything is drawn in."""
GAZEBO = Window(
    title="Gazebo", command="sim.gzclient()", bodies="Models", fixed="Frame", frames="Link frames"
)
"""The window of gzclient."""
_MOST_SOLIDS: Final = 4000
"So many shapes are drawn."
_AXIS_OF_MODEL: Final = 0.22
"Length of the axis of a joint, as a share of the size of its model."
_BELOW: Final = 0.001
"How far the ground is drawn below where it is, as a share of the way across: so that the grid is seen."
_FILL: Final = 0.7
"Share of the picture that the model takes at which one looks."


@dataclass(frozen=True, slots=True, kw_only=True)
class Actor:
    """A model as it is drawn."""

    name: str
    """What it is called in the view."""
    thing: Thing
    """The model, and the file that it comes from."""
    shapes: ModelShapes
    """What is drawn of it, with its bodies and joints."""
    size: float
    """Way across it when it was first seen [m]."""

    @property
    def model(self) -> Model:
        """Its bodies and joints."""
        return self.thing.model

    @property
    def is_ground(self) -> bool:
        """Whether it is nothing but a plane."""
        return bool(self.shapes.grounds) and not self.shapes.solids


def make_actor(thing: Thing, *, name: str) -> Actor:
    """A model as it is drawn.

    Args:
        thing: The model.
        name: What it is called in the view.
    """
    shapes = model_shapes(thing, name=name)
    points = list(
        shape_corners(shapes, {pose.name: pose for pose in link_poses(thing.model, name=name)})
    )
    size = math.dist(*bounds(points)) if points else 0.0
    inner = tuple(body_solids(thing.model, name=name, size=_AXIS_OF_MODEL * (size or 1.0)))
    shapes = replace(shapes, solids=shapes.solids + inner)
    return Actor(name=name, thing=thing, shapes=shapes, size=size)


def link_poses(model: Model, *, name: str) -> Iterator[FramePose]:
    """Where the links of a model are in the world, each with the one that it hangs on.

    Args:
        model: The model.
        name: What it is called in the view.
    """
    above = {joint.child: joint.parent for joint in model.plan.joints.values()}
    for link, mount in model.plan.mounts.items():
        parent = above.get(link) if mount.body == link else mount.body
        placement = model.link_pose(link)
        yield FramePose(
            name=link_frame(name, link),
            parent=WORLD if parent is None else link_frame(name, parent),
            origin=placement.translation,
            rotation=placement.rotation,
        )


def shape_corners(shapes: ModelShapes, poses: Mapping[str, FramePose]) -> Iterator[Vector]:
    """Corners of the boxes around the shapes of a model [m].

    Args:
        shapes: The shapes.
        poses: Where the links are, by name; shapes of others are left out.
    """
    for solid in shapes.solids:
        if solid.role in (Role.VISUAL, Role.COLLISION) and solid.link in poses:
            yield from corners(solid, poses[solid.link])


def world_scene(
    actors: Sequence[Actor],
    frames: Sequence[FramePose],
    settings: WorldSettings,
    *,
    outlines: Mapping[str, Sequence[Vector]],
    marks: tuple[Marks, ...],
    headline: str,
) -> Scene:
    """What the window of Gazebo shows.

    Args:
        actors: The models, the oldest first.
        frames: Where their links are.
        settings: What is seen at first.
        outlines: By model, points that must be seen [m].
        marks: Contacts, scans, trails.
        headline: One sentence on what is seen.
    """
    tf = TfScene(fixed_frame=WORLD, poses=tuple(frames), error="", problems=())
    points = [point for one in outlines.values() for point in one]
    stage = stage_for(tf, points, axis_share=AXIS_SHARE_OF_ROBOT)
    stage = _looking_at(stage, outlines.get(settings.look_at, ()))
    poses = {pose.name: pose for pose in frames}
    solids = [
        PlacedSolid(solid=solid, frame=poses[solid.link], is_lost=False)
        for actor in actors
        for solid in actor.shapes.solids
        if solid.link in poses
    ]
    notes = [note for actor in actors for note in actor.shapes.notes]
    if len(solids) > _MOST_SOLIDS:
        notes.append(f"Only the first {_MOST_SOLIDS} of {len(solids)} shapes are drawn.")
    grounds = [
        PlacedSolid(solid=ground_solid(ground, actor.model, stage), frame=None, is_lost=False)
        for actor in actors
        for ground in actor.shapes.grounds
    ]
    return Scene(
        tf=tf,
        solids=(*solids[:_MOST_SOLIDS], *grounds),
        problems=(),
        notes=tuple(dict.fromkeys(notes)),
        displays=settings.displays,
        stage=stage,
        marks=marks,
        window=GAZEBO,
        headline=headline,
    )


def ground_solid(ground: Ground, model: Model, stage: Stage) -> Solid:
    """A piece of a plane, under all that is seen, in the frame of the world.

    Args:
        ground: The plane.
        model: Its model.
        stage: What is seen.
    """
    at = model.link_pose(ground.link) @ Transform(ground.translation, ground.rotation)
    normal = rotate(at.rotation, (0.0, 0.0, 1.0))
    (x0, x1), (y0, y1) = (
        (stage.cell * first, stage.cell * last) for first, last in (stage.grid_x, stage.grid_y)
    )
    middle, across = ((x0 + x1) / 2, (y0 + y1) / 2, 0.0), math.hypot(x1 - x0, y1 - y0)
    thick = _BELOW * across
    height = math.fsum(n * (m - o) for n, m, o in zip(normal, middle, at.translation, strict=True))
    down = height + 1.5 * thick
    x, y, z = (m - down * n for m, n in zip(middle, normal, strict=True))
    is_level = normal[2] > 0.999
    return Solid(
        link=ground.link,
        role=Role.GROUND,
        shape=Box((x1 - x0, y1 - y0, thick) if is_level else (across, across, thick)),
        translation=(x, y, z),
        rotation=IDENTITY if is_level else at.rotation,
        color=ground.color,
    )


def _looking_at(stage: Stage, points: Sequence[Vector]) -> Stage:
    """The stage with its camera at some points; as it is if there are none."""
    if not points:
        return stage
    low, high = bounds(points)
    camera = replace(stage.camera, target=low, distance=max(math.dist(low, high), 1e-3))
    return replace(stage, camera=fitted(camera, points, fill=_FILL))
