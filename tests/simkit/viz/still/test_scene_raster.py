from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from simkit.viz.stage.camera import on_paper
from simkit.viz.stage.parts import Marks, Role
from simkit.viz.stage.scene import Displays, make_scene
from simkit.viz.stage.style import AXIS_COLORS, rgb
from simkit.viz.still import scene_raster
from simkit.viz.still.scene_raster import scene_pixels

SIZE = (360.0, 225.0)


def pixels(scene):
    return scene_pixels(scene, size=SIZE).astype(float)


def hue(image, color, tolerance=0.04):
    """Which pixels that are not nearly clear have a colour, however bright."""
    shares = image[:, :, :3] / np.maximum(image[:, :, :3].sum(axis=2, keepdims=True), 1)
    wanted = np.array(color) / sum(color)
    return (np.abs(shares - wanted) < tolerance).all(axis=2) & (image[:, :, 3] > 100)


def only_robot(**changes):
    return Displays(grid=False, tf=False, **changes)


def test_a_cylinder_stands_upright(arm_frames, arm):
    solids = tuple(s for s in arm.solids if s.link == "torso" and s.role is Role.VISUAL)
    scene = make_scene(
        arm_frames,
        fixed_frame="world",
        robot=replace(arm, solids=solids),
        displays=only_robot(),
    )
    rows, columns = np.nonzero(pixels(scene)[:, :, 3] > 128)
    assert np.ptp(rows) > 3.5 * np.ptp(columns)
    # As wide as it is high it would be, seen from above.
    above = replace(scene.stage.camera, elevation=np.pi / 2)
    scene = replace(scene, stage=replace(scene.stage, camera=above))
    rows, columns = np.nonzero(pixels(scene)[:, :, 3] > 128)
    assert np.ptp(rows) == pytest.approx(np.ptp(columns), rel=0.1)


def test_shapes_are_where_the_camera_sees_them_in_their_colour(arm_frames, arm):
    scene = make_scene(arm_frames, fixed_frame="world", robot=arm, displays=only_robot())
    image = pixels(scene)
    for placed in scene.solids:
        if placed.solid.role is Role.VISUAL:
            x, y = on_paper(scene.stage.camera.seen(placed.pose()[0]), SIZE)
            at = image[round(y), round(x)]
            assert hue(at[None, None], placed.color)


def test_the_grid_the_frames_and_the_role_are_a_matter_of_the_displays(arm_frames, arm):
    def image(displays):
        scene = make_scene(arm_frames, fixed_frame="world", robot=arm, displays=displays)
        return pixels(scene)

    assert not image(Displays(grid=False, tf=False, robot=None)).any()
    grid = image(Displays(tf=False, robot=None))
    assert 0 < (grid[:, :, 3] > 0).mean() < 0.2
    frames = image(Displays(grid=False, robot=None))
    for color in AXIS_COLORS:
        assert hue(frames, rgb(color)).sum() > 30
    visual, collision = image(only_robot()), image(only_robot(robot=Role.COLLISION))
    assert (visual[:, :, 3] > 0).sum() > (collision[:, :, 3] > 0).sum() > 500


def test_axes_inside_of_a_robot_shine_through_it(arm_frames, arm):
    with_axes = make_scene(
        arm_frames, fixed_frame="world", robot=arm, displays=Displays(grid=False)
    )
    without = replace(with_axes, displays=only_robot())
    x, y = on_paper(with_axes.stage.camera.seen((0, 0, 0.1)), SIZE)  # on z of torso, inside of it
    here = (slice(round(y) - 2, round(y) + 3), slice(round(x) - 2, round(x) + 3))
    seen, hidden = pixels(with_axes)[here], pixels(without)[here]
    assert (seen[..., 2] - seen[..., 0]).max() > (hidden[..., 2] - hidden[..., 0]).max() + 20
    assert not hue(seen, rgb(AXIS_COLORS[2])).any()


def test_through_a_transparent_shape_one_sees_what_is_behind(arm_frames, arm):
    clear = replace(arm, solids=tuple(replace(s, alpha=0.3) for s in arm.solids))
    scene = make_scene(arm_frames, fixed_frame="world", robot=clear, displays=only_robot())
    opacity = pixels(scene)[:, :, 3]
    assert 70 < np.median(opacity[opacity > 0]) < 140
    assert opacity.max() < 255


def test_what_is_made_transparent_is_seen_through(arm_frames, arm):
    scene = make_scene(arm_frames, fixed_frame="world", robot=arm, displays=only_robot())
    clear = replace(scene, displays=only_robot(transparent=True))
    assert pixels(scene)[:, :, 3].max() == 255
    assert 0 < pixels(clear)[:, :, 3].max() < 255


def test_points_and_lines_are_drawn_in_their_colours(arm_frames):
    marks = Marks(
        name="contacts",
        label="Contacts",
        color="#00c000",
        points=((0.0, 0.0, 0.2),),
        lines=(((-0.1, 0.0, 0.0), (0.1, 0.0, 0.0), (0.1, 0.0, 0.3)),),
    )
    scene = make_scene(arm_frames, fixed_frame="world", displays=Displays(grid=False, tf=False))
    assert hue(pixels(replace(scene, marks=(marks,))), (0, 1, 0)).sum() > 100
    assert not pixels(replace(scene, marks=(replace(marks, is_on=False),))).any()


def test_marks_are_hidden_by_shapes_unless_they_shine_through(arm_frames, arm):
    inside = Marks(name="m", label="m", color="#00ff00", points=((0.0, 0.0, 0.3),))
    scene = make_scene(arm_frames, fixed_frame="world", robot=arm, displays=only_robot())
    without, hidden, shining = (
        pixels(replace(scene, marks=marks))
        for marks in ((), (inside,), (replace(inside, shines_through=True),))
    )
    assert (hidden == without).all()
    assert (shining != without).any(axis=2).sum() > 3


def test_a_picture_is_made_in_bands_without_seams(arm_frames, arm, monkeypatch):
    scene = make_scene(arm_frames, fixed_frame="world", robot=arm)
    images = []
    for rows in (7, 1000):
        monkeypatch.setattr(scene_raster, "_BAND", rows)
        images.append(pixels(scene))
    assert (np.abs(images[0] - images[1]).max(axis=2) > 3).mean() < 1e-4


def test_equal_scenes_give_equal_pixels(two_trees):
    one, two = (scene_pixels(make_scene(two_trees, fixed_frame="map"), size=SIZE) for _ in range(2))
    assert one.tobytes() == two.tobytes()
    assert one.shape == (225, 360, 4)


def test_a_storm_of_frames_is_drawn(buffer):
    for number in range(200):
        buffer.put("world", f"f{number}", xyz=(number % 40, number // 40, 0))
    assert pixels(make_scene(buffer, fixed_frame="world"))[:, :, 3].any()
