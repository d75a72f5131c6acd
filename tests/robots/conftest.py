"""The robots of the workbook: a test that asks for `urdf`, or for `launch`, runs for each file."""

from __future__ import annotations

from pathlib import Path

import pytest

from simkit.packages import PackagePath

ROOT = Path(__file__).resolve().parents[2]
ROBOTS = ROOT / "robots"


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    for name in ("urdf", "launch"):
        if name in metafunc.fixturenames:
            files = sorted(ROBOTS.glob(f"*/{name}/*.{name}"))
            metafunc.parametrize(name, files, ids=[path.stem for path in files])


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
