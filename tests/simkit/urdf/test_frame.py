"""Frames: where points go, and back."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.urdf import Pose
from simkit.urdf.frame import Frame

_vectors = st.tuples(*[st.floats(-10.0, 10.0)] * 3)
frames = st.builds(lambda xyz, rpy: Frame.of(Pose(xyz, rpy)), _vectors, _vectors)


def near(vector):
    return pytest.approx(vector, abs=1e-9)


def test_a_quarter_turn_takes_x_to_y():
    frame = Frame.of(Pose((1.0, 2.0, 3.0), (0.0, 0.0, 1.5707963267948966)))
    assert frame.point((1.0, 0.0, 0.0)) == near((1.0, 3.0, 3.0))


@given(frames, _vectors)
def test_back_undoes_point(frame, point):
    assert frame.back(frame.point(point)) == near(point)


@given(frames, frames, _vectors)
def test_then_is_one_frame_after_the_other(outer, inner, point):
    assert outer.then(inner).point(point) == near(outer.point(inner.point(point)))


@given(frames, frames, _vectors)
def test_from_here_undoes_then(outer, inner, point):
    assert outer.from_here(outer.then(inner)).point(point) == near(inner.point(point))
