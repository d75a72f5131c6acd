"""What a check file says about a check: its points, and the checks it builds on."""

from __future__ import annotations

import pytest

DEFAULT_POINTS = 1.0


def points(number: float) -> pytest.MarkDecorator:
    """Decorator: what a check is worth.

    Args:
        number: Points for passing; 0 for a check that only informs.
    """
    return pytest.mark.points(float(number))


def after(*names: str) -> pytest.MarkDecorator:
    """Decorator: skip the check if one of these did not pass.

    Args:
        names: Names of checks of the same exercise that come before this one.
    """
    return pytest.mark.after(*names)


def points_of(item: pytest.Item) -> float:
    """What a collected check is worth."""
    mark = item.get_closest_marker("points")
    return float(mark.args[0]) if mark is not None else DEFAULT_POINTS


def needed_by(item: pytest.Item) -> list[str]:
    """Names of the checks that a collected check builds on."""
    return [str(name) for mark in item.iter_markers("after") for name in mark.args]
