"""A small workbook of one exercise, sound until a test breaks it."""

from __future__ import annotations

from pathlib import Path

import pytest

from grader.authoring.build import build
from grader.exercises import Exercise
from grader.results import CheckResult, ExerciseResult, Status
from grader.submission import Submission

SOURCE = """\
---
workbook:
  id: "3.1"
  title: Say it
  package: hello_ros
  files:
    - hello_ros/scripts/talker.py
    - hello_ros/launch/talk.launch
  answers: [fixed_frame, distance]
  nodes_may:
    publish: [/tf]
---

# Say it

Some text.

```{code-cell}
%%writefile hello_ros/scripts/talker.py
#!/usr/bin/env python
import rospy


def talk():
    # solution: say the word
    word = "the right word"
    print(word)
    # end solution


talk()
```

```{code-cell}
%%writefile hello_ros/launch/talk.launch
<launch>
  <!-- solution: start the talker -->
  <node pkg="hello_ros" type="talker.py" name="talker"/>
  <!-- end solution -->
</launch>
```

+++ {"tags": ["hint"]}

Look at `print`.

+++

More text.

```{code-cell}
:tags: [answer]

# Two answers.
# solution: the frame, and how far [m]
fixed_frame = "world"
distance = 2.0
# end solution
```

```{code-cell}
:tags: [solution]

print("an explanation for teachers")
```

```{code-cell}
:label: the-check

check("3.1")
```
"""
CHECKS = '''\
"""Checks."""

from grader.checks import points

SCRIPT = "talker.py"
LAUNCH = "talk.launch"


@points(2)
def test_word(submission):
    """The talker says the right word."""


@points(1)
def test_answers(submission):
    """The answers are right."""
    assert submission.answers["fixed_frame"] and submission.answers["distance"]
'''
HIDDEN = '''\
"""Hidden checks."""

from grader.checks import points


@points(1)
def test_launch(submission):
    """The launch file starts the talker."""
'''
VARIANTS = '''\
[[variant]]
name = "another word"
expect = "reject"
check = "test_word"
says = "not the right word"
edits = [{ file = "hello_ros/scripts/talker.py", old = "the right word", new = "a wrong one" }]

[[variant]]
name = "another frame"
expect = "reject"
check = "test_answers"
says = "fixed_frame"
answers = { fixed_frame = "map" }

[[variant]]
name = "shorter"
expect = "accept"
[variant.files]
"hello_ros/scripts/talker.py" = """
print("the right word")
"""
'''


class Workbook:
    """The files of a small workbook, and a way to grade it without processes."""

    source = "solutions/3_01_say_it.md"
    checks = "exercises/test_3_01.py"
    hidden = "solutions/test_3_01_hidden.py"
    variants = "solutions/variants_3_01.toml"
    student = "exercises/3_01_say_it.ipynb"
    solution = "solutions/3_01_say_it.ipynb"

    def __init__(self, root: Path) -> None:
        self.root = root
        for name, text in (
            (self.source, SOURCE),
            (self.checks, CHECKS),
            (self.hidden, HIDDEN),
            (self.variants, VARIANTS),
        ):
            self.write(name, text)

    def write(self, name: str, text: str) -> Path:
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def read(self, name: str) -> str:
        return (self.root / name).read_text(encoding="utf-8")

    def edit(self, name: str, old: str, new: str) -> None:
        text = self.read(name)
        assert text.count(old) >= 1, old
        self.write(name, text.replace(old, new))

    def build(self) -> list[Path]:
        return build(self.root)

    def grade(self, submission: Submission, exercise: Exercise) -> ExerciseResult:
        """What the checks would say."""
        files, answers = submission.files, submission.answers
        right = {
            "test_word": "the right word" in files.get("hello_ros/scripts/talker.py", ""),
            "test_answers": answers.get("fixed_frame") == "world" and answers.get("distance") == 2,
            "test_launch": "<node" in files.get("hello_ros/launch/talk.launch", ""),
        }
        says = {"test_word": "this is not the right word", "test_answers": "fixed_frame is wrong"}
        attempted = submission.attempted(exercise)
        bad = Status.FAILED if attempted else Status.NOT_ATTEMPTED
        checks = [
            CheckResult(
                name=name,
                title=f"{name}.",
                status=Status.PASSED if passed else bad,
                points=1.0 if passed else 0.0,
                max_points=1.0,
                message="" if passed else says.get(name, "wrong"),
                hint="" if passed else "look again",
            )
            for name, passed in right.items()
        ]
        return ExerciseResult.from_checks(exercise.id, checks)


@pytest.fixture
def workbook(tmp_path: Path) -> Workbook:
    return Workbook(tmp_path / "workbook")
