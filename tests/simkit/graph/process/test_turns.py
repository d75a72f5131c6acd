"""When a script gets a turn."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.graph.executor import Executor
from simkit.graph.process.protocol import NEVER
from simkit.graph.process.turns import MILLISECOND, PATIENCE_NS, TURNS_PER_INSTANT, Turns


class Sleeper:
    """A node that notes its turns; `goes_on` says what it does at the end of one."""

    def __init__(self):
        self.executor = Executor(start_ns=0)
        self.turns = Turns(self.executor, self.act, lambda: self.has_input)
        self.has_input = False
        self.times = []
        self.goes_on = lambda: None

    def act(self):
        self.turns.begin()
        self.times.append(self.executor.now_ns)
        self.goes_on()

    def run(self, duration_ns):
        self.executor.run_to(self.executor.now_ns + duration_ns)


@pytest.fixture
def sleeper():
    return Sleeper()


def test_whatever_comes_at_one_instant_gives_one_turn(sleeper):
    sleeper.turns.soon()
    sleeper.turns.soon()
    sleeper.run(10)
    assert sleeper.times == [0]


def test_a_turn_makes_the_one_that_was_asked_for_needless(sleeper):
    sleeper.turns.sleep(5, 0, NEVER)
    sleeper.turns.soon()
    sleeper.run(10)
    assert sleeper.times == [0]


def test_one_that_sleeps_for_ever_gets_no_turn_by_itself(sleeper):
    sleeper.turns.sleep(NEVER, 0, NEVER)
    sleeper.run(10**12)
    assert sleeper.times == []


def test_what_is_taken_back_does_not_come(sleeper):
    sleeper.turns.sleep(5, 1, 1000)
    sleeper.turns.soon()
    sleeper.turns.cancel()
    sleeper.run(2000)
    assert sleeper.times == []


def test_the_clock_goes_on_however_often_a_node_wants_another_turn(sleeper):
    sleeper.goes_on = sleeper.turns.soon
    sleeper.turns.soon()
    sleeper.run(2 * MILLISECOND)
    assert sleeper.times[:TURNS_PER_INSTANT] == [0] * TURNS_PER_INSTANT
    assert sleeper.times[TURNS_PER_INSTANT] == MILLISECOND


def test_the_clock_goes_on_however_often_a_node_sleeps_until_now(sleeper):
    sleeper.goes_on = lambda: sleeper.turns.sleep(sleeper.executor.now_ns, 0, NEVER)
    sleeper.turns.soon()
    sleeper.run(2 * MILLISECOND)
    assert sleeper.times[TURNS_PER_INSTANT] == MILLISECOND


@pytest.mark.parametrize(
    ("wakes_ns", "turn_ns"), [(PATIENCE_NS, PATIENCE_NS), (PATIENCE_NS + 1, 0)]
)
def test_what_is_only_stored_waits_for_a_turn_that_is_near(sleeper, wakes_ns, turn_ns):
    sleeper.turns.sleep(wakes_ns, 0, NEVER)
    sleeper.turns.before_long()
    sleeper.run(2 * PATIENCE_NS)
    assert sleeper.times == [turn_ns]


looks = st.integers(0, 50).map(lambda half: 2 * half)
"""Even times; news comes at odd ones, so that no two events fall on one instant."""


@given(
    first_ns=looks,
    period_ns=looks.filter(bool),
    end_ns=looks,
    news_ns=looks.map(lambda even: even + 1),
)
def test_one_that_looks_for_news_wakes_when_it_would_have_found_some(
    first_ns, period_ns, end_ns, news_ns
):
    sleeper = Sleeper()
    sleeper.turns.sleep(first_ns, period_ns, end_ns)
    sleeper.executor.call_at(news_ns, lambda: setattr(sleeper, "has_input", True))
    sleeper.run(1000)
    plain = range(first_ns, 1000, period_ns)
    assert sleeper.times == [next(t for t in plain if t >= end_ns or t > news_ns)]
