"""What a name that does not exist is told with."""

from __future__ import annotations

import pytest

from simkit.errors import UnknownNameError


@pytest.mark.parametrize(
    ("name", "known", "text"),
    [
        ("robt", ["robot", "arm"], "no package 'robt'; did you mean 'robot'? Known: arm, robot"),
        ("xyz", ["robot", "arm"], "no package 'xyz'; Known: arm, robot"),
        ("xyz", [], "no package 'xyz'"),
        ("x", [f"{n:02}" for n in range(20)], "00, 01, 02, 03, 04, 05, 06, 07, 08, 09, 10, 11 and 8 more"),
    ],
)  # fmt: skip
def test_the_error_names_what_there_is(name, known, text):
    assert text in str(UnknownNameError("package", name, known))
