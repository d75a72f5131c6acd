"""Finds as text and as JSON."""

from __future__ import annotations

import io
import json
import re
from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from simkit.diagnostics import (
    Diagnostic,
    Layout,
    Related,
    Severity,
    as_json,
    as_text,
    count_text,
    in_order,
)
from simkit.xml import Span

FILE = "hello_ros/urdf/arm.urdf"
LIMIT = Diagnostic(
    rule="URDF-E05",
    severity=Severity.ERROR,
    file=FILE,
    span=Span(12, 4, 5),
    source='  <joint name="hip" type="revolute">',
    path="robot/joint[hip]",
    what='joint "hip" is revolute, but has no <limit>',
    here="The file is refused, as urdfdom refuses it, and there is no robot to look at: not in the view, not in the tree.",
    gazebo="Both refuse it.",
    remedy='Add e.g. <limit lower="-1.57" upper="1.57" effort="10" velocity="1"/>.',
    related=(
        Related(
            file=FILE,
            span=Span(3, 4, 4),
            text="its parent is defined here",
            source='  <link name="base"/>',
        ),
        Related(file="arm.launch", span=Span(7, 1, 2), text="the file is loaded here"),
    ),
)
BARE = Diagnostic(
    rule="URDF-I01",
    severity=Severity.NOTE,
    file=FILE,
    span=Span(1, 1, 1),
    source="",
    what="the robot has no material",
    remedy="Nothing needs to be done.",
)
SHOWN = """\
hello_ros/urdf/arm.urdf:12:4: error [URDF-E05] joint "hip" is revolute, but has no <limit>
   12 |   <joint name="hip" type="revolute">
      |    ^~~~~
      in: robot/joint[hip]
      here: The file is refused, as urdfdom refuses it, and there is no robot to look at: not in the
        view, not in the tree.
      in ROS and Gazebo: Both refuse it.
      remedy: Add e.g. <limit lower="-1.57" upper="1.57" effort="10" velocity="1"/>.
      see: hello_ros/urdf/arm.urdf:3:4: its parent is defined here
    3 |   <link name="base"/>
      |    ^~~~
      see: arm.launch:7:1: the file is loaded here

hello_ros/urdf/arm.urdf:1:1: note [URDF-I01] the robot has no material
      remedy: Nothing needs to be done.
"""
ESCAPES = re.compile(r"\x1b\[[0-9;]*m")


def test_a_find_shows_its_line_and_what_follows():
    assert as_text([LIMIT, BARE]) == SHOWN


def test_no_finds_are_no_text():
    assert as_text([]) == ""


def test_colours_change_nothing_but_colours():
    painted = as_text([LIMIT, BARE], colour=True)
    assert ESCAPES.sub("", painted) == SHOWN
    assert ESCAPES.search(as_text([LIMIT, BARE])) is None
    assert "\x1b[1;31merror [URDF-E05]\x1b[0m" in painted
    assert all(line.count("\x1b[") % 2 == 0 for line in painted.splitlines())


def test_a_find_of_a_file_cannot_use_escapes():
    rude = replace(
        LIMIT, file="\x1b[2J.urdf", source="<a \x1b[2J/>", what="\x1b[2J", path="a\nb", related=()
    )
    assert "\x1b" not in as_text([rude])
    assert len(as_text([rude]).splitlines()) == len(as_text([LIMIT]).splitlines()) - 4


@given(st.text(), st.text())
def test_any_find_can_be_shown(text, source):
    find = replace(
        LIMIT, what=text, here=text, remedy=text, source=source, file=text, span=Span(1, 9, 3)
    )
    related = replace(LIMIT.related[0], source=source, text=text)
    find = replace(find, related=(related,))
    assert as_text([find]).endswith("\n")
    assert json.loads(as_json([find]))["diagnostics"][0]["what"] == text


def test_the_json_has_all_fields_in_order():
    shown = json.loads(as_json([LIMIT, BARE]))
    assert list(shown) == ["version", "diagnostics", "summary"]
    assert shown["version"] == 1
    assert shown["summary"] == {"errors": 1, "warnings": 0, "notes": 1}
    assert (
        list(shown["diagnostics"][0])
        == list(shown["diagnostics"][1])
        == [
            *("rule", "severity", "file", "line", "column", "length", "path", "what", "here"),
            *("gazebo", "remedy", "source", "related"),
        ]
    )
    assert shown["diagnostics"][0] == {
        "rule": "URDF-E05",
        "severity": "error",
        "file": FILE,
        "line": 12,
        "column": 4,
        "length": 5,
        "path": "robot/joint[hip]",
        "what": LIMIT.what,
        "here": LIMIT.here,
        "gazebo": LIMIT.gazebo,
        "remedy": LIMIT.remedy,
        "source": LIMIT.source,
        "related": [
            {
                "file": FILE,
                "line": 3,
                "column": 4,
                "length": 4,
                "text": "its parent is defined here",
                "source": '  <link name="base"/>',
            },
            {
                "file": "arm.launch",
                "line": 7,
                "column": 1,
                "length": 2,
                "text": "the file is loaded here",
                "source": "",
            },
        ],
    }


def test_the_json_of_a_very_long_line_is_short():
    long = replace(LIMIT, source="x" * 1_000_000, related=())
    assert len(as_json([long] * 10)) < 50_000


def test_the_summary_counts():
    warning = replace(BARE, severity=Severity.WARNING)
    assert count_text([]) == "no faults found"
    assert count_text([LIMIT]) == "1 error"
    assert count_text([BARE, LIMIT, warning, LIMIT, BARE]) == "2 errors, 1 warning, 2 notes"


def test_finds_are_in_the_order_of_the_text_each_once_the_worst_first():
    note = replace(LIMIT, severity=Severity.NOTE)
    assert in_order([note, LIMIT, BARE, LIMIT]) == (BARE, LIMIT, note)


class Stream(io.StringIO):
    """A stream that may be a terminal."""

    def __init__(self, *, is_terminal: bool) -> None:
        super().__init__()
        self.isatty = lambda: is_terminal  # type: ignore[method-assign]


LONG = replace(LIMIT, what=" ".join(["very"] * 60) + " wrong")


def test_in_a_pipe_the_first_line_of_each_find_is_one_line_however_long(monkeypatch):
    monkeypatch.delenv("COLUMNS", raising=False)
    text = as_text([LONG, BARE], layout=Layout.of(Stream(is_terminal=False)))
    heads = [line for line in text.splitlines() if re.match(r"\S+:\d+:\d+: ", line)]
    assert [head.rpartition("] ")[2] for head in heads] == [LONG.what, BARE.what]
    assert "\x1b" not in text


def test_on_a_terminal_it_is_wrapped(monkeypatch):
    monkeypatch.setenv("COLUMNS", "90")
    text = as_text([LONG], layout=Layout.of(Stream(is_terminal=True)))
    plain = re.sub(r"\x1b\[[\d;]*m", "", text)
    assert max(map(len, plain.splitlines())) <= 90
    assert len(text.splitlines()) > len(as_text([LONG]).splitlines())


def test_columns_of_the_environment_are_obeyed_in_a_pipe_too(monkeypatch):
    monkeypatch.setenv("COLUMNS", "60")
    lines = as_text([LIMIT], layout=Layout.of(Stream(is_terminal=False))).splitlines()
    assert max(map(len, lines[1:])) <= 60
    monkeypatch.setenv("COLUMNS", "nonsense")
    assert Layout.of(Stream(is_terminal=False)).width == 100
    monkeypatch.setenv("COLUMNS", "1")
    assert Layout.of(Stream(is_terminal=False)).width == 40
