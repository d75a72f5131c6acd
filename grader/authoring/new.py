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

# {id} {title}

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


def new_exercise(root: Path, exercise_id: str, *, title: str) -> list[Path]:
    """Write the files of a new exercise.

    Args:
        root: Folder of the workbook.
        exercise_id: E.g. "3.11".
        title: Its title.

    Returns:
        The files that were written.

    Raises:
        GraderError: The number or the title cannot be used, or the exercise is there already.
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
    texts = _texts(root, key, words, {"id": exercise_id, "title": title})
    for path in texts:
        if path.exists():
            raise GraderError(f"{path.name} is there already; nothing was written")
    for path, text in texts.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode("utf-8"))
    return list(texts)


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
