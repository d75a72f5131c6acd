"""Whether a slider was moved by a person, or put on the nearest of its places by the browser that draws it."""

from __future__ import annotations

from typing import Final

_ROUNDING: Final = 1e-6
"So far from a place of a slider its number may be [share of a step]."


def is_drawn_there(value: float, shown: float, *, low: float, step: float) -> bool:
    """Whether a value is the one that was shown, or the place of the slider nearest to that.

    A browser that draws a slider puts it on a place of its own and reports that as a move: to look
    at a robot would move it.

    Args:
        value: What the browser reports.
        shown: What the slider was told to show.
        low: Lower end of the slider.
        step: Way from a place of the slider to the next.
    """
    if value == shown:
        return True
    places = (value - low) / step
    is_a_place = abs(places - round(places)) < _ROUNDING
    return is_a_place and abs(value - shown) <= (0.5 + _ROUNDING) * step
