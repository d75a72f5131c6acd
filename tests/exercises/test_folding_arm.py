"""Forward kinematics of the arm with an elbow, against places that one sees without computing."""

import math

import pytest

from oracles.folding_arm import elbow_and_tip, middle

QUARTER = math.pi / 2


@pytest.mark.parametrize(
    ("angles", "elbow", "tip"),
    [
        ((0, 0, 0), (0.4, -0.2, 0.5), (0.7, -0.2, 0.5)),
        ((0, 0, QUARTER), (0.4, -0.2, 0.5), (0.4, -0.2, 0.2)),
        ((0, -QUARTER, 0), (0.0, -0.2, 0.9), (0.0, -0.2, 1.2)),
        ((0, -QUARTER, QUARTER), (0.0, -0.2, 0.9), (0.3, -0.2, 0.9)),
        ((QUARTER, 0, 0), (0.2, 0.4, 0.5), (0.2, 0.7, 0.5)),
        ((math.pi, 0, -QUARTER), (-0.4, 0.2, 0.5), (-0.4, 0.2, 0.8)),
    ],
)
def test_the_ends_of_the_lower_arm_are_where_one_sees_them(angles, elbow, tip):
    ends = elbow_and_tip(*angles)
    assert ends[0] == pytest.approx(elbow, abs=1e-12)
    assert ends[1] == pytest.approx(tip, abs=1e-12)
    halves = [(a + b) / 2 for a, b in zip(elbow, tip, strict=True)]
    assert middle(ends) == pytest.approx(halves, abs=1e-12)
