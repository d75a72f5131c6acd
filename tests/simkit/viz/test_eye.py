from __future__ import annotations

import numpy as np
import pytest

from simkit.viz.camera import Camera
from simkit.viz.eye import Eye

CAMERA = Camera(target=(0.0, 0.0, 0.0), distance=5.0, azimuth=-1.2, elevation=0.5)
RED = (1.0, 0.0, 0.0)


def eye():
    return Eye(CAMERA, (160.0, 100.0), 2, (20, 180))


def drawn_one_by_one(segments):
    found = eye()
    for start, end in segments:
        found.line(found.solid, tuple(start), tuple(end), width=3.0, color=RED)
    return found.solid


def drawn_at_once(segments):
    found = eye()
    found.lines(found.solid, np.array(segments, dtype=float), width=3.0, color=RED)
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


def test_lines_are_seen():
    assert drawn_at_once([((-1, 0, 0), (1, 0, 0))]).filled.sum() > 100
