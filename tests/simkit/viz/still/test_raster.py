from __future__ import annotations

import numpy as np
import pytest

from simkit.viz.stage.camera import Camera
from simkit.viz.still.raster import Eye, Layer

RED, BLUE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


def draw(layer, points, *, near=1.0, color=RED):
    points = np.array([points], float)
    nearness = np.broadcast_to(np.array(near, float), (1, 3))
    layer.draw(points, nearness, np.broadcast_to(np.array(color), (1, 3, 3)))


def test_a_pixel_is_filled_if_its_middle_is_in_the_triangle():
    layer = Layer(4, 3)
    draw(layer, [(0, 0), (3, 0), (0, 3)])
    assert (layer.nearness > 0).tolist() == [
        [True, True, False, False],
        [True, False, False, False],
        [False, False, False, False],
    ]


def test_triangles_that_share_an_edge_leave_no_gap_and_never_overlap():
    rng = np.random.default_rng(1)
    corners = rng.uniform(0, 40, (4, 2))
    middle = corners.mean(axis=0)
    corners = corners[np.argsort(np.arctan2(*(corners - middle).T))]
    count = np.zeros((40, 40), int)
    for i in range(4):
        layer = Layer(40, 40)
        draw(layer, [corners[i], corners[(i + 1) % 4], middle])
        count += layer.nearness > 0
    whole = Layer(40, 40)
    for i in range(4):
        draw(whole, [corners[i], corners[(i + 1) % 4], middle])
    assert count.max() == 1
    assert (count > 0).sum() == (whole.nearness > 0).sum() > 100


@pytest.mark.parametrize("order", [1, -1])
def test_the_nearer_one_is_seen_whatever_is_drawn_first(order):
    layer = Layer(4, 4)
    big = [(-9, -9), (20, -9), (-9, 20)]
    for near, color in [(1.0, RED), (2.0, BLUE)][::order]:
        draw(layer, big, near=near, color=color)
    assert (layer.colors == BLUE).all()
    assert layer.nearness == pytest.approx(2.0)


def test_nearness_and_colour_change_evenly_over_a_triangle():
    layer = Layer(11, 11)
    points = np.array([[(-50.0, 0.0), (50.0, 0.0), (0.0, 100.0)]])
    colors = np.array([[(0.0, 0, 0), (1.0, 0, 0), (0.5, 0, 0)]])
    layer.draw(points, np.array([[1.0, 2.0, 1.5]]), colors)
    assert layer.nearness[0] == pytest.approx(1.5 + (np.arange(11) + 0.5) / 100)
    assert layer.colors[0, :, 0] == pytest.approx(0.5 + (np.arange(11) + 0.5) / 100, abs=1e-6)


def test_triangles_outside_and_edge_on_draw_nothing():
    layer = Layer(4, 4)
    draw(layer, [(-9, 0), (-5, 0), (-9, 9)])
    draw(layer, [(9, 0), (15, 0), (9, 9)])
    draw(layer, [(0, 0), (2, 2), (4, 4)])
    layer.draw(np.zeros((0, 3, 2)), np.zeros((0, 3)), np.zeros((0, 3, 3)))
    assert not layer.nearness.any()


def test_many_triangles_are_drawn_as_one_by_one():
    rng = np.random.default_rng(2)
    points = rng.uniform(-10, 70, (300, 3, 2))
    nearness = rng.uniform(0.5, 2, (300, 3))
    colors = rng.uniform(0, 1, (300, 3, 3))
    together, single = Layer(64, 48), Layer(64, 48)
    together.draw(points, nearness, colors)
    for i in range(300):
        single.draw(points[i : i + 1], nearness[i : i + 1], colors[i : i + 1])
    assert np.array_equal(together.nearness, single.nearness)
    assert np.array_equal(together.colors, single.colors)


CAMERA = Camera(target=(0.0, 0.0, 0.0), distance=5.0, azimuth=-1.2, elevation=0.5)
RED_eye = (1.0, 0.0, 0.0)


def eye():
    return Eye(CAMERA, (160.0, 100.0), 2, (20, 180))


def drawn_one_by_one(segments):
    found = eye()
    for segment in segments:
        found.lines(found.solid, np.array([segment], dtype=float), width=3.0, color=RED_eye)
    return found.solid


def drawn_at_once(segments):
    found = eye()
    found.lines(found.solid, np.array(segments, dtype=float), width=3.0, color=RED_eye)
    return found.solid


@pytest.mark.parametrize(
    "segments",
    [
        [((-1, 0, 0), (1, 0.5, 0.2)), ((0, -1, 0), (0, 1, 1))],
        [((0, 0, 0), (0, -40, 10))],  # leads behind the camera
        [((0, -40, 10), (0.3, 0, 0))],
        [((0, -40, 10), (0, -50, 10)), ((0, 0, 0), (1, 0, 0))],  # is behind it
        [((0.5, 0, 0), (0.5, 0, 0)), ((0, 0, 0), (0, 0, 1))],  # has no length
        [((0, 0, 90), (1, 0, 90)), ((0, 0, 0), (0, 0, 1))],  # is above the picture
        [((0, -40, 10), (0, -50, 10))],
    ],
)
def test_many_lines_at_once_are_those_that_are_drawn_one_by_one(segments):
    one_by_one, at_once = drawn_one_by_one(segments), drawn_at_once(segments)
    assert at_once.nearness == pytest.approx(one_by_one.nearness)
    assert (at_once.colors == one_by_one.colors).all()


def test_lines_are_cut_at_the_camera():
    cut = drawn_at_once([((0, 0, 0), (0, -40, 10))])
    assert cut.filled.any()
    assert cut.nearness.max() <= 1 / (0.02 * CAMERA.distance)
    assert not drawn_at_once([((0, -40, 10), (0, -50, 10))]).filled.any()


def test_lines_are_seen():
    assert drawn_at_once([((-1, 0, 0), (1, 0, 0))]).filled.sum() > 100
