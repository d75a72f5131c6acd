from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.authoring.regions import (
    RegionError,
    find_regions,
    is_notebook_python,
    is_python,
    solution_text,
    student_text,
)

FUNCTION = """\
def f(x):
    # solution: double it
    y = 2 * x
    return y
    # end solution
"""


def student(text: str) -> str:
    return student_text(text, is_valid=is_python)


def test_the_solution_loses_the_marks_only() -> None:
    assert solution_text(FUNCTION) == "def f(x):\n    y = 2 * x\n    return y\n"


def test_an_empty_block_gets_a_pass() -> None:
    assert student(FUNCTION) == "def f(x):\n    # TODO: double it\n    pass\n"


def test_a_block_with_something_left_gets_none() -> None:
    text = "def f(x):\n    # solution: a\n    y = 2\n    # end solution\n    return x\n"
    assert student(text) == "def f(x):\n    # TODO: a\n    return x\n"


def test_only_the_regions_that_need_it_get_a_pass() -> None:
    text = "# solution: a\nx = 1\n# end solution\nif True:\n  # solution: b\n  y = 1\n  # end solution\n"
    assert student(text) == "# TODO: a\nif True:\n  # TODO: b\n  pass\n"


def test_two_regions_in_one_block_share_one_pass() -> None:
    text = "if x:\n    # solution: a\n    a()\n    # end solution\n    # solution: b\n    b()\n    # end solution\n"
    assert student(text) == "if x:\n    # TODO: a\n    # TODO: b\n    pass\n"


def test_yaml_and_xml_keep_their_comments() -> None:
    yaml = "a:\n  # solution: gains\n  p: 1\n  # end solution\nb: 2"
    assert student_text(yaml) == "a:\n  # TODO: gains\nb: 2"
    xml = '<a>\n  <!-- solution: a link -->\n  <link name="x"/>\n  <!-- end solution -->\n</a>'
    assert student_text(xml) == "<a>\n  <!-- TODO: a link -->\n</a>"
    assert solution_text(xml) == '<a>\n  <link name="x"/>\n</a>'


@pytest.mark.parametrize(
    ("text", "line", "says"),
    [
        ("# solution: a\nx", 1, "not closed"),
        ("x\n# end solution", 2, "without a"),
        ("# solution: a\nx\n# solution: b\ny\n# end solution\n# end solution", 3, "line 1"),
        ("x\n# solution:\nx\n# end solution", 2, "must say what"),
        ("# solution: a\n\n# end solution", 1, "empty"),
        ("<!-- solution: a\nx\n<!-- end solution -->", 1, "not one whole comment"),
        ("# solution a\nx\n# end solution", 1, "nearly a mark"),
        ("#solution: a", 1, "nearly a mark"),
        ("# Solution: a", 1, "nearly a mark"),
        ("# solution: a\nx\n# end of solution", 3, "nearly a mark"),
        ("# solution: a\nx\n# endsolution", 3, "nearly a mark"),
    ],
)
def test_a_wrong_mark_is_refused_with_its_line(text: str, line: int, says: str) -> None:
    with pytest.raises(RegionError, match=says) as caught:
        find_regions(text)
    assert caught.value.line == line


def test_half_a_block_cannot_be_a_region() -> None:
    text = "x = (1,\n# solution: a\n  2)\n# end solution\n"
    with pytest.raises(RegionError, match="not valid Python") as caught:
        student(text)
    assert caught.value.line == 2


def test_magics_do_not_make_a_cell_invalid() -> None:
    assert is_notebook_python("%matplotlib inline\nif x:\n    !ls\n")
    assert is_notebook_python("%%bash\nif then")
    assert not is_notebook_python("if x:\n")


def test_a_text_without_regions_stays_as_it_is() -> None:
    assert student_text("a\nb") == solution_text("a\nb") == "a\nb"


_LINES = st.sampled_from(
    [
        "x = 1",
        "if x:",
        "    y = 2",
        "# solution: a",
        "# instead",
        "    # solution: b",
        "# end solution",
        "    # end solution",
        "",
    ]
)


@given(st.lists(_LINES, max_size=12).map("\n".join))
@settings(deadline=None)
def test_any_text_gives_valid_python_without_marks_or_a_region_error(text: str) -> None:
    try:
        made = student(text)
    except RegionError:
        return
    assert is_python(made) or not find_regions(text)
    assert "solution" not in made
    assert "solution" not in solution_text(text)


FAULTY = """\
<joint name="fixed" type="fixed">
  <!-- solution: mend the parent -->
  <parent link="world"/>
  <!-- instead -->
  <parent link="wrold"/>
  <!-- end solution -->
</joint>"""


def test_students_get_the_faulty_text_and_no_note_that_points_at_it() -> None:
    assert student_text(FAULTY) == (
        '<joint name="fixed" type="fixed">\n  <parent link="wrold"/>\n</joint>'
    )


def test_the_solution_keeps_nothing_of_the_faulty_text() -> None:
    assert solution_text(FAULTY) == (
        '<joint name="fixed" type="fixed">\n  <parent link="world"/>\n</joint>'
    )


def test_the_body_of_a_region_is_what_only_the_solution_has() -> None:
    (region,) = find_regions(FAULTY)
    assert region.body == ('  <parent link="world"/>',)
    assert region.instead == ('  <parent link="wrold"/>',)


def test_the_faulty_text_may_be_empty() -> None:
    text = "# solution: add the line\nx = 1\n# instead\n# end solution"
    assert student_text(text) == ""
    assert solution_text(text) == "x = 1"


def test_a_region_has_one_faulty_text() -> None:
    with pytest.raises(RegionError, match="second `instead`") as caught:
        find_regions("# solution: a\nx\n# instead\ny\n# instead\nz\n# end solution")
    assert caught.value.line == 5
