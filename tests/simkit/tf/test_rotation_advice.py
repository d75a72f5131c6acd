"""What a learner is told about a rotation that is none."""

from __future__ import annotations

import math

import pytest

from simkit.tf.rotation_advice import rotation_advice


def test_a_rotation_needs_no_advice():
    assert rotation_advice("a", (0.0, 0.0, 0.0, 1.0)) == ""


@pytest.mark.parametrize(
    ("rotation", "words"),
    [
        ((0.0, 0.0, 1.57, 0.0), "norm 1.57 instead of 1. If these are angles"),
        ((0.0, 0.0, 0.0, 0.0), "all zeros"),
        ((0.0, 0.0, math.nan, 1.0), "nan"),
    ],
)
def test_advice(rotation, words):
    assert words in rotation_advice("carrot1", rotation)
