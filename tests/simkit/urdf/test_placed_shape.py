"""Shapes that stand somewhere, against points drawn inside of them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.geometry import Transform
from simkit.urdf import Box, Cylinder, Pose, Sphere
from simkit.urdf.placed_shape import PlacedShape, extent, is_sound, overlap, shrunk, volume

SHAPES = (Box((0.5, 0.3, 0.07)), Cylinder(0.1, 0.4), Cylinder(0.3, 0.02), Sphere(0.2))


def anywhere(rng, shape, *, spread=0.6):
    pose = Pose(tuple(rng.uniform(-spread, spread, 3)), tuple(rng.uniform(-3.0, 3.0, 3)))
    return PlacedShape(shape, pose.transform)


def points_in(rng, shape, count):
    """Points of a shape, drawn evenly from its bounding box, seen from outside."""
    half = extent(shape.shape) / 2
    drawn = rng.uniform(-half, half, (count, 3))
    seen = [shape.frame.apply(tuple(point)) for point in drawn]
    return [point for point in seen if shape.depth(point) >= 0.0]


@pytest.mark.parametrize("shape", SHAPES, ids=repr)
def test_no_point_of_a_shape_is_beyond_its_support_or_its_reach(shape):
    rng = np.random.default_rng(1)
    for _ in range(20):
        placed = anywhere(rng, shape)
        eye, way = rng.uniform(-1, 1, 3), tuple(rng.uniform(-1, 1, 3))
        highest = np.dot(placed.support(way), way)
        points = points_in(rng, placed, 600)
        assert points
        for point in points:
            assert np.dot(point, way) <= highest + 1e-12
            assert math.dist(point, eye) <= placed.farthest(tuple(eye)) + 1e-12
            assert point[2] >= placed.lowest() - 1e-12


@pytest.mark.parametrize("shape", SHAPES, ids=repr)
def test_the_support_lies_on_the_surface(shape):
    rng = np.random.default_rng(2)
    for _ in range(50):
        placed = anywhere(rng, shape)
        assert placed.depth(placed.support(tuple(rng.normal(size=3)))) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("shape", SHAPES, ids=repr)
def test_depth_is_the_distance_to_the_surface(shape):
    rng = np.random.default_rng(3)
    placed = anywhere(rng, shape)
    inside = points_in(rng, placed, 4000)
    for _ in range(50):
        point = tuple(rng.uniform(-1, 1, 3))
        outside = -placed.depth(point)
        if outside > 0.0:
            nearest = min(math.dist(point, inner) for inner in inside)
            assert outside - 1e-9 <= nearest <= outside + 0.1


def test_sizes_in_numbers():
    assert volume(Box((2.0, 3.0, 4.0))) == 24.0
    assert volume(Cylinder(1.0, 2.0)) == pytest.approx(2.0 * math.pi)
    assert volume(Sphere(1.0)) == pytest.approx(4.0 / 3.0 * math.pi)
    assert extent(Box((3.0, 4.0, 12.0))) == 13.0
    assert extent(Cylinder(1.5, 4.0)) == 5.0
    assert extent(Sphere(0.5)) == 1.0
    assert shrunk(Box((0.3, 0.3, 0.3)), 0.1) == Box(pytest.approx((0.1, 0.1, 0.1)))
    assert shrunk(Cylinder(0.3, 0.1), 0.1) is None
    assert shrunk(Sphere(0.3), 0.4) is None


@pytest.mark.parametrize(
    "shape", [Box((1.0, 0.0, 1.0)), Cylinder(-0.1, 1.0), Sphere(math.inf), Sphere(1e200)], ids=repr
)
def test_sizes_that_no_shape_has_are_not_sound(shape):
    assert not is_sound(shape)


@pytest.mark.parametrize("shape", SHAPES, ids=repr)
@pytest.mark.parametrize("other", SHAPES, ids=repr)
def test_shapes_with_a_deep_common_point_overlap_and_those_without_any_do_not(shape, other):
    rng = np.random.default_rng(4)
    for _ in range(60):
        one, two = anywhere(rng, shape, spread=0.2), anywhere(rng, other, spread=0.2)
        least = 0.005
        found = overlap(one, two, least)
        assert overlap(two, one, least) == found
        common = [min(one.depth(p), two.depth(p)) for p in points_in(rng, one, 60)]
        if max(common, default=-1.0) > 1.5 * least:
            assert found
        gap = math.dist(one.frame.translation, two.frame.translation)
        if gap > (extent(shape) + extent(other)) / 2:
            assert not found


def test_shapes_that_touch_do_not_overlap():
    box = PlacedShape(Box((0.5, 0.3, 0.07)), Transform())
    for y, expected in ((0.17, False), (0.171, False), (0.15, True)):
        wheel = PlacedShape(Cylinder(0.1, 0.04), Transform.from_rpy((0, y, 0), (math.pi / 2, 0, 0)))
        assert overlap(box, wheel, 0.005) is expected
