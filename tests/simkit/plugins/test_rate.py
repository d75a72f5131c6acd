"""When a plugin that works so many times a second is due."""

from __future__ import annotations

import pytest

from simkit.plugins.rate import SensorRate, UpdateRate

MS = 1_000_000


def due(hertz: float, steps: int, *, start_ns: int = 0) -> list[int]:
    """After how many steps of 1 ms it is due."""
    rate = UpdateRate(hertz, start_ns)
    return [step for step in range(1, steps + 1) if rate.is_due(start_ns + step * MS)]


def test_it_is_due_a_step_after_each_period():
    assert due(20.0, 160) == [51, 101, 151]


def test_a_period_that_is_no_whole_number_of_steps_is_kept_on_average():
    assert due(30.0, 1000)[:4] == [34, 67, 100, 134]
    assert len(due(30.0, 1000)) == 30


def test_it_counts_from_when_it_was_made():
    assert due(20.0, 120, start_ns=7_777_000) == [51, 101]


@pytest.mark.parametrize("hertz", [0.0, 1000.0])
def test_at_zero_it_is_due_each_step_and_at_the_rate_of_steps_almost(hertz):
    assert due(hertz, 10) == list(range(1 if hertz == 0.0 else 2, 11))


def test_it_tells_how_long_it_took():
    rate = UpdateRate(20.0, 0)
    elapsed = [rate.elapsed_ns for step in range(1, 160) if rate.is_due(step * MS)]
    assert elapsed == [51 * MS] * 3


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
