"""Numbers as a C++ stream reads them."""

from __future__ import annotations

import pytest

from simkit.urdf.urdfdom.numbers import (
    MalformedError,
    check_version,
    to_colour,
    to_double,
    to_vector,
)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        *(("1", 1.0), ("-1.5", -1.5), ("+.5", 0.5), ("2.", 2.0), ("1e3", 1000.0)),
        *(("1E-3", 0.001), (" \t\n1", 1.0), ("007", 7.0), ("1e-400", 0.0), ("0.1", 0.1)),
    ],
)
def test_numbers(text, value):
    assert to_double(text) == value


NO_NUMBERS = (
    *(
        "",
        " ",
        "1 ",
        "1\n",
        "x",
        "1x",
        "0x10",
        "1,5",
        "inf",
        "nan",
        "1e",
        "1e+",
        "e5",
        ".",
        "-",
        "--1",
    ),
    *("1e400", "-1e400", "1.2.3", "1_000", "\u0661", "1d3", "½", "- 1"),
)


@pytest.mark.parametrize("text", NO_NUMBERS)
def test_no_numbers(text):
    assert to_double(text) is None


def test_vectors():
    assert to_vector(" 1  2 3e0 ") == (1.0, 2.0, 3.0)
    for text in ("", "1 2", "1 2 3 4", "1\t2\t3", "1, 2, 3", "1 2 x"):
        with pytest.raises(MalformedError):
            to_vector(text)


def test_colours():
    assert to_colour("0 0.5 1 1") == (0.0, 0.5, 1.0, 1.0)
    assert to_colour("1 0 0") == to_colour("") == (0.0, 0.0, 0.0, 1.0)
    for text in ("2 0 0 1", "-1 0 0 1", "red"):
        with pytest.raises(MalformedError):
            to_colour(text)


def test_versions():
    for text in (None, "1.0", " 1.+0", "1.0.", "01.00"):
        check_version(text)
    for text in ("", "1", "1.", "1.1", "2.0", "a.b", "1.0.0", "1.0 ", "9" * 9999 + ".0"):
        with pytest.raises(MalformedError):
            check_version(text)
