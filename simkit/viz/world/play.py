"""A recording of a world as a scene, and as what each part of it did."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import count
from typing import Final

from simkit.errors import UnknownNameError
from simkit.geometry import Vector
from simkit.viz.draw.thinning import Row, thinned
from simkit.viz.marks import Marks
from simkit.viz.plots.recorded import RecordedTopics
from simkit.viz.scene import Scene
from simkit.viz.tf_scene import FramePose
from simkit.viz.topics.topic_marks import Shown
from simkit.viz.topics.topic_tape import TopicTrack
from simkit.viz.world.marks import ForceScale, contact_marks, laser_marks
from simkit.viz.world.scene import link_poses, outline, world_scene
from simkit.viz.world.settings import WorldSettings
from simkit.viz.world.source import headline
from simkit.viz.world.tape import Track, WorldTape
from simkit.viz.world.trails import link_ways, odometry_ways, trail_track

_MOMENTS: Final = 50
"So many times of a model are asked how much room it needs."
_SHARE, _TURN = 0.0005, 0.0015
"Nobody sees a link that is off by this share of the distance, or a quaternion that is off by so much."
_TRAILS: Final = "(trails)"
"No model has this name."


@dataclass(frozen=True, slots=True, kw_only=True)
class WorldPlay:
    """Everything that a replay shows; times count from the beginning."""

    duration: float
    """From the beginning to the end [s]."""
    scene: Scene
    """The end, with a stage for the whole."""
    tracks: tuple[tuple[Row, ...], ...]
    """For each frame of the scene: time [s], x, y, z [m], quaternion xyzw; straight in between."""
    until: tuple[float | None, ...]
    """For each frame, when it was gone [s]; None if it was there to the end."""
    displays: tuple[TopicTrack, ...]
    """For each of the marks of the scene, what it showed."""


def world_play(
    tape: WorldTape,
    settings: WorldSettings,
    *,
    trails: Sequence[str] = (),
    odometry: RecordedTopics | None = None,
) -> WorldPlay:
    """A recording, made ready to be shown.

    Args:
        tape: The recording.
        settings: What is seen at first.
        trails: Links that leave a trail: `model::link`, or `model` for its root link.
        odometry: A recording of nav_msgs/Odometry; each of its topics leaves a trail as well.

    Raises:
        UnknownNameError: There was no such link, or no model to look at, of that name.
    """
    actors = [track.actor for track in tape.tracks]
    if settings.look_at and settings.look_at not in [actor.name for actor in actors]:
        raise UnknownNameError("model", settings.look_at, [actor.name for actor in actors])
    ways = [*link_ways(tape, trails), *(odometry_ways(tape, odometry) if odometry else ())]
    displays = (*_happenings(tape, settings), *map(trail_track, count(), ways))
    frames = [pose for track in tape.tracks for pose in _last_poses(track)]
    scene = world_scene(
        actors,
        frames,
        settings,
        outlines={
            **{one.actor.name: list(_outline(one)) for one in tape.tracks},
            _TRAILS: [place for way in ways for _, place in way.places],
        },
        marks=tuple(one.marks for one in displays),
        headline=headline(actors, tape.duration),
    )
    tolerances = (*[_SHARE * scene.stage.camera.distance] * 3, *[_TURN] * 4)
    rows = {name: rows for track in tape.tracks for name, rows in track.links.items()}
    ends = {name: track.until for track in tape.tracks for name in track.links}
    return WorldPlay(
        duration=tape.duration,
        scene=scene,
        tracks=tuple(tuple(thinned(rows[pose.name], tolerances)) for pose in frames),
        until=tuple(ends[pose.name] for pose in frames),
        displays=displays,
    )


def _last_poses(track: Track) -> Iterator[FramePose]:
    if track.actor.is_ground:
        return
    for pose in link_poses(track.actor.model, name=track.actor.name):
        yield _posed(pose, track.links[pose.name][-1])


def _posed(pose: FramePose, row: Row) -> FramePose:
    _, x, y, z, a, b, c, d = row
    return replace(pose, origin=(x, y, z), rotation=(a, b, c, d))


def _outline(track: Track) -> Iterator[Vector]:
    """Corners of all shapes of a model, at some of its times."""
    if track.actor.is_ground:
        return
    poses = list(link_poses(track.actor.model, name=track.actor.name))
    rows = len(track.links[poses[0].name]) if poses else 0
    for number in [*range(0, rows, max(1, rows // _MOMENTS)), *([rows - 1] if rows else [])]:
        placed = {pose.name: _posed(pose, track.links[pose.name][number]) for pose in poses}
        yield from outline(track.actor.shapes, placed)


def _happenings(tape: WorldTape, settings: WorldSettings) -> Iterator[TopicTrack]:
    """Contacts and scans; those that are not wanted are left out, since they are long."""
    scale = ForceScale([track.actor for track in tape.tracks], tape.gravity)
    if settings.contacts:
        seen = [(time, contact_marks(found, scale, is_on=True)) for time, found in tape.contacts]
        yield _display(seen, contact_marks((), scale, is_on=True))
    if settings.scans and tape.scans:
        seen = [(time, laser_marks(points, is_on=True)) for time, points in tape.scans]
        yield _display(seen, laser_marks((), is_on=True))


def _display(seen: Sequence[tuple[float, Marks]], nothing: Marks) -> TopicTrack:
    return TopicTrack(
        marks=seen[-1][1] if seen else nothing,
        moments=tuple((time, Shown(points=one.points, lines=one.lines)) for time, one in seen),
        keep=0,
    )
