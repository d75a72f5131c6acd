from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.viz.stage.camera import Camera, fitted, on_paper, stage_for
from simkit.viz.stage.frames import tf_scene

SIZE = (800.0, 500.0)
LENGTHS = st.floats(-100, 100)
POINTS = st.lists(st.tuples(LENGTHS, LENGTHS, LENGTHS), min_size=2, max_size=12)
FROM_THE_SOUTH = Camera(target=(0, 0, 0), distance=10, azimuth=-math.pi / 2, elevation=0.0)


def test_from_the_south_x_leads_right_and_z_up():
    right, up, depth = FROM_THE_SOUTH.seen((1.0, 2.0, 3.0))
    assert (right, up, depth) == pytest.approx((1.0, 3.0, 12.0))


def test_from_above_y_leads_up():
    camera = Camera(target=(0, 0, 0), distance=10, azimuth=-math.pi / 2, elevation=math.pi / 2)
    assert camera.seen((1.0, 2.0, 3.0)) == pytest.approx((1.0, 2.0, 7.0))


def test_the_target_is_in_the_middle():
    assert on_paper(FROM_THE_SOUTH.seen((0, 0, 0)), SIZE) == (400.0, 250.0)


@given(st.floats(-10, 10), st.floats(-1.5, 1.5))
def test_the_basis_is_orthonormal_and_right_handed(azimuth, elevation):
    camera = Camera(target=(0, 0, 0), distance=1, azimuth=azimuth, elevation=elevation)
    (ax, ay, az), (bx, by, bz), back = camera.basis
    cross = (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
    assert cross == pytest.approx(back, abs=1e-9)
    assert math.hypot(ax, ay, az) == pytest.approx(1.0)


@given(POINTS, st.floats(-3, 3), st.floats(-1.2, 1.2))
def test_a_fitted_camera_sees_every_point(points, azimuth, elevation):
    start = Camera(target=points[0], distance=1.0, azimuth=azimuth, elevation=elevation)
    size = max(math.dist(points[0], point) for point in points)
    if size < 1e-3:
        return
    camera = fitted(start, points, fill=0.9)
    for point in points:
        seen = camera.seen(point)
        assert camera.is_before(seen)
        x, y = on_paper(seen, SIZE)
        assert 0 <= x <= SIZE[0]
        assert 0 <= y <= SIZE[1]


def test_a_fitted_camera_is_as_near_as_it_can_be_and_centred():
    points = [(x, y, 0.0) for x in (0.0, 8.0) for y in (0.0, 6.0)]
    camera = fitted(
        Camera(target=(0, 0, 0), distance=1, azimuth=-1.9, elevation=0.6), points, fill=0.9
    )
    xs, ys = zip(*(on_paper(camera.seen(point), SIZE) for point in points), strict=True)
    assert max((max(xs) - min(xs)) / SIZE[0], (max(ys) - min(ys)) / SIZE[1]) > 0.8
    assert (max(xs) + min(xs)) / 2 == pytest.approx(SIZE[0] / 2, abs=10)
    assert (max(ys) + min(ys)) / 2 == pytest.approx(SIZE[1] / 2, abs=10)


SIZE_stage = (720.0, 450.0)


@pytest.mark.parametrize("scale", [1e-2, 1.0, 3.0, 1e5])
def test_grid_axes_and_camera_fit_any_size(buffer, scale):
    for number in range(5):
        buffer.put("world", f"f{number}", xyz=[scale * number, scale * number**2 / 4, scale * 0.3])
    scene = tf_scene(buffer, fixed_frame="world")
    stage = stage_for(scene)
    mantissa = stage.cell / 10 ** math.floor(math.log10(stage.cell) + 1e-9)
    assert min(abs(mantissa - nice) for nice in (1, 2, 5, 10)) < 1e-6
    assert 4 <= stage.grid_x[1] - stage.grid_x[0] <= 20
    for pose in scene.poses:
        assert stage.grid_x[0] * stage.cell < pose.origin[0] < stage.grid_x[1] * stage.cell
        assert stage.grid_y[0] * stage.cell < pose.origin[1] < stage.grid_y[1] * stage.cell
        x, y = on_paper(stage.camera.seen(pose.origin), SIZE_stage)
        assert 0 < x < SIZE_stage[0]
        assert 0 < y < SIZE_stage[1]
    assert 0.02 * scale < stage.axis_length < 0.8 * scale


def test_one_place_and_no_place_give_a_stage_of_a_metre(buffer):
    empty = stage_for(tf_scene(buffer, fixed_frame="world"))
    buffer.put("world", "same")
    one = stage_for(tf_scene(buffer, fixed_frame="world"))
    for stage in (empty, one):
        assert 0.1 <= stage.cell <= 1.0
        assert stage.camera.distance > 1.0


def test_the_axes_of_many_frames_are_shorter(buffer):
    def axis(count):
        for number in range(1, count):
            buffer.put("world", f"f{number}", xyz=[number / count, 0, 0])
        buffer.put("world", "last", xyz=[1, 0, 0])
        return stage_for(tf_scene(buffer, fixed_frame="world")).axis_length

    few, many = axis(10), axis(100)
    assert many < few / 2
