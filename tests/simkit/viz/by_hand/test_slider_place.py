from __future__ import annotations

import pytest

from simkit.viz.by_hand.slider_place import is_drawn_there


@pytest.mark.parametrize(
    ("value", "is_there"),
    [
        (0.5, True),  # what was shown
        (0.6, True),  # the nearest place of the slider
        (0.4, True),  # is as near
        (0.8, False),  # the next place
        (0.2, False),
        (0.55, False),  # typed
    ],
)
def test_only_the_nearest_place_of_a_slider_may_be_the_browsers(value, is_there):
    assert is_drawn_there(value, 0.5, low=-1.0, step=0.2) is is_there
