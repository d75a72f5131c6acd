"""A broken law is told with all its places and the remedy."""

from __future__ import annotations

import pytest

from tests.laws import broken_laws


def test_every_violation_is_listed_and_the_remedy_is_last() -> None:
    with pytest.raises(pytest.fail.Exception) as caught:
        broken_laws(["a:1 imports b", "a:2 imports c"], "see MAY_IMPORT")
    assert str(caught.value) == (
        "2 broken:\n  a:1 imports b\n  a:2 imports c\nWhat to do: see MAY_IMPORT"
    )


def test_a_mapping_is_listed_line_by_line() -> None:
    with pytest.raises(pytest.fail.Exception, match="  a: 1\n  b: 2\n"):
        broken_laws({"a": 1, "b": 2}, "mend them")


def test_a_law_that_holds_says_nothing() -> None:
    broken_laws([], "nothing")
    broken_laws({}, "nothing")
