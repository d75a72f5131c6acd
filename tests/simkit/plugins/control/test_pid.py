"""A PID: each of its parts, its limits."""

from __future__ import annotations

import math

import pytest

from simkit.plugins.control.pid import Gains, Pid


def test_the_proportional_part_is_the_gain_times_the_error():
    assert Pid(Gains(p=3.0)).command(-2.0, 0.1) == -6.0


def test_the_derivative_is_that_of_the_error():
    pid = Pid(Gains(p=0.0, d=2.0))
    assert pid.command(1.0, 0.5) == 4.0  # it begins with an error of 0
    assert pid.command(1.5, 0.5) == 2.0


def test_a_given_derivative_counts_instead():
    assert Pid(Gains(p=1.0, d=2.0)).command(1.0, 0.5, rate=-3.0) == 1.0 - 6.0


def test_without_a_clamp_the_integral_does_nothing():
    pid = Pid(Gains(p=0.0, i=5.0))
    assert [pid.command(1.0, 0.1) for _ in range(3)] == [0.0, 0.0, 0.0]


def test_the_integral_grows_up_to_its_clamp():
    pid = Pid(Gains(p=0.0, i=2.0, i_max=0.5, i_min=-0.5))
    found = [pid.command(1.0, 0.1) for _ in range(4)]
    assert found == pytest.approx([0.2, 0.4, 0.5, 0.5], abs=1e-12)


def test_without_antiwindup_the_integral_has_to_come_all_the_way_back():
    gains = Gains(p=0.0, i=1.0, i_max=0.1, i_min=-0.1)
    wound = Pid(gains)
    for _ in range(10):
        wound.command(1.0, 0.1)
    assert wound.command(-1.0, 0.1) == pytest.approx(0.1)
    held = Pid(Gains(p=0.0, i=1.0, i_max=0.1, i_min=-0.1, antiwindup=True))
    for _ in range(10):
        held.command(1.0, 0.1)
    assert held.command(-1.0, 0.1) == pytest.approx(0.0, abs=1e-12)


def test_antiwindup_works_with_a_negative_gain_too():
    pid = Pid(Gains(p=0.0, i=-1.0, i_max=0.1, i_min=-0.1, antiwindup=True))
    found = [pid.command(1.0, 0.08) for _ in range(3)]
    assert found == pytest.approx([-0.08, -0.1, -0.1], abs=1e-12)


@pytest.mark.parametrize(
    ("error", "period", "rate"),
    [(math.nan, 0.1, None), (math.inf, 0.1, None), (1.0, 0.0, None), (1.0, 0.1, math.nan)],
)
def test_what_is_no_number_gives_no_command(error, period, rate):
    assert Pid(Gains(p=1.0)).command(error, period, rate=rate) == 0.0


def test_a_reset_forgets_the_integral_and_the_last_error():
    pid = Pid(Gains(p=0.0, i=1.0, d=1.0, i_max=9.0, i_min=-9.0))
    first = pid.command(1.0, 0.1)
    pid.command(2.0, 0.1)
    pid.reset()
    assert pid.command(1.0, 0.1) == first
