"""The oracle of rotations: laws, and agreement with numpy."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.checks import rotations

ANGLES = st.floats(-10.0, 10.0)


@given(ANGLES, ANGLES, ANGLES)
def test_rpy_is_a_rotation(roll, pitch, yaw):
    matrix = np.array(rotations.rotation_of(roll, pitch, yaw))
    assert matrix @ matrix.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(matrix) == pytest.approx(1.0)


@given(ANGLES)
def test_a_turn_and_the_turn_back_cancel(angle):
    for about in (rotations.about_x, rotations.about_y, rotations.about_z):
        turned = about(angle)
        assert rotations.apart(rotations.times(turned, rotations.back(turned)), about(0.0)) < 1e-6
        assert rotations.apart(turned, about(0.0)) == pytest.approx(
            abs(math.remainder(angle, math.tau)), abs=1e-6
        )


def test_fixed_axes_in_the_order_of_urdf():
    matrix = np.array(rotations.rotation_of(0.1, 0.2, 0.3))
    x, y, z = (
        np.array(about(angle))
        for about, angle in (
            (rotations.about_x, 0.1),
            (rotations.about_y, 0.2),
            (rotations.about_z, 0.3),
        )
    )
    assert matrix == pytest.approx(z @ y @ x)


def test_a_positive_turn_about_y_lowers_what_points_forward():
    assert np.array(rotations.about_y(0.5)) @ (1, 0, 0) == pytest.approx(
        (math.cos(0.5), 0, -math.sin(0.5))
    )


@given(ANGLES)
def test_a_quaternion_about_z(angle):
    turn = SimpleNamespace(x=0.0, y=0.0, z=math.sin(angle / 2), w=math.cos(angle / 2))
    assert np.array(rotations.of_quaternion(turn)) == pytest.approx(
        np.array(rotations.about_z(angle)), abs=1e-12
    )
