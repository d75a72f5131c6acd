"""When a plugin that works so many times a second is due."""

from __future__ import annotations

import pytest

from simkit.plugins.rate import UpdateRate

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
