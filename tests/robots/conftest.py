"""The robots of the workbook: a test that asks for `urdf`, or for `launch`, runs for each file.

One that asks for `book_urdf` runs for those of the book alone: their first comment names an exercise.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from simkit.packages import PackagePath

ROOT = Path(__file__).resolve().parents[2]
ROBOTS = ROOT / "robots"


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    robots, launches = (
        sorted(ROBOTS.glob("*/urdf/*.urdf")),
        sorted(ROBOTS.glob("*/launch/*.launch")),
    )
    of_the_book = [path for path in robots if is_of_the_book(path.read_text(encoding="utf-8"))]
    for name, files in (("urdf", robots), ("book_urdf", of_the_book), ("launch", launches)):
        if name in metafunc.fixturenames:
            metafunc.parametrize(name, files, ids=[path.stem for path in files])


def is_of_the_book(text: str) -> bool:
    """Whether the first comment of a robot says for which exercise it is."""
    comment = re.search(r"<!--(.*?)-->", text, re.DOTALL)
    return comment is not None and re.search(r"Exercise \w+\.\d+", comment[1]) is not None


@pytest.fixture(scope="session")
def root() -> Path:
    """Folder of the workbook."""
    return ROOT


@pytest.fixture(scope="session")
def robots() -> Path:
    """Folder of the packages."""
    return ROBOTS


@pytest.fixture
def packages() -> PackagePath:
    """The packages of that folder and no others."""
    return PackagePath([ROBOTS])
