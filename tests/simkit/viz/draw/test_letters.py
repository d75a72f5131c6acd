from __future__ import annotations

import string
from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib import get_data_path
from matplotlib.ft2font import FT2Font

from simkit.viz.draw.letters import abbreviated, label_places, printable, text_width, wrapped


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
    short = abbreviated(text, limit)
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


SIZE = (700.0, 400.0)
HEIGHT = 17.0


@given(
    st.lists(
        st.tuples(st.floats(0, 700), st.floats(0, 400), st.floats(10, 150)), min_size=1, max_size=12
    )
)
def test_names_do_not_cover_each_other(items):
    anchors, widths = [(x, y) for x, y, _ in items], [width for _, _, width in items]
    places = label_places(anchors, widths=widths, height=HEIGHT, size=SIZE)
    written = [(place, width) for place, width in zip(places, widths, strict=True) if place]
    assert written
    assert all(HEIGHT / 2 <= y <= SIZE[1] - HEIGHT / 2 for (_, y), _ in written)
    for (a, wa), (b, wb) in combinations(written, 2):
        assert a[0] + wa <= b[0] or b[0] + wb <= a[0] or abs(a[1] - b[1]) >= HEIGHT


def test_frames_in_one_place_are_listed_below_each_other():
    places = label_places([(100, 100)] * 3, widths=[60, 60, 60], height=HEIGHT, size=SIZE)
    assert places[0] == (109, 110)
    assert len(set(places)) == 3


def test_at_the_right_edge_a_name_goes_to_the_left():
    ((left, _),) = label_places([(690, 100)], widths=[60], height=HEIGHT, size=SIZE)
    assert left + 60 < 690


def test_a_name_that_has_no_room_is_left_out():
    places = label_places([(100, 100)] * 60, widths=[60] * 60, height=HEIGHT, size=SIZE)
    assert None not in places[:20]
    assert None in places
