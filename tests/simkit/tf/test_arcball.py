"""The virtual trackball of tf.transformations."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.tf import transformations as tr

pixels = st.tuples(st.floats(-300, 300), st.floats(-300, 300))


@given(pixels)
def test_every_point_lies_on_the_unit_sphere_on_the_viewers_side(point):
    on_sphere = tr.arcball_map_to_sphere(point, (0, 0), 100)
    assert np.linalg.norm(on_sphere) == pytest.approx(1.0)
    assert on_sphere[2] >= 0


@given(pixels, st.sampled_from([(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0, 0.8)]))
def test_a_constrained_point_is_at_right_angles_to_its_axis(point, axis):
    on_sphere = tr.arcball_map_to_sphere(point, (0, 0), 100)
    constrained = tr.arcball_constrain_to_axis(on_sphere, axis)
    assert np.dot(constrained, axis) == pytest.approx(0.0, abs=1e-9)
    assert np.linalg.norm(constrained) == pytest.approx(1.0)


def test_a_drag_from_the_middle_to_the_rim_turns_twice_the_angle_about_the_axis_between():
    ball = tr.Arcball()
    ball.place([200, 200], 100)
    ball.down([200, 200])
    ball.drag([250, 200])  # 30 degrees on the sphere, to the right
    expected = tr.rotation_matrix(math.radians(60), (0, 1, 0))
    np.testing.assert_allclose(ball.matrix(), expected, atol=1e-12)


def test_a_drag_back_undoes_and_two_drags_add_up():
    ball = tr.Arcball(tr.quaternion_from_euler(0.1, 0.2, 0.3))
    before = ball.matrix()
    ball.place([0, 0], 100)
    ball.down([10, 20])
    ball.drag([60, -20])
    assert not np.allclose(ball.matrix(), before)
    ball.drag([10, 20])
    np.testing.assert_allclose(ball.matrix(), before, atol=1e-12)


def test_next_goes_on_by_the_same_turn():
    ball = tr.Arcball()
    ball.place([0, 0], 100)
    ball.down([0, 0])
    ball.drag([10, 0])
    once = ball.matrix()
    ball.next()
    np.testing.assert_allclose(ball.matrix(), once @ once, atol=1e-9)


def test_a_constrained_drag_keeps_the_axis():
    ball = tr.Arcball()
    ball.place([0, 0], 100)
    ball.setaxes([0, 0, 1])
    ball.setconstrain(True)
    assert ball.getconstrain()
    ball.down([80, 10])
    ball.drag([30, 70])
    np.testing.assert_allclose(ball.matrix()[:3, 2], [0, 0, 1], atol=1e-12)


def test_nearest_axis_and_a_wrong_beginning():
    axes = [(1, 0, 0), (0, 1, 0)]
    point = tr.arcball_map_to_sphere((90, 5), (0, 0), 100)
    assert tuple(tr.arcball_nearest_axis(point, axes)) == (0, 1, 0)
    with pytest.raises(ValueError, match="quaternion"):
        tr.Arcball([1, 2, 3])
