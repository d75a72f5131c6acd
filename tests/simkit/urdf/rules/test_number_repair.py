"""Numbers that are none, and what was meant."""

import pytest

from simkit.urdf.rules.wording import mended


@pytest.mark.parametrize(
    ("written", "count", "meant"),
    [
        ("0, 0, 0.05", 3, "0 0 0.05"),
        ("0,0,0.05", 3, "0 0 0.05"),
        ("(0; 0; 1)", 3, "0 0 1"),
        ("[0 0 1]", 3, "0 0 1"),
        ("0,5 0 0", 3, "0.5 0 0"),
        ("0,5", 1, "0.5"),
        ("5cm", 1, "0.05"),
        ("12 mm", 1, "0.012"),
        ("90deg", 1, "1.5708"),
        ("90°", 1, "1.5708"),
        ("10Nm", 1, "10"),
        ("0 pi/2 0", 3, "0 1.5708 0"),
        ("0 -M_PI 0", 3, "0 -3.1416 0"),
        ("2*pi", 1, "6.2832"),
        ("π/4", 1, "0.7854"),
        ("0 −0.1 0", 3, "0 -0.1 0"),
        ("O.5", 1, "0.5"),
        ("0\t0\n1", 3, "0 0 1"),
        ("1.0f", 1, "1"),
    ],
)
def test_what_was_meant(written, count, meant):
    assert mended(written, count) == meant


@pytest.mark.parametrize(
    ("written", "count"),
    [
        ("", 1),
        ("", 3),
        ("up", 1),
        ("0 1", 3),
        ("0 0 0 0", 3),
        ("inf", 1),
        ("pi/0", 1),
        ("9" * 999, 1),
    ],
)
def test_what_cannot_be_told(written, count):
    assert mended(written, count) is None
