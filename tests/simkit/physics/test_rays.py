"""Rays find what is in their way, and how far away it is."""

from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.geometry import matrix_from_rpy
from simkit.physics import MISS, Plane
from simkit.physics.mesh import CollisionMesh
from simkit.physics.rays import Hits, Target, ball_around
from simkit.physics.rays import cast as cast_at
from simkit.urdf import Box, Cylinder, Sphere

BEAMS = 720


def cast(origins, directions, targets, reach) -> Hits:
    if np.ndim(origins) == 1:
        return cast_at(tuple(origins), directions, targets=targets, reach=reach)
    found = [
        cast(origin, way[None], targets, reach)
        for origin, way in zip(origins, directions, strict=True)
    ]
    return Hits(
        *(
            np.concatenate([getattr(one, name) for one in found])
            for name in ("distances", "targets")
        )
    )


def fan(count: int = BEAMS, width: float = math.pi) -> np.ndarray:
    angles = np.linspace(-width / 2, width / 2, count)
    return np.stack([np.cos(angles), np.sin(angles), np.zeros(count)], axis=1)


def target(shape, origin=(0.0, 0.0, 0.0), rpy=(0.0, 0.0, 0.0)) -> Target:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = matrix_from_rpy(rpy), origin
    return Target.at(shape, ball_around(shape), matrix)


def depth(shape, points: np.ndarray) -> np.ndarray:
    """How far points are outside of a shape [m], in its frame; 0 on its surface."""
    match shape:
        case Box():
            return (np.abs(points) - np.array(shape.size) / 2).max(axis=1)
        case Cylinder():
            across = np.hypot(points[:, 0], points[:, 1]) - shape.radius
            return np.maximum(across, np.abs(points[:, 2]) - shape.length / 2)
        case Sphere():
            return np.linalg.norm(points, axis=1) - shape.radius
        case _:
            return points @ np.array(shape.normal)


SHAPES = [Box((0.4, 0.6, 1.0)), Cylinder(0.3, 0.8), Sphere(0.5)]


def test_a_fan_against_a_wall():
    hits = cast(np.zeros(3), fan(width=2.0), [target(Box((1.0, 100.0, 1.0)), (3.0, 0.0, 0.0))], 1e9)
    angles = np.linspace(-1.0, 1.0, BEAMS)
    assert np.abs(hits.distances - 2.5 / np.cos(angles)).max() < 1e-12
    assert (hits.targets == 0).all()


def test_a_fan_against_a_pillar():
    pillar = target(Cylinder(0.5, 2.0), (4.0, 1.0, 0.0))
    hits = cast(np.zeros(3), fan(), [pillar], 1e9)
    directions = fan()
    along = directions @ np.array([4.0, 1.0, 0.0])
    aside = 17.0 - along**2
    with np.errstate(invalid="ignore"):
        expected = np.where((aside <= 0.25) & (along > 0), along - np.sqrt(0.25 - aside), np.inf)
    seen = np.isfinite(expected)
    assert seen.sum() > 20
    assert (np.isfinite(hits.distances) == seen).all()
    assert np.abs(hits.distances[seen] - expected[seen]).max() < 1e-9


@pytest.mark.parametrize("shape", SHAPES)
def test_rays_end_on_the_surface_and_pass_nothing_before(shape):
    rng = np.random.default_rng(1)
    place, rpy = (0.3, -0.2, 0.5), (0.4, -0.7, 1.1)
    origins = rng.normal(size=(500, 3)) * 2.0
    directions = np.array(place) + rng.normal(size=(500, 3)) * 0.5 - origins
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    hits = cast(origins, directions, [target(shape, place, rpy)], 1e9)
    turn = np.array(matrix_from_rpy(rpy))

    def outside(distances):
        points = origins + directions * distances[:, None]
        return depth(shape, (points - np.array(place)) @ turn)

    hit = np.isfinite(hits.distances)
    assert 100 < hit.sum() < 500
    assert np.abs(outside(np.where(hit, hits.distances, 0.0))[hit]).max() < 1e-9
    starts_outside = outside(np.zeros(500)) > 0.0
    for share in np.linspace(0.0, 0.999, 50):
        way = np.where(hit, hits.distances, 6.0) * share
        assert ((outside(way) > 0.0) == starts_outside).all()


