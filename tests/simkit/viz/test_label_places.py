from __future__ import annotations

from itertools import combinations

from hypothesis import given
from hypothesis import strategies as st

from simkit.viz.label_places import label_places

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
