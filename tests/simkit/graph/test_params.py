"""The parameter server, and what ROS can send to it."""

import datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.errors import UnknownNameError
from simkit.graph import ParameterServer
from simkit.graph.params import why_unsendable


@pytest.fixture
def params():
    return ParameterServer()


def test_a_dict_is_a_namespace(params):
    params.set("/arm", {"hip": {"p": 1.0}, "rate": 50})
    assert params.get("/arm/hip/p") == 1.0
    params.set("/arm/hip/p", 2.0)
    assert params.get("/arm") == {"hip": {"p": 2.0}, "rate": 50}
    assert params.names() == ["/arm/hip/p", "/arm/rate"]


def test_a_missing_parameter_names_near_ones(params):
    params.set("/turtlesim/background_r", 69)
    with pytest.raises(UnknownNameError, match="did you mean '/turtlesim/background_r'"):
        params.get("/turtlesim/backgroud_r")
    assert params.get("/turtlesim/backgroud_r", 3) == 3


def test_values_are_copied_in_and_out(params):
    value = [1, 2]
    params.set("/list", value)
    value.append(3)
    params.get("/list").append(4)
    assert params.get("/list") == [1, 2]


def test_false_and_zero_are_set(params):
    params.set("/off", False)
    params.set("/zero", 0)
    assert params.has("/off")
    assert params.has("/zero")
    assert not params.has("/nothing")


def test_delete_removes_a_namespace(params):
    params.set("/a/b/c", 1)
    params.delete("/a/b")
    assert params.names() == ["/a"]
    with pytest.raises(UnknownNameError):
        params.delete("/a/b")


def test_search_goes_outwards(params):
    params.set("/left/arm/speed", 1)
    params.set("/speed", 2)
    assert params.search("/left/arm", "speed") == "/left/arm/speed"
    assert params.search("/right/arm", "speed") == "/speed"
    assert params.search("/left", "nothing") is None


keys = st.sampled_from(["a", "b", "c"])
names = st.lists(keys, min_size=1, max_size=3).map(lambda parts: "/" + "/".join(parts))


@given(st.lists(st.tuples(names, st.integers()), max_size=12))
def test_the_last_value_set_is_the_value(pairs):
    params = ParameterServer()
    for name, value in pairs:
        params.set(name, value)
        assert params.get(name) == value
    for name in params.names():
        assert params.has(name)


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