def test_a_ray_from_within_hits_the_wall_from_within():
    for shape, distance in zip(SHAPES, (0.2, 0.3, 0.5), strict=True):
        hits = cast(np.zeros((1, 3)), np.array([[1.0, 0.0, 0.0]]), [target(shape)], 1e9)
        assert hits.distances[0] == pytest.approx(distance)


def test_rays_along_the_axes():
    box = target(Box((1.0, 1.0, 1.0)))
    origins = np.array([[-2.0, 0.0, 0.0], [-2.0, 0.4999, 0.0], [-2.0, 0.6, 0.0], [0.0, 0.0, -2.0]])
    directions = np.array([[1.0, 0, 0], [1.0, 0, 0], [1.0, 0, 0], [0, 0, 1.0]])
    assert cast(origins, directions, [box], 1e9).distances.tolist() == [1.5, 1.5, math.inf, 1.5]
    pillar = target(Cylinder(0.5, 2.0))
    origins = np.array([[0.2, 0.0, 5.0], [0.6, 0.0, 5.0], [0.0, 0.0, -3.0], [-2.0, 0.0, 0.0]])
    directions = np.array([[0, 0, -1.0], [0, 0, -1.0], [0, 0, 1.0], [1.0, 0, 0]])
    assert cast(origins, directions, [pillar], 1e9).distances.tolist() == [4.0, math.inf, 2.0, 1.5]


def test_the_ground_from_above_and_below():
    origins = np.array([[0.0, 0, 2.0], [0, 0, -2.0], [0, 0, 2.0], [0, 0, 2.0]])
    down = math.sqrt(0.5)
    directions = np.array([[0.0, 0, -1.0], [0, 0, 1.0], [down, 0, -down], [1.0, 0, 0]])
    found = cast(origins, directions, [target(Plane())], 1e9).distances
    assert found.tolist() == pytest.approx([2.0, 2.0, 2.0 / down, math.inf])


def test_the_nearest_thing_counts_and_is_named():
    near, far = target(Sphere(0.1), (2.0, 0, 0)), target(Sphere(0.5), (4.0, 0, 0))
    directions = np.array([[1.0, 0, 0], [0, 1.0, 0], [math.cos(0.1), math.sin(0.1), 0]])
    for order, numbers in (((near, far), [0, MISS, 1]), ((far, near), [1, MISS, 0])):
        hits = cast(np.zeros(3), directions, order, 1e9)
        assert hits.targets.tolist() == numbers
        assert hits.distances[0] == pytest.approx(1.9)


def test_nothing_beyond_reach_is_hit():
    wall = [target(Box((1.0, 9.0, 9.0)), (3.0, 0.0, 0.0))]
    ahead = np.array([[1.0, 0.0, 0.0]])
    assert cast(np.zeros(3), ahead, wall, 2.5).distances[0] == 2.5
    assert cast(np.zeros(3), ahead, wall, 2.49).distances[0] == math.inf


def test_what_is_behind_is_not_hit():
    behind = [target(shape, (-3.0, 0.0, 0.0)) for shape in SHAPES]
    hits = cast(np.zeros(3), fan(), behind, 1e9)
    assert (hits.targets == MISS).all()


def box_mesh() -> CollisionMesh:
    """A box of 0.4 x 0.6 x 1.0 as twelve triangles."""
    x, y, z = 0.2, 0.3, 0.5
    corners = np.array([[i, j, k] for i in (-x, x) for j in (-y, y) for k in (-z, z)])
    faces = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)]
    triangles = [t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))]
    return CollisionMesh.of(corners[np.array(triangles)])


def test_a_mesh_is_seen_as_the_solid_that_it_is():
    rng = np.random.default_rng(2)
    place, rpy = (1.0, 0.5, 0.2), (0.3, 0.2, 0.1)
    origins = rng.normal(size=(2000, 3)) * 2.0
    directions = np.array(place) + rng.normal(size=(2000, 3)) * 0.4 - origins
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    mesh = cast(origins, directions, [target(box_mesh(), place, rpy)], 1e9)
    box = cast(origins, directions, [target(SHAPES[0], place, rpy)], 1e9)
    assert np.isfinite(box.distances).sum() > 500
    both = np.isfinite(box.distances)
    assert (np.isfinite(mesh.distances) == both).all()
    assert np.abs(mesh.distances[both] - box.distances[both]).max() < 1e-9


