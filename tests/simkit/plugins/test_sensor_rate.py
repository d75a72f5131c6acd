"""A sensor keeps its rate: what it was late counts for the next time."""

from __future__ import annotations

import pytest

from simkit.plugins.sensor_rate import SensorRate

STEP = 1_000_000


def due_steps(rate: SensorRate, first: int, last: int) -> list[int]:
    return [step for step in range(first, last + 1) if rate.is_due(step * STEP)]


def test_a_period_of_whole_steps():
    assert due_steps(SensorRate(20, 0), 1, 160) == [50, 100, 150]


def test_a_rate_of_zero_is_due_each_step():
    assert due_steps(SensorRate(0, 0), 5, 9) == [5, 6, 7, 8, 9]


@pytest.mark.parametrize("hertz", [30, 70, 300])
def test_a_period_between_steps_is_kept_on_the_average(hertz):
    assert len(due_steps(SensorRate(hertz, 0), 1, 10_000)) == pytest.approx(10 * hertz, abs=1)


def test_after_a_sleep_it_is_due_at_once_and_makes_up_for_nothing():
    rate = SensorRate(20, 0)
    assert due_steps(rate, 1000, 1110) == [1000, 1050, 1100]


def test_it_begins_anew():
    rate = SensorRate(20, 0)
    assert rate.is_due(60 * STEP)
    rate.restart(60 * STEP)
    assert due_steps(rate, 61, 220) == [110, 160, 210]
