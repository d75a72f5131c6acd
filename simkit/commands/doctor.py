"""`simkit doctor`: what works on this machine, and what is lost without the rest."""

from __future__ import annotations

import argparse
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path

from simkit import __version__
from simkit.commands.command import Answer, parsed
from simkit.errors import SimkitError
from simkit.graph.process import HAS_FORK

DISTRIBUTION = "simkit-workbook"
TRIAL_SECONDS = 10.0
"""Wall time for a trial of a program [s]."""
_BROWSERS = ("chromium", "chromium-browser", "google-chrome", "chrome")
_NODE = "import rospy\nrospy.init_node('trial')\n"


@dataclass(frozen=True, kw_only=True)
class Finding:
    """One thing that was looked at."""

    what: str
    """Its name."""
    works: bool
    """Whether it is here and works."""
    text: str
    """How it works, or what is lost without it."""
    needed: bool = False
    """Whether nothing goes without it."""

    def __str__(self) -> str:
        sign = "ok" if self.works else "FAILS" if self.needed else "missing"
        return f"{sign:<8} {self.what:<16} {self.text}"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """It takes none."""
    parser.epilog = "The exit code is 1 if something is broken that nothing goes without."


def _answer(_arguments: argparse.Namespace) -> Answer:
    yield f"simkit {__version__}, Python {platform.python_version()}, {platform.platform()}\n"
    findings = [look() for look in LOOKS]
    yield "".join(f"{finding}\n" for finding in findings)
    return int(any(finding.needed and not finding.works for finding in findings))


def look_at_packages() -> Finding:
    """Versions of the Python packages that simkit stands on."""
    names = [re.split(r"[ <>=!~;\[]", line)[0] for line in _required()]
    here, missing = [], []
    for name in names:
        try:
            here.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            missing.append(name)
    text = f"pip install {' '.join(missing)}" if missing else ", ".join(here)
    return Finding(what="Python packages", works=not missing, text=text, needed=True)


def look_at_physics() -> Finding:
    """Whether the physics engine is there; it has no wheels for some platforms."""
    try:
        text = f"dartpy {version('dartpy')}"
    except PackageNotFoundError:
        text = (
            "no dartpy: no simulator; it comes for Linux, and with Python 3.12 or newer for Windows and for macOS "
            "on Apple silicon. All else works"
        )
    return Finding(what="physics", works=text.startswith("dartpy"), text=text, needed=False)


def look_at_nodes() -> Finding:
    """Whether a script can be a node, and how long a start takes."""
    from simkit.simulation import Simulation

    with tempfile.TemporaryDirectory() as folder:
        package = Path(folder) / "trial"
        package.mkdir()
        (package / "package.xml").write_text("<package/>")
        (package / "node.py").write_text(_NODE)
        with Simulation(package_path=[folder], screen=None) as sim:
            for _ in range(2):  # the first one starts the warm parent
                start = time.perf_counter()
                node = sim.rosrun("trial", "node.py")
                sim.run(1.0)
                took = (time.perf_counter() - start) * 1e3
    if node.exit_code != 0:
        return Finding(what="nodes", works=False, text=str(node.failure), needed=True)
    how = "forked from a warm parent" if HAS_FORK else "a fresh Python each: there is no safe fork"
    return Finding(
        what="nodes", works=True, text=f"{how}; one lives and ends in {took:.0f} ms", needed=True
    )


def look_at_bubblewrap() -> Finding:
    """Whether a process can be locked in."""
    lost = (
        "scripts of students are graded as plain processes, which see this machine and the network"
    )
    if not sys.platform.startswith("linux"):
        return Finding(what="bubblewrap", works=False, text=f"only Linux has it; {lost}")
    program = shutil.which("bwrap")
    if program is None:
        return Finding(what="bubblewrap", works=False, text=f"not installed; {lost}")
    command = [program, "--unshare-all", "--ro-bind", "/", "/", "--", "true"]
    failure = _failure_of(command)
    if failure is not None:
        return Finding(what="bubblewrap", works=False, text=f"does not run ({failure}); {lost}")
    return Finding(what="bubblewrap", works=True, text=f"{program}: grading can be sandboxed")


def look_at_browser() -> Finding:
    """Whether there is a browser that tests can drive."""
    found = next(filter(None, map(shutil.which, _BROWSERS)), None)
    text = found or "only tests in a browser want it; nothing is lost today"
    return Finding(what="chromium", works=found is not None, text=text)


LOOKS: tuple[Callable[[], Finding], ...] = (
    look_at_packages,
    look_at_physics,
    look_at_nodes,
    look_at_bubblewrap,
    look_at_browser,
)
"""What `simkit doctor` looks at, in this order."""


def _required() -> list[str]:
    try:
        lines = requires(DISTRIBUTION) or []
    except PackageNotFoundError as error:
        raise SimkitError(
            "simkit is not installed, only lying there: pip install -e . in its folder"
        ) from error
    # What has a condition is not for every platform, or an extra.
    return [line for line in lines if ";" not in line]


def _failure_of(command: list[str]) -> str | None:
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=TRIAL_SECONDS, check=False
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return str(error)
    if done.returncode == 0:
        return None
    return (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[-1][:200]


run = parsed("doctor", add_arguments, _answer)
