from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.submission.writefile import written_file


@pytest.mark.parametrize(
    ("line", "path", "append"),
    [
        ("%%writefile a/b.py", "a/b.py", False),
        ("%%file a/b.py", "a/b.py", False),
        ("%%writefile  -a a/b.py  ", "a/b.py", True),
        ("%%writefile --append a/b.py", "a/b.py", True),
        ("%%writefile a/b.py -a", "a/b.py", True),
        ("%%writefile 'a/b.py'", "a/b.py", False),
        ('%%writefile "a/b c.py"', "a/b c.py", False),
        ("%%writefile a\\b.py", "a\\b.py", False),
        ("%%writefile", "", False),
    ],
)
def test_the_magic_is_read_as_jupyter_reads_it(line: str, path: str, append: bool) -> None:
    found = written_file(f"{line}\nbody")
    assert found is not None
    assert (found.path, found.append, found.text, found.notes) == (path, append, "body\n", ())


@pytest.mark.parametrize(
    ("source", "says"),
    [
        ("# my listener\n%%writefile a.py\nx", "first line"),
        ("\n\n# one\n\n# two\n  %%writefile a.py\nx", "first line"),
        ("%writefile a.py\nx", "two percent signs"),
        ("%% writefile a.py\nx", "two percent signs"),
        ("%%writefile a.py b.py\nx", "more than one name"),
        ("%%writefile a.py 'open\nx", "more than one name"),
    ],
)
def test_what_jupyter_would_not_accept_is_read_with_a_note(source: str, says: str) -> None:
    found = written_file(source)
    assert found is not None
    assert found.path == "a.py"
    assert found.text == "x\n"
    assert says in found.notes[0]


def test_blank_lines_above_are_no_slip() -> None:
    found = written_file("\n\n%%writefile a.py\nx\n\n")
    assert found is not None
    assert (found.text, found.notes) == ("x\n\n", ())


@pytest.mark.parametrize(
    "source",
    [
        "",
        "x = 1",
        "import os\n%%writefile a.py",
        "%%writefiles a.py",
        "%%bash\ncat",
        "'%%writefile a'",
    ],
)
def test_any_other_cell_writes_nothing(source: str) -> None:
    assert written_file(source) is None


def test_an_empty_file_is_empty() -> None:
    found = written_file("%%writefile a.py")
    assert found is not None
    assert found.text == ""


@given(st.text())
@settings(deadline=None)
def test_no_text_is_too_odd(rest: str) -> None:
    assert written_file(f"%%writefile {rest}") is not None
