"""The workbook of this checkout: a test that asks for `exercise_id` runs for each exercise."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from grader.exercises import Exercise, get_exercise, load_exercises

ROOT = Path(__file__).resolve().parents[2]


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "exercise_id" in metafunc.fixturenames:
        metafunc.parametrize("exercise_id", list(load_exercises(ROOT)))


@pytest.fixture(scope="session")
def root() -> Path:
    """Folder of the workbook."""
    return ROOT


@pytest.fixture
def exercise(exercise_id: str) -> Exercise:
    """The exercise that this run of the test is about."""
    return get_exercise(ROOT, exercise_id)


@pytest.fixture
def course(tmp_path: Path) -> Path:
    """A student's checkout: the released exercises and no more, so that nothing of ours is touched."""
    folder = tmp_path / "my course"  # with a space, as people have
    shutil.copytree(ROOT / "exercises", folder / "exercises")
    return folder
