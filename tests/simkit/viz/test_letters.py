from __future__ import annotations

import string

import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib import get_data_path
from matplotlib.ft2font import FT2Font

from simkit.viz.letters import printable, shortened, text_width, wrapped


@pytest.fixture(scope="module")
def font():
    font = FT2Font(f"{get_data_path()}/fonts/ttf/DejaVuSans.ttf")
    font.set_size(100, 72)
    return font


@pytest.mark.parametrize("letter", [*string.printable.strip(), " ", "ä", "Ж", "→", "…"])
def test_room_is_enough_for_the_widest_common_font(font, letter):
    advance = font.load_char(ord(letter)).linearHoriAdvance / 65536
    assert advance - 0.2 <= text_width(letter, 100)


def test_widths_add_up_and_grow_with_the_size():
    assert text_width("ab", 10) == pytest.approx(text_width("a", 10) + text_width("b", 10))
    assert text_width("ab", 20) == pytest.approx(2 * text_width("ab", 10))
    assert text_width("世", 10) > text_width("m", 10)


def test_control_characters_are_replaced():
    assert printable("a\x00b\n\ud800c") == "a\ufffdb\ufffd\ufffdc"


@given(st.text(), st.integers(3, 50))
def test_shortened_keeps_both_ends(text, limit):
    short = shortened(text, limit)
    assert len(short) == min(len(text), limit)
    if len(text) > limit:
        head, tail = short.split("…", 1) if short.count("…") == 1 else (short[:1], short[-1:])
        assert printable(text).startswith(head)
        assert printable(text).endswith(tail)


@given(st.lists(st.text("abc", min_size=1, max_size=9)), st.floats(20, 200))
def test_wrapped_loses_no_word_and_fits(words, width):
    lines = wrapped(" ".join(words), size=10, width=width)
    assert " ".join(lines).split() == words
    assert all(text_width(line, 10) <= width or " " not in line for line in lines)