def test_nothing_is_a_number_and_a_half():
    """Rays within a face, along an edge, from the middle: some answer, and no warning."""
    places = np.array(
        [[x, y, z] for x in (-2.0, 0.0) for y in (0.0, 0.5) for z in (-1.0, 0.0, 0.5)]
    )
    ways = np.eye(3)
    for shape in (Box((1.0, 1.0, 1.0)), Cylinder(0.5, 1.0), Sphere(0.5), Plane(), box_mesh()):
        for way in (*ways, *-ways):
            hits = cast(places, np.tile(way, (len(places), 1)), [target(shape)], 1e9)
            assert not np.isnan(hits.distances).any()
            assert (hits.distances >= 0.0).all()


def test_far_away_is_as_exact():
    place = (1e4, 2e4, 0.0)
    start = np.array([1e4 - 3.0, 2e4, 0.0])
    hits = cast(start, np.array([[1.0, 0.0, 0.0]]), [target(Sphere(0.5), place)], 1e9)
    assert hits.distances[0] == pytest.approx(2.5, abs=1e-9)


def test_no_target_and_no_ray():
    assert cast(np.zeros(3), fan(), [], 1e9).targets.tolist() == [MISS] * BEAMS
    assert cast(np.zeros(3), np.zeros((0, 3)), [target(Sphere(1.0))], 1e9).distances.shape == (0,)


def test_many_triangles_are_cast_in_batches(monkeypatch):
    monkeypatch.setattr("simkit.physics.ray_solids.MOST_AT_ONCE", 100)
    mesh = target(box_mesh(), (2.0, 0.0, 0.0))
    few = cast(np.zeros(3), fan(), [mesh], 1e9)
    monkeypatch.undo()
    assert (few.distances == cast(np.zeros(3), fan(), [mesh], 1e9).distances).all()


def test_a_world_casts_rays_at_all_that_others_touch(new_world, robot_plan, solid, at):
    world = new_world()
    car = world.add(robot_plan("car"), pose=at(x=1.0))
    world.add(solid("box", 0.2, 4.0, 2.0, still=True), name="wall", pose=at(x=5.0, z=1.0))
    hits = world.cast_rays(
        [(0.0, 0.0, 0.25), (0.0, 0.0, 0.9), (0.0, 0.0, 0.9), (1.0, 0.0, 0.25)],
        [(1.0, 0, 0), (1.0, 0, 0), (0, 0, -1.0), (1.0, 0, 0)],
    )
    seen = [world.targets[number] for number in hits.targets]
    assert [(one.model, one.plan.link) for one in seen] == [
        ("practice_car", "chaiss"),
        ("wall", "body"),
        ("ground_plane", "link"),
        ("practice_car", "chaiss"),  # from within
    ]
    assert hits.distances == pytest.approx([0.7, 4.9, 0.9, 0.3])
    world.remove("wall")
    car.set_pose(at(x=2.0, angle=math.pi / 2))
    again = world.cast_rays((0.0, 0.0, 0.25), [(1.0, 0.0, 0.0)])
    assert again.distances[0] == pytest.approx(1.8)


def test_a_scan_is_faster_than_single_casts_of_the_engine(new_world, robot_plan, solid, at):
    """Three times is promised, four is usual; this only sees that nobody has put a loop into it."""
    import time

    world = new_world()
    world.add(robot_plan("car"))
    for i in range(4):
        pose = at(x=3.0 * math.cos(i), y=3.0 * math.sin(i), z=0.5)
        world.add(solid("box", 0.5, 0.5, 1.0, still=True), name=f"box{i}", pose=pose)
    directions, start = fan(), np.array([0.4, 0.0, 0.3])
    import dartpy

    detector = dartpy.collision.DARTCollisionDetector()
    group = detector.createCollisionGroup()
    for model in world.models.values():
        group.addShapeFramesOf(model.built.skeleton)

    def ours() -> float:
        begin = time.process_time()
        world.cast_rays(start, directions, reach=10.0)
        return time.process_time() - begin

    def theirs() -> float:
        begin = time.process_time()
        for direction in directions:
            group.raycast(start, start + 10.0 * direction)
        return time.process_time() - begin

    assert min(theirs() for _ in range(3)) > 1.5 * min(ours() for _ in range(5))
