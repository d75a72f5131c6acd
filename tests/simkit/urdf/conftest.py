"""Robots to read, and the real check_urdf where it is installed."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import pytest

from simkit.urdf import Reading, Robot, check_urdf_text, read_robot

_ROOT = Path(__file__).resolve().parents[3]
_OWN_SOURCE = "         at line "
_PROBE = b"""<robot name="r"><link name="a"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" izz="1"/></inertial></link></robot> &"""
_WORDS_OF_3_0 = "Error:   Inertial: inertia element missing iyz attribute"
_EMPTY = "Error:   Error document empty."


class Printed(NamedTuple):
    """What check_urdf prints, and how it ends."""

    out: bytes
    """Standard output."""
    err: list[str]
    """Lines of the standard error, without those on urdfdom's own source."""
    code: int
    """Exit code."""


@pytest.fixture(scope="session")
def robots() -> Path:
    """Folder of the arm of the book, as the workbook has it."""
    return _ROOT / "robots/hello_ros/urdf"


@pytest.fixture(scope="session")
def printed_robots() -> Path:
    """Folder of robots as the book prints them; `faulty` below it has some with one fault each."""
    return Path(__file__).parent / "robots"


@pytest.fixture(scope="session")
def all_robots(printed_robots: Path) -> list[Path]:
    """Every robot of the workbook, as it is printed, and faulty."""
    return [*sorted(_ROOT.glob("robots/*/urdf/*.urdf")), *sorted(printed_robots.rglob("*.urdf"))]


@pytest.fixture(scope="session")
def check_urdf() -> Callable[[bytes], Printed]:
    """What we say to a text."""

    def check(data: bytes) -> Printed:
        out, err, code = check_urdf_text(read_robot(data, file="robot.urdf"))
        return Printed(out.encode(), err.split("\n")[:-1], code)

    return check


@pytest.fixture(scope="session")
def real_check_urdf(tmp_path_factory: pytest.TempPathFactory) -> Callable[[bytes], Printed]:
    """What urdfdom's own program says to a text."""
    program = shutil.which("check_urdf")
    if program is None:
        pytest.skip("urdfdom's check_urdf is not installed: Debian has it in liburdfdom-tools")
    path = tmp_path_factory.mktemp("check_urdf") / "robot.urdf"

    def check(data: bytes) -> Printed:
        path.write_bytes(data)
        done = subprocess.run([program, path], capture_output=True, check=False, timeout=20)
        lines = done.stderr.decode(errors="replace").split("\n")[:-1]
        lines = [line for line in lines if not line.startswith(_OWN_SOURCE)]
        return Printed(done.stdout, lines, done.returncode)

    # Older ones have other words, newer ones another XML parser.
    if check(_PROBE).err[:1] != [_WORDS_OF_3_0] or check(b"").err[:1] != [_EMPTY]:
        pytest.skip("the check_urdf that is installed is not that of urdfdom 3.0")
    return check


@pytest.fixture(scope="session")
def read() -> Callable[[str], Reading]:
    """Reads what stands inside of `<robot>`."""
    return lambda inner: read_robot(f'<robot name="r">{inner}</robot>', file="robot.urdf")


@pytest.fixture(scope="session")
def robot(read: Callable[[str], Reading]) -> Callable[[str], Robot]:
    """The robot of some links and joints that are without a fault."""

    def make(inner: str) -> Robot:
        reading = read(inner)
        assert reading.messages == ()
        assert reading.robot is not None
        return reading.robot

    return make
