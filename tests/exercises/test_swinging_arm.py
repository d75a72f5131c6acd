"""The arm as a double pendulum, integrated by itself."""

import math

import pytest

from oracles.swinging_arm import SwingingArm

# Hip and shoulder [rad] of the book's arm, let go from level, by a method of high order.
KNOWN = {
    0.1: (0.005109, 0.181554),
    0.25: (0.316361, 1.137432),
    0.3: (1.114691, 1.729059),
    0.5: (1.739964, 3.037881),
    1.0: (0.027825, 0.414187),
}


@pytest.mark.parametrize("seconds", KNOWN)
def test_it_agrees_with_known_motion_of_the_book_s_rounded_numbers(seconds):
    book = SwingingArm(across=0.01396)
    assert book.swing(0.0, 0.0, seconds) == pytest.approx(KNOWN[seconds], abs=1e-5)


def test_hanging_down_at_rest_it_stays():
    assert SwingingArm().swing(0.3, math.pi / 2, 1.0) == pytest.approx((0.3, math.pi / 2), abs=1e-9)


def test_small_swings_have_the_period_of_the_formula_where_the_arm_hangs_in_line():
    arm = SwingingArm(offset=0.0)  # then the hip feels nothing
    period = 2 * math.pi * math.sqrt(arm.inertia / (arm.mass * arm.gravity * arm.lever))
    start = math.pi / 2 - 0.01
    assert arm.swing(0.0, start, period) == pytest.approx((0.0, start), abs=1e-6)
    assert arm.swing(0.0, start, period / 2)[1] == pytest.approx(math.pi / 2 + 0.01, abs=1e-6)


def test_it_swings_the_same_way_wherever_the_hip_begins():
    hip, shoulder = SwingingArm().swing(0.0, 0.4, 0.7)
    turned = SwingingArm().swing(1.5, 0.4, 0.7)
    assert turned == pytest.approx((hip + 1.5, shoulder), abs=1e-9)
