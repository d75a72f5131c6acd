"""Requests that wait for a transform: scenario 32 of tf2's own tests, and what belongs to it."""

import pytest

from simkit.tf import BufferCore
from simkit.tf.transformable import ALREADY, NEVER

S = 10**9
IDENTITY = {"translation": (0.0, 0.0, 0.0), "rotation": (0.0, 0.0, 0.0, 1.0)}


@pytest.fixture
def core():
    return BufferCore()


@pytest.fixture
def calls():
    return []


def put(core, second, parent="a", child="b"):
    assert core.set_transform(parent, child, stamp=second * S, **IDENTITY)


def ask(core, calls, second, target="a", source="b"):
    return core.requests.add(
        lambda request, can: calls.append((request.handle, can)),
        target=target,
        source=source,
        time=second * S,
    )


def test_what_is_there_already_needs_no_waiting(core, calls):
    put(core, 1)
    assert ask(core, calls, 1) == ALREADY
    put(core, 2)
    assert calls == []
    assert len(core.requests) == 0


def test_a_request_for_the_newest_of_ten_is_answered_by_the_tenth(core, calls):
    handle = ask(core, calls, 10)
    for second in range(1, 10):
        put(core, second)
        assert calls == []
    put(core, 10)
    assert calls == [(handle, True)]


def test_a_request_for_the_oldest_is_answered_when_it_arrives_last(core, calls):
    handle = ask(core, calls, 1)
    for second in range(10, 1, -1):
        put(core, second)
        assert calls == []
    put(core, 1)
    assert calls == [(handle, True)]


def test_what_the_buffer_has_forgotten_is_never_answered(core, calls):
    put(core, 12)
    assert ask(core, calls, 1) == NEVER == 2**64 - 1


def test_a_request_that_is_overtaken_is_told_so(core, calls):
    handle = ask(core, calls, 1)
    put(core, 2)
    assert calls == []
    put(core, 12)
    assert calls == [(handle, False)]


def test_each_is_called_once_and_in_the_order_of_asking(core, calls):
    handles = [ask(core, calls, second) for second in (2, 1, 2)]
    assert handles == [1, 2, 3]
    put(core, 1)
    put(core, 2)
    put(core, 3)
    assert calls == [(2, True), (1, True), (3, True)]


def test_who_cancels_is_not_called(core, calls):
    first, second = ask(core, calls, 1), ask(core, calls, 1)
    core.requests.cancel(first)
    core.requests.cancel(first)
    put(core, 1)
    assert calls == [(second, True)]


def test_a_callback_may_cancel_the_next_one_and_ask_again(core, calls):
    def answer(request, can):
        core.requests.cancel(later)
        ask(core, calls, 2)

    core.requests.add(answer, target="a", source="b", time=S)
    later = ask(core, calls, 1)
    put(core, 1)
    assert calls == []
    put(core, 2)
    assert [can for _, can in calls] == [True]


def test_the_latest_is_answered_by_the_first_that_joins_the_frames(core, calls):
    handle = ask(core, calls, 0, source="c")
    put(core, 1)
    assert calls == []
    put(core, 1, parent="b", child="c")
    assert calls == [(handle, True)]
