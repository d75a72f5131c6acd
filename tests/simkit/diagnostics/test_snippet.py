"""A line with a piece of it underlined, whatever letters it has and however long it is."""

from __future__ import annotations

import unicodedata

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simkit.diagnostics.snippet import snippet, visible, width
from simkit.xml import Span


def marked(line: str, span: Span, room: int = 90) -> str:
    """What stands above the underline."""
    shown, underline = snippet(line, span, room)
    begin, end = underline.index("^"), len(underline)
    columns = [letter for letter in shown for _ in range(width(letter))]
    return "".join(dict.fromkeys(enumerate(columns[begin:end])) and columns[begin:end])


@pytest.mark.parametrize("before", ["", "  ", "\t", "\t \t", "æøå ", "x" * 300])
def test_the_piece_is_underlined(before):
    line = f'{before}<joint name="hip"/>'
    assert marked(line, Span(1, len(before) + 2, 5)) == "joint"


def test_a_tab_does_not_shift_the_underline():
    assert snippet("\t<box/>", Span(1, 3, 3), 90) == ("    <box/>", "     ^~~")


def test_a_wide_letter_takes_two_columns():
    assert snippet("<日本 名='x'/>", Span(1, 5, 1), 90) == ("<日本 名='x'/>", "      ^~")


def test_a_letter_over_another_takes_none():
    assert snippet("e\u0301<a/>", Span(1, 4, 1), 90) == ("e\u0301<a/>", "  ^")


def test_control_characters_can_be_seen_and_do_nothing():
    shown, underline = snippet("<a\x1b[31m\x00\u202e\u00a0b\x7f/>", Span(1, 3, 1), 90)
    assert shown == "<a␛[31m␀\ufffd␣b␡/>"
    assert underline == "  ^"


def test_a_long_line_is_cut_around_the_piece():
    line = "a" * 5000 + "<mesh/>" + "b" * 5000
    shown, underline = snippet(line, Span(1, 5002, 4), 60)
    assert shown.startswith("...aaa")
    assert shown.endswith("bbb...")
    assert len(shown) <= 60
    assert marked(line, Span(1, 5002, 4), 60) == "mesh"
    assert underline.count("~") == 3


def test_a_piece_longer_than_the_room_is_underlined_as_far_as_it_goes():
    shown, underline = snippet("<" + "a" * 500 + ">", Span(1, 2, 500), 60)
    assert len(shown) == len(underline) + len("...") == 60


def test_an_empty_line_has_a_mark():
    assert snippet("", Span(1, 1, 1), 60) == ("", "^")


@settings(deadline=None)  # the first odd letter loads tables
@given(st.text(st.characters(exclude_characters="\n"), max_size=200), st.data())
def test_any_line_keeps_to_its_room_and_has_one_mark(line, data):
    column = data.draw(st.integers(1, max(1, len(line))))
    span = Span(1, column, data.draw(st.integers(1, max(1, len(line) - column + 1))))
    shown, underline = snippet(line, span, 60)
    assert width(shown) <= 60
    assert len(underline) <= 61
    assert underline.lstrip(" ").startswith("^")
    assert shown.isprintable()
    assert set(underline) <= {" ", "^", "~"}


@given(st.text())
def test_what_is_visible_moves_nothing(text):
    assert all(
        unicodedata.category(letter) not in ("Cc", "Cf", "Zl", "Zp") for letter in visible(text)
    )
