from __future__ import annotations

import io

import numpy as np
import pytest
from matplotlib.image import imread

from simkit.viz.draw.svg import svg_text
from simkit.viz.stage.scene import Displays, make_scene
from simkit.viz.still.picture import SIZE, still_drawing, still_png
from simkit.viz.still.scene_raster import scene_pixels


def test_it_names_every_frame_and_says_what_is_wrong(two_trees, texts):
    shown = texts(svg_text(still_drawing(make_scene(two_trees, fixed_frame="map"))))
    assert {"map", "odom", "base_link", "laser", "Fixed Frame: map", "grid: 0.5 m"} < set(shown)
    assert any("No transform from [world] to [map]" in text for text in shown)


def test_without_tf_and_grid_there_are_no_names_and_no_scale(turtles, texts):
    scene = make_scene(turtles, fixed_frame="world", displays=Displays(grid=False, tf=False))
    assert texts(svg_text(still_drawing(scene))) == ["Fixed Frame: world"]


def test_hostile_names_are_only_names(hostile, texts):
    shown = texts(svg_text(still_drawing(make_scene(hostile, fixed_frame="wörld"))))
    assert "<script>alert(1)</script>" in shown


def test_a_storm_of_frames_is_drawn_without_all_their_names(buffer):
    for number in range(1500):
        buffer.put("world", f"f{number}", xyz=(number % 40, number // 40, 0))
    shapes = still_drawing(make_scene(buffer, fixed_frame="world")).shapes
    assert 100 < len(shapes) < 450


def test_the_pixels_are_at_the_top_and_the_sentences_below_them(two_trees):
    scene = make_scene(two_trees, fixed_frame="map", displays=Displays(tf=False))
    image = imread(io.BytesIO(still_png(scene, scale=1)), format="png")
    height, width, _ = image.shape
    assert (width, height) == (720, 450 + 4 * 18 + 10)
    pixels = scene_pixels(scene, size=SIZE) / 255.0
    solid = pixels[100:400, :, 3] == 1.0  # away from the words in the corners
    assert solid.sum() > 500
    shown = image[100:400, :, :3][solid]
    assert shown == pytest.approx(pixels[100:400, :, :3][solid], abs=0.01)
    below = image[460:, :, :3]
    assert (np.abs(below - np.array([0.63, 0.10, 0.07])).max(axis=2) < 0.1).sum() > 300
