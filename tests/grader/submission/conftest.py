"""A small exercise, and notebooks for it in every state."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from grader.exercises import Exercise, NodesMay
from grader.submission import Notebook, notebook_from_bytes


class Make:
    """Builds exercises, cells and notebooks."""

    path = "hello_ros/scripts/turtle_tf_broadcaster.py"
    launch = "hello_ros/launch/start.launch"
    stub = "import rospy\n# TODO: broadcast the pose\npass\n"
    solved = "import rospy\nrospy.init_node('solved')\n"
    answers = 'fixed_frame = "world"\ndistance = 2.0'

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def exercise(self, exercise_id: str, slug: str, **changes: Any) -> Exercise:
        fields: dict[str, Any] = {
            "id": exercise_id,
            "slug": slug,
            "title": "Broadcast",
            "package": "hello_ros",
            "files": (self.path,),
            "answers": ("fixed_frame", "distance"),
            "permissions": NodesMay(publish=("/tf",)),
            "public_checks": Path("test.py"),
            "hidden_checks": None,
            "stub_files": {self.path: self.stub},
        }
        return Exercise(**{**fields, **changes})

    def cell(self, source: str | list[str], kind: str = "code", **more: Any) -> dict[str, Any]:
        made: dict[str, Any] = {"cell_type": kind, "source": source, "metadata": {}}
        if kind == "code":
            made |= {"outputs": [], "execution_count": None}
        return made | more

    def answer(self, source: str | None = None, kind: str = "code") -> dict[str, Any]:
        return self.cell(source or self.answers, kind, metadata={"tags": ["answer"]})

    def writes(self, text: str | None = None, path: str = path, **more: Any) -> dict[str, Any]:
        return self.cell(f"%%writefile {path}\n{self.solved if text is None else text}", **more)

    def json(self, *cells: dict[str, Any], claims: str | None = "3.1", **more: Any) -> str:
        metadata: dict[str, Any] = {"kernelspec": {"name": "python3"}}
        if claims is not None:
            metadata["workbook"] = {"id": claims}
        numbered = [{"id": f"cell-{n}", **one} for n, one in enumerate(cells)]
        value = {"cells": numbered, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5}
        return json.dumps(value | more)

    def notebook(self, *cells: dict[str, Any], **more: Any) -> Notebook:
        return notebook_from_bytes(self.json(*cells, **more).encode(), name="x.ipynb")

    def save(
        self, *cells: dict[str, Any], to: str = "3_01_broadcast_a_tf.ipynb", **more: Any
    ) -> Path:
        path = self.folder / to
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(self.json(*cells, **more), encoding="utf-8")
        return path


@pytest.fixture
def make(tmp_path: Path) -> Make:
    return Make(tmp_path)


@pytest.fixture
def exercise(make: Make) -> Exercise:
    return make.exercise("3.1", "3_01_broadcast_a_tf")


@pytest.fixture
def exercises(make: Make, exercise: Exercise) -> dict[str, Exercise]:
    second = make.exercise(
        "3.2",
        "3_02_launch",
        files=(make.launch,),
        answers=(),
        stub_files={make.launch: "<launch/>\n"},
    )
    tenth = make.exercise("3.10", "3_10_arm", files=("hello_ros/arm.urdf",), answers=())
    return {"3.1": exercise, "3.2": second, "3.10": tenth}
