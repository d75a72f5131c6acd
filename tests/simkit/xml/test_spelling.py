"""Which names are taken for slips of each other."""

import pytest

from simkit.xml.spelling import is_near


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("visul", "visual"),
        ("visaul", "visual"),
        ("Visual", "visual"),
        ("inertail", "inertial"),
        ("lnk", "link"),
        ("links", "link"),
        ("geometri", "geometry"),
    ],
)
def test_slips(name, other):
    assert is_near(name, other)
    assert is_near(other, name)


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("link", "joint"),
        ("visual", "collision"),
        ("mass", "mesh"),
        ("a", "b"),
        ("", "a"),
        ("parent", "child"),
        ("x" * 1_000_000, "x" * 999_999),
    ],
)
def test_other_names(name, other):
    assert not is_near(name, other)
    assert not is_near(other, name)
