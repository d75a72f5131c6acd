from __future__ import annotations

import time
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.submission.answers import CollectedAnswers, collect_answers

NAMES = ("fixed_frame", "distance")


@pytest.fixture
def answers(make: Any) -> Any:
    def collect(*sources: str) -> CollectedAnswers:
        cells = [make.answer(source) for source in sources]
        return collect_answers(make.notebook(*cells), NAMES)

    return collect


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ('"world"', "world"),
        ("-2.5", -2.5),
        ("True", True),
        ("[1, (2, 3)]", [1, [2, 3]]),
        ('{"b", "a"}', ["a", "b"]),
        ('{"a": [1]}', {"a": [1]}),
        ('"wor" "ld"', "world"),
        (r'"\d"', "\\d"),
    ],
)
def test_literals_are_read_in_the_types_of_json(answers: Any, text: str, value: object) -> None:
    assert answers(f"# the frame\nfixed_frame = {text}  # why").answers == {"fixed_frame": value}


@pytest.mark.parametrize("text", ["...", "None"])
def test_a_placeholder_is_no_answer(answers: Any, text: str) -> None:
    found = answers(f"fixed_frame = {text}")
    assert (found.answers, found.notes) == ({}, [])


def test_later_answers_win_but_a_later_placeholder_does_not(answers: Any) -> None:
    found = answers('fixed_frame = "a"', 'fixed_frame = "b"', "fixed_frame = ...")
    assert found.answers == {"fixed_frame": "b"}
    assert found.notes == ["fixed_frame is answered twice; the later answer was taken."]


@pytest.mark.parametrize(
    "source",
    [
        'fixed_frame: str = "world"',
        'fixed_frame = x = "world"',
        '%matplotlib inline\nfixed_frame = "world"',
    ],
)
def test_other_spellings_of_an_assignment(answers: Any, source: str) -> None:
    assert answers(source).answers == {"fixed_frame": "world"}


def test_one_bad_line_does_not_lose_the_others(answers: Any) -> None:
    found = answers('fixed_frame = "world\ndistance = 2.0')
    assert found.answers == {"distance": 2.0}
    assert "'fixed_frame = \"world' is not Python" in found.notes[0]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("world", 'in quotes: "world"'),
        ("2 * 1.0", "not something to compute"),
        ("open('x').read()", "not something to compute"),
        ("__import__('os')", "not something to compute"),
        ("f'{1}'", "not something to compute"),
        ("b'x'", "is meant"),
        ("1j", "is meant"),
        ("1e999", "is meant"),
        ("10 ** 5", "not something to compute"),
        ("9" * 100, "is meant"),
        ("{1: 2}", "is meant"),
        ("[" * 50 + "]" * 50, "is meant"),
        ("{[]: 1}", "not something to compute"),
    ],
)
def test_anything_else_is_refused_with_advice(answers: Any, text: str, says: str) -> None:
    found = answers(f"fixed_frame = {text}")
    assert found.answers == {}
    assert found.notes[0].startswith("The answer fixed_frame was not read: ")
    assert says in found.notes[0]


def test_a_misspelt_name_is_named(answers: Any) -> None:
    found = answers('fixed_fram = "world"')
    assert found.notes == ["No answer is called fixed_fram; did you mean fixed_frame?"]


@pytest.mark.parametrize(
    "text",
    [
        "[" * 15_000,
        "-" * 15_000 + "1",
        "(" * 9_000 + ")" * 9_000,
        "1+" * 9_000 + "1",
        "x." * 9_000 + "y",
        "\x00",
        "9" * 15_000,
    ],
)
def test_hostile_text_costs_little(answers: Any, text: str) -> None:
    start = time.perf_counter()
    found = answers(f"fixed_frame = {text}\ndistance = 1")
    assert "fixed_frame" not in found.answers
    assert time.perf_counter() - start < 10


def test_too_long_a_cell_is_not_read(answers: Any) -> None:
    found = answers("distance = 1\n" + "#" * 30_000)
    assert found.answers == {}
    assert "too long" in found.notes[0]


def test_a_notebook_of_answers_is_searched_for_a_while_only(answers: Any) -> None:
    start = time.perf_counter()
    found = answers(*["distance = 1\n" * 1_000] * 200, "distance = 2")
    assert found.answers == {"distance": 1}
    assert "only its beginning was searched" in found.notes[-1]
    assert time.perf_counter() - start < 10


def test_untagged_cells_count_if_they_only_answer(make: Any) -> None:
    notebook = make.notebook(
        make.cell('fixed_frame = "world"'),
        make.cell("distance = 3.0\nprint(distance)"),
        make.cell("distance = 4.0", "markdown"),
        make.writes('fixed_frame = "file"'),
    )
    found = collect_answers(notebook, NAMES)
    assert found.answers == {"fixed_frame": "world"}
    assert found.notes == ["Cell 1 is not the answer cell, but its answers were read."]


@given(st.text())
@settings(deadline=None)
def test_any_text_gives_answers_or_notes(source: str) -> None:
    from grader.submission.notebook import Cell, Notebook

    cell = Cell(number=1, kind="code", source=source, tags=("answer",), id=None)
    collect_answers(Notebook(cells=(cell,), metadata={}, notes=()), NAMES)
