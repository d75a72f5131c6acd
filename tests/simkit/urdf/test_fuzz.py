"""Spoiled robots: whatever is in the file, it is read, judged and shown, soon, and nothing is kept."""

from __future__ import annotations

import faulthandler
import json
import random
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from simkit.diagnostics import as_json, as_text
from simkit.packages import PackagePath
from simkit.urdf import Robot, UrdfError, check_urdf_text, load_robot, read_robot, tree_text
from simkit.urdf.kinematics import forward_kinematics
from simkit.urdf.rules import Companion, CompanionKind, check_robot

HERE = Path(__file__).parent
BOOK = HERE.parents[2] / "robots"
KINDS = {".launch": CompanionKind.LAUNCH, ".yaml": CompanionKind.YAML}
STUCK = 120.0
"""Seconds after which a file counts as never-ending: the test run is ended, with a traceback."""
GROWTH = 40
"""Megabytes by which the process may grow in the second half of many files."""

Mutated = Callable[[str, random.Random], bytes]


def sources() -> list[Path]:
    """The robots of the book, those with one fault each, and their launch files."""
    folders = (HERE / "robots", HERE / "faults", BOOK)
    return sorted(path for folder in folders for path in folder.rglob("*.urdf"))


def companions(path: Path, mutated: Mutated, rng: random.Random) -> Iterator[Companion]:
    """The files beside a robot, spoiled as well."""
    for suffix, kind in KINDS.items():
        beside = path.with_suffix(suffix)
        if beside.exists():
            text = mutated(beside.read_text(), rng).decode("utf-8", "replace")
            yield Companion(kind=kind, file=beside.name, text=text)


class Fuzz:
    """Spoils robots, one after the other, and looks at all that is said about them."""

    def __init__(self, mutated: Mutated, seed: int) -> None:
        self.robots = 0
        """Files that ROS would still take."""
        self.finds = 0
        """All finds."""
        self._mutated = mutated
        self._rng = random.Random(seed)
        self._sources = [(path, path.read_text()) for path in sources()]
        self._packages = PackagePath([BOOK], confined=True)

    def run(self, count: int) -> None:
        for _ in range(count):
            path, text = self._rng.choice(self._sources)
            data = self._mutated(text, self._rng)
            beside = tuple(companions(path, self._mutated, self._rng))
            faulthandler.dump_traceback_later(STUCK, exit=True, file=sys.__stderr__)
            try:
                self._look(data, beside)
            except BaseException:
                Path("spoiled.urdf").write_bytes(data)  # in the test's own folder: see `fuzz`
                raise
            finally:
                faulthandler.cancel_dump_traceback_later()

    def _look(self, data: bytes, beside: tuple[Companion, ...]) -> None:
        reading = read_robot(data, file="spoiled.urdf", packages=self._packages)
        out, _, code = check_urdf_text(reading)
        assert code == (255 if reading.robot is None else 0)
        assert len(out) < 100 * len(data) + 1000
        finds = check_robot(reading.document, packages=self._packages, companions=beside)
        assert not [one for one in finds if "could not be applied" in one.what]
        assert json.loads(as_json(finds))["summary"]
        assert as_text(finds).count(": error [") >= sum(
            one.severity.value == "error" for one in finds
        )
        self._check_places(reading.document, finds)
        if reading.robot is not None:
            self.robots += 1
            self._use(reading.robot, data)
            assert tree_text(reading.robot)
        self.finds += len(finds)

    def _check_places(self, document, finds) -> None:
        """Each find stands in the file, and an unreadable file is never without one."""
        for one in finds:
            if one.file == "spoiled.urdf":
                length = len(document.line(one.span.line))
                assert 1 <= one.span.line <= len(document.lines), one
                assert 1 <= one.span.column <= max(1, length), one
                assert one.span.column + one.span.length - 1 <= max(1, length), one
        assert finds or document.is_well_formed

    def _use(self, robot: Robot, data: bytes) -> None:
        """A robot that is taken can be used; what hinders that is one clear error."""
        said = ""
        try:
            forward_kinematics(robot, {})
            if self.robots % 10 == 0:  # which reads and judges it once more
                load_robot(data, file="spoiled.urdf", packages=self._packages)
        except UrdfError as error:
            said = str(error).strip()
        assert "\n" not in said


@pytest.fixture
def fuzz(mutated, tmp_path, monkeypatch):
    """A function that makes a `Fuzz`; a file on which it fails is left in the folder of the test."""
    monkeypatch.chdir(tmp_path)
    return lambda seed: Fuzz(mutated, seed)


def resident() -> float:
    """Megabytes of this process in memory, now."""
    statm = Path("/proc/self/statm")
    if not statm.exists():
        pytest.skip("how much memory a process has is read from /proc, which is not there")
    import resource

    return int(statm.read_text().split()[1]) * resource.getpagesize() / 1e6


def test_some_spoiled_robots(fuzz):
    few = fuzz(1)
    few.run(150)
    assert few.robots > 10
    assert few.finds > 150


@pytest.mark.slow
def test_thousands_of_spoiled_robots(fuzz):
    many = fuzz(2)
    many.run(7_000)
    before = resident()
    many.run(7_000)
    after = resident()
    print(f"{before:.0f} MB after the first half, {after:.0f} MB after the second", end="; ")
    print(f"14000 files, {many.robots} robots, {many.finds} finds")
    assert many.robots > 1000
    assert after - before < GROWTH
