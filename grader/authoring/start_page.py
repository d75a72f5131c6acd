"""The page that `make lab` opens: what this is, what there is to read and to solve, and what is done already."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from grader.authoring.lectures import FOLDER, lecture_paths
from grader.exercises import load_exercises
from grader.last_checks import progress_of

NAME = "Start here.ipynb"
"""Its file in the working folder."""
_WELCOME = """\
# Welcome to the lab

You will make turtles follow each other, build a robot arm out of links and joints, give it mass and motors, and drive a car with
a laser through a world. Files, names and commands are those of a robot that runs ROS 1, and you need not install ROS.

Begin with the first lecture, or jump to an exercise. Each exercise has its task, room for your code, and a last cell,
`check("3.1")`, that shows what works already and what does not. Run a cell with **Shift+Enter**. Check as often as you like."""
_PROGRESS_HEAD = """\
## Exercises

With the points of your last checks; run the next cell to bring them up to date."""
_PROGRESS_CELL = """\
from grader import progress

progress()"""
_HELP = """\
## Good to know

- **Terminals.** *File > New > Terminal* opens one that knows ROS's commands: `roscore`, `rosrun`, `rostopic`, `check_urdf`, ...
  They complete with Tab, and terminals find each other as they find a ROS master.
- **Your files** are beside this page, in the folder `work`. Nothing overwrites them: a new version of an exercise that you
  have begun is put beside yours.
- **Handing in.** Save the notebook of the exercise (**Ctrl+S**) and hand in that one file: it holds your scripts, robots and
  answers.
- **Something does not work?** `simkit doctor` in a terminal says what this machine has and what it lacks."""


def start_page(root: Path, work: Path) -> str:
    """The text of the page.

    Args:
        root: Folder of the workbook.
        work: The student's working folder.
    """
    done = progress_of(work, load_exercises(root).values())
    cells = [
        _markdown("welcome", f"{_WELCOME}\n\n## Lectures\n\n{_lectures(root)}"),
        _markdown("progress-head", _PROGRESS_HEAD),
        {
            "cell_type": "code",
            "execution_count": None,
            "id": "progress",
            "metadata": {},
            "outputs": [
                {
                    "data": {"text/markdown": done._repr_markdown_(), "text/plain": repr(done)},
                    "execution_count": None,
                    "metadata": {},
                    "output_type": "execute_result",
                }
            ],
            "source": _PROGRESS_CELL,
        },
        _markdown("help", _HELP),
    ]
    kernel = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
    page = {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(page, indent=1, ensure_ascii=False) + "\n"


def _lectures(root: Path) -> str:
    return "\n".join(
        f"- [{_title(path)}]({FOLDER}/{path.stem}.ipynb)"
        for path in lecture_paths(root)
        if path.with_suffix(".ipynb").is_file()
    )


def _title(lecture: Path) -> str:
    """The first heading of a lecture."""
    lines = lecture.read_text(encoding="utf-8").splitlines()
    return next((line[2:] for line in lines if line.startswith("# ")), lecture.stem)


def _markdown(name: str, text: str) -> dict[str, Any]:
    return {"cell_type": "markdown", "id": name, "metadata": {}, "source": text}
