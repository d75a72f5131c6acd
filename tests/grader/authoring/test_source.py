from __future__ import annotations

from typing import Any

import pytest

from grader.authoring.source import load_source, source_paths
from grader.errors import SourceError
from grader.exercises import NodesMay


def line_of(text: str, word: str) -> int:
    return next(n for n, line in enumerate(text.split("\n"), 1) if word in line)


def test_a_source_is_read_with_the_lines_of_its_cells(workbook: Any) -> None:
    source = load_source(workbook.root / workbook.source)
    assert source.slug == "3_01_say_it"
    assert source.definition.answers == ("fixed_frame", "distance")
    assert source.definition.nodes_may == NodesMay(publish=("/tf",))
    assert [(cell.kind, cell.tags) for cell in source.cells] == [
        ("markdown", ()),
        ("code", ()),
        ("code", ()),
        ("markdown", ("hint",)),
        ("markdown", ()),
        ("code", ("answer",)),
        ("code", ("solution",)),
        ("code", ()),
    ]
    text = workbook.read(workbook.source)
    for cell, word in zip(
        source.cells,
        ["# Say it", "%%writefile hello_ros/scripts", "%%writefile hello_ros/launch", "Look at",
         "More text", "# Two answers", "an explanation", 'check("3.1")'],
        strict=True,
    ):  # fmt: skip
        assert cell.line == line_of(text, word)
    assert source.cells[-1].label == "the-check"


def test_the_readme_is_no_source(workbook: Any) -> None:
    workbook.write("solutions/README.md", "")
    assert [path.name for path in source_paths(workbook.root)] == ["3_01_say_it.md"]


@pytest.mark.parametrize(
    ("old", "new", "at", "says"),
    [
        ('id: "3.1"', "id: 3.1", "id: 3.1", "quotes"),
        ('id: "3.1"', 'id: "3.2"', "id:", "3_02_<words"),
        ("  title: Say it", "  titel: Say it", "titel", "unknown key `titel`"),
        ("  title: Say it\n", "", "", "`title` is missing"),
        ("workbook:", "workbok:", "workbok", "unknown key `workbok`"),
        ("  package: hello_ros", "  package: [", "", "not MyST"),
        ("publish: [/tf]", "topics: [/tf]", "nodes_may", "nodes_may"),
        ("    # end solution\n", "", "# solution: say", "not closed"),
        ("print(word)", "# solution: b", "# solution: b", "within the one of line"),
        (":tags: [answer]", ":tags: [answers]", "", "unknown tag `answers`; did you mean `answer`?"),
        (":tags: [answer]", ":colour: red", "", "unknown option `colour`"),
        (":tags: [solution]", ":label: the-check", "check(", "occurs twice"),
        (":tags: [solution]", ":tags: [solution, hint]", "an explanation", "no regions or other tags"),
        ("scripts/talker.py\n#!", "scripts/speaker.py\n#!", "- hello_ros/scripts/talker.py", "no cell begins with"),
        ("%%writefile hello_ros/launch", "%%writefile ./hello_ros/launch", "./hello", "write the path as"),
        ("%%writefile hello_ros/launch", "%%writefile hello/launch", "%%writefile hello/", "was not taken"),
        ("%%writefile hello_ros/launch", "# x\n%%writefile hello_ros/launch", "# x", "first line"),
        ("\ntalk()\n```", "\ntalk(\n```", "# solution: say", "not valid Python"),
        ("<launch>\n", "<launch>\n<arg>\n", "%%writefile hello_ros/launch", "not well-formed XML"),
        ("Some text.", "```{note}\nSome text.\n```", "{note}", "MyST directives"),
        ("Some text.", "# solution: x\ny\n# end solution", "# Say it", "tag the cell"),
        ("# Two answers.", "import math", "import math", "regions and comments only"),
        ('fixed_frame = "world"', 'fixed_frame = name()', "name()", "name = literal"),
        ('fixed_frame = "world"', 'fixed = "world"', "answers: [", "assigns `fixed_frame`"),
        ("answers: [fixed_frame, distance]", "answers: [distance]", "answers: [", "not in `answers`"),
        (":tags: [answer]", "", "answers: [", "assigns `fixed_frame`"),
    ],
)  # fmt: skip
def test_every_fault_has_its_file_and_line(
    workbook: Any, old: str, new: str, at: str, says: str
) -> None:
    workbook.edit(workbook.source, old, new)
    with pytest.raises(SourceError) as caught:
        load_source(workbook.root / workbook.source)
    assert says in str(caught.value)
    assert caught.value.file == "3_01_say_it.md"
    if at:
        assert caught.value.line == line_of(workbook.read(workbook.source), at)


def test_a_deliverable_must_leave_something_to_do(workbook: Any) -> None:
    workbook.edit(workbook.source, "    # solution: say the word\n", "")
    workbook.edit(workbook.source, "    # end solution\n", "")
    with pytest.raises(SourceError, match=r"talker\.py has no region"):
        load_source(workbook.root / workbook.source)


def test_a_source_without_front_matter_is_refused(workbook: Any) -> None:
    path = workbook.write("solutions/3_02_x.md", "# No front matter\n")
    with pytest.raises(SourceError, match="no table `workbook:`"):
        load_source(path)


def test_a_name_in_capitals_is_refused(workbook: Any) -> None:
    path = workbook.write("solutions/3_01_Say_It.md", workbook.read(workbook.source))
    with pytest.raises(SourceError, match="3_01_<words_in_small_letters>"):
        load_source(path)
