import io
import re
from html.parser import HTMLParser

import pytest

from grader.report import exercise_html, exercise_text, page, print_gradebook, progress
from grader.report.style import STYLE
from grader.report.words import ICONS
from grader.results import CheckResult, ExerciseResult, Status
from grader.run.gradebook import Gradebook, StudentResult

EVIL = "<script>alert(1)</script> \"><img src=x onerror=alert(1)> & 'x'"


@pytest.fixture
def result():
    checks = [
        CheckResult(
            name=str(status),
            title=f"It is {status}.",
            status=status,
            points=1.5 if status is Status.PASSED else 0,
            max_points=1.5,
            message="" if status is Status.PASSED else "No.\nexpected: 1 m\ngot: 2 m",
            hint="" if status is Status.PASSED else "Look again.",
        )
        for status in Status
    ]
    return ExerciseResult.from_checks("3.1", checks, notes=["Cell 2 was odd."])


class Reader(HTMLParser):
    """Checks that tags are closed in order, and keeps tags and text."""

    VOID = ("meta", "img", "br")

    def __init__(self, text):
        super().__init__()
        self.open, self.tags, self.text = [], [], ""
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text += data


def test_a_card_has_icon_word_title_points_reason_and_hint(result):
    reader = Reader(exercise_html(result, title="Broadcast"))
    for status in Status:
        assert ICONS[status] in reader.text
        assert f"It is {status}." in reader.text
    assert "1.5 / 1.5" in reader.text
    assert "Cell 2 was odd." in reader.text
    assert sum(tag == "li" and "class" in attributes for tag, attributes in reader.tags) == 7
    assert reader.tags.count(("details", {"open": None})) == 6
    assert [tag for tag, _ in reader.tags].count("dd") == 12


def test_it_says_that_hidden_checks_are_to_come(result):
    text = exercise_text(result, title="Broadcast", hidden_to_come=True)
    assert text.splitlines()[0] == (
        "Exercise 3.1 (Broadcast): public checks: 1 of 7 passed, 1.5 of 10.5 points;"
        " hidden checks run when it is graded"
    )
    assert "hidden checks run when it is graded" in exercise_html(result, hidden_to_come=True)
    assert "hidden checks" not in exercise_text(result)


def test_nothing_of_a_student_becomes_html():
    check = CheckResult(
        name=EVIL,
        title=EVIL,
        status=Status.FAILED,
        max_points=1,
        message=f"{EVIL}\nexpected: {EVIL}\ngot: {EVIL}",
        hint=EVIL,
    )
    evil = ExerciseResult.from_checks(EVIL, [check], notes=[EVIL])
    reader = Reader(page(EVIL, [exercise_html(evil, title=EVIL)]))
    tags = {tag for tag, _ in reader.tags}
    assert not tags & {"script", "img"}
    assert not [name for _, attributes in reader.tags for name in attributes if name[:2] == "on"]
    assert reader.text.count("<script>alert(1)</script>") >= 6


def test_a_page_loads_nothing_from_anywhere(result):
    text = page("Results", [exercise_html(result)])
    assert "http" not in text
    assert not re.search(r"url\(|@import|\bsrc=|\bhref=", text)


def test_the_chips_can_be_read():
    # White on the colour of a status: the contrast that WCAG AA asks of small text.
    for colour in set(re.findall(r"--hue: #([0-9a-f]{6})", STYLE)):
        parts = [int(colour[at : at + 2], 16) / 255 for at in (0, 2, 4)]
        linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
        luminance = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
        assert 1.05 / (luminance + 0.05) >= 4.5, colour


def test_checks_that_were_skipped_lie_folded_in_one_line():
    status = [Status.FAILED, Status.SKIPPED, Status.SKIPPED, Status.PASSED, Status.SKIPPED]
    checks = [
        CheckResult(name=f"c{i}", title=f"Check {i}.", status=s) for i, s in enumerate(status)
    ]
    reader = Reader(exercise_html(ExerciseResult.from_checks("3.1", checks)))
    assert "2 checks skipped" in reader.text
    assert all(check.title in reader.text for check in checks)
    assert [tag for tag, _ in reader.tags].count("details") == 1


def gradebook_of(result, student="Ada"):
    return Gradebook(
        sandbox="none", submissions=(StudentResult(student=student, exercises=(result,)),)
    )


def test_the_table_is_plain_where_there_is_no_terminal(result):
    stream = io.StringIO()
    print_gradebook(gradebook_of(result), stream)
    lines = stream.getvalue().splitlines()
    assert lines[0].split() == ["student", "exercise", "status", "points"]
    assert lines[2].split() == ["Ada", "3.1", "infrastructure", "1.5", "/", "10.5"]
    assert "\x1b" not in stream.getvalue()
    assert "sandbox: none" in lines
    assert any("It is failed." in line for line in lines)
    assert not any("It is passed." in line for line in lines)


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_a_name_is_no_markup_on_a_terminal(result):
    stream = Terminal()
    print_gradebook(gradebook_of(result, student="[red]\x1b[2JAda[/red]\n=1+1"), stream)
    assert "[red] [2JAda[/red] =1+1" in re.sub(r"\x1b\[[0-9;]*m", "", stream.getvalue())
    assert "\x1b[2J" not in stream.getvalue()


def test_progress_is_shown_on_a_terminal_only():
    for stream in (Terminal(), io.StringIO()):
        with progress(2, stream) as advance:
            advance()
            advance()
        assert bool(stream.getvalue()) == stream.isatty()
