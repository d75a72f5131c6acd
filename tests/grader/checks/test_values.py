from hypothesis import given
from hypothesis import strategies as st

from grader.checks.values import TEXT_LENGTH, VALUE_LENGTH, bounded, clean, shown


def test_numbers_are_short():
    assert shown(1 / 3) == "0.333333"
    assert shown(-0.0) == "0"
    assert shown((1.0, 2, 0.5), unit="m", frame="world") == "(1, 2, 0.5) m in frame world"


def test_long_values_are_cut():
    assert len(shown("x" * 10_000)) <= VALUE_LENGTH
    assert "1000 in all" in shown([0] * 1000)
    assert len(bounded("x" * 10_000)) <= TEXT_LENGTH


def test_nothing_steers_a_terminal():
    assert "\x1b" not in shown("\x1b[2Jgone")
    assert clean("a\x1b[31mb\r\u202ec\nd") == "a\ufffd[31mb\ufffd\ufffdc\nd"


@given(st.recursive(st.none() | st.text() | st.floats() | st.integers(), st.lists))
def test_every_value_can_be_shown_in_one_line(value):
    text = shown(value)
    assert len(text) <= VALUE_LENGTH
    assert "\n" not in text
