from __future__ import annotations

import pytest

from grader.submission.labels import label


@pytest.mark.parametrize(
    ("text", "name"),
    [
        (" Ada \n Lovelace ", "Ada Lovelace"),
        ("a\x1b[31mb", "a [31mb"),
        ("a\u202eb", "a b"),
        ("\ud800", "?"),
        ("", "unnamed"),
        ("x" * 300, "x" * 100),
        ("=HYPERLINK()", "=HYPERLINK()"),
    ],
)
def test_a_label_is_one_plain_line(text: str, name: str) -> None:
    assert label(text) == name
