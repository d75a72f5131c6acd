"""What ROS can send to its parameter server."""

from __future__ import annotations

import datetime

import pytest

from simkit.graph.sendable import why_unsendable


@pytest.mark.parametrize(
    "value", [0, -(2**31), 2**31 - 1, 1.5, True, "a", b"a", [], {}, [1, [2.5, {"a": "b"}]]]
)
def test_what_can_be_sent(value):
    assert why_unsendable(value) is None


@pytest.mark.parametrize(
    ("value", "cause", "what"),
    [
        (None, "cannot marshal None unless allow_none is enabled", "(null)"),
        (2**31, "int exceeds XML-RPC limits", "2147483648 is too large"),
        (datetime.date(2020, 1, 2), "cannot marshal <class 'datetime.date'> objects", "a date"),
        ({1: None}, "cannot marshal None unless allow_none is enabled", "(null)"),
    ],
)
@pytest.mark.parametrize("around", [lambda one: one, lambda one: {"a": [1, {"b": one}]}])
def test_what_cannot(value, cause, what, around):
    found = why_unsendable(around(value))
    assert found.cause == cause
    assert what in found.what
