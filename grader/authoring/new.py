"""Begin a new exercise: a source, two files of checks and one of variants, to be filled in."""

from __future__ import annotations

import re
from pathlib import Path

from grader.errors import GraderError
from grader.exercises import ID_PATTERN, exercise_key

FILL_IN = "FILL IN"
"""Stands in every place of a scaffold that waits for its author; `grader verify` names each."""

_SOURCE = """\
---
workbook:
  id: "{id}"
  title: {title}
  package: hello_ros
  files:
    - hello_ros/scripts/{script}
  answers: []
  nodes_may:
    publish: []
    services: []
    parameters: []
---

# Exercise {id} · {title}

FILL IN: what you learn here, in two or three lines.

```{{code-cell}}
:label: {script}

%%writefile hello_ros/scripts/{script}
#!/usr/bin/env python
import rospy


def main():
    rospy.init_node("{node}")
    # solution: FILL IN: what the student is to do
    print("FILL IN: the solution")
    # end solution


if __name__ == "__main__":
    main()
```

Tag a cell `hint` to fold it, `solution` to leave it out for students, `answer` for short answers.

```{{code-cell}}
from grader import check

check("{id}")
```
"""
_CHECKS = '''\
"""{Kind} checks of exercise {id}."""

from __future__ import annotations

from grader.checks import expect, points


@points(1)
def test_fill_in_{kind}(run_node, sim):
    """FILL IN: the sentence that the student reads."""
    node = run_node("{script}")
    sim.run(1.0)
    expect("{secret}" in node.output, "FILL IN: what is wrong", hint="FILL IN: where to look")
'''
_VARIANTS = """\
# Variants of the solution of {id} that the checks must tell apart. FILL IN more of them.

[[variant]]
name = "nothing said"
expect = "reject"
check = "test_fill_in_public"
says = "FILL IN"
edits = [
    {{ file = "hello_ros/scripts/{script}", old = 'print("FILL IN: the solution")', new = "pass" }},
]
"""


def new_exercise(
    root: Path, exercise_id: str, *, title: str, like: str | None = None
) -> list[Path]:
    """Write the files of a new exercise.

    Args:
        root: Folder of the workbook.
        exercise_id: E.g. "3.11".
        title: Its title.
        like: Number of the exercise that it begins as a copy of; a script that prints a line if None.

    Returns:
        The files that were written.

    Raises:
        GraderError: The number or the title cannot be used, the exercise is there already, or the other is not.
    """
    title = " ".join(title.split())
    words = "_".join(re.findall(r"[a-z0-9]+", title.lower()))
    if not ID_PATTERN.fullmatch(exercise_id):
        raise GraderError(f"{exercise_id!r} is no number of an exercise; 3.11 or S.3 would be")
    if not words or re.search(r"[:#\"'\\{}\[\]]", title):
        raise GraderError(f"{title!r} is no title; use words, without : # quotes and brackets")
    key = exercise_key(exercise_id)
    if known := sorted((root / "solutions").glob(f"{key}_*.md")):
        raise GraderError(f"exercise {exercise_id} is there already: {known[0].name}")
    fields = {"id": exercise_id, "title": title}
    texts = _texts(root, key, words, fields) if like is None else _copy(root, like, words, fields)
    for path in texts:
        if path.exists():
            raise GraderError(f"{path.name} is there already; nothing was written")
    for path, text in texts.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode("utf-8"))
    return list(texts)


def _copy(root: Path, like: str, words: str, fields: dict[str, str]) -> dict[Path, str]:
    """The files of another exercise under the new number: it works at once, and is changed bit by bit."""
    solutions, old = root / "solutions", exercise_key(like) if ID_PATTERN.fullmatch(like) else like
    key = exercise_key(fields["id"])
    source = next(iter(sorted(solutions.glob(f"{old}_*.md"))), None)
    if source is None:
        known = sorted(one.stem for one in solutions.glob("*.md"))
        raise GraderError(f"no exercise {like} to begin with; there are: {', '.join(known)}")
    others = {
        root / "exercises" / f"test_{old}.py": root / "exercises" / f"test_{key}.py",
        solutions / f"test_{old}_hidden.py": solutions / f"test_{key}_hidden.py",
        solutions / f"variants_{old}.toml": solutions / f"variants_{key}.toml",
    }
    texts = {solutions / f"{key}_{words}.md": _renumbered(source, like, fields)}
    for path, copy in others.items():
        todo = f"# {FILL_IN}: what is other here than in {like}.\n"
        texts[copy] = todo + path.read_text(encoding="utf-8").replace(
            f"xercise {like},", f"xercise {fields['id']},"
        )
    return texts


def _renumbered(source: Path, like: str, fields: dict[str, str]) -> str:
    """The text of a source with another number and title, and a line that says what is to be done."""
    heading = f"# Exercise {fields['id']} · {fields['title']}\n\n{FILL_IN}: what is other here than in {like}."
    text = source.read_text(encoding="utf-8").replace(
        f'check("{like}")', f'check("{fields["id"]}")'
    )
    for pattern, new in (
        (r"^  id: .*$", f'  id: "{fields["id"]}"'),
        (r"^  title: .*$", f"  title: {fields['title']}"),
        (r"^# .*$", heading),
    ):
        text = re.sub(pattern, new, text, count=1, flags=re.MULTILINE)
    return text


def _texts(root: Path, key: str, words: str, fields: dict[str, str]) -> dict[Path, str]:
    solutions = root / "solutions"
    fields = {**fields, "script": f"{words}.py", "node": words, "secret": "the solution"}
    public, hidden = {"kind": "public", "Kind": "Public"}, {"kind": "hidden", "Kind": "Hidden"}
    return {
        solutions / f"{key}_{words}.md": _SOURCE.format(**fields),
        root / "exercises" / f"test_{key}.py": _CHECKS.format(**fields, **public),
        solutions / f"test_{key}_hidden.py": _CHECKS.format(**fields, **hidden),
        solutions / f"variants_{key}.toml": _VARIANTS.format(**fields),
    }
