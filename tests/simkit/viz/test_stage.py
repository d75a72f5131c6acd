from __future__ import annotations

import math

import pytest

from simkit.viz.camera import on_paper
from simkit.viz.stage import stage_for
from simkit.viz.tf_scene import tf_scene

SIZE = (720.0, 450.0)


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
        x, y = on_paper(stage.camera.seen(pose.origin), SIZE)
        assert 0 < x < SIZE[0]
        assert 0 < y < SIZE[1]
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
