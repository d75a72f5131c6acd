"""How long a newcomer waits: `make lab` in a fresh clone, until the server answers.

Nothing is taken from a cache of packages: all come from the registry. Beside it, in the same run, the
environment alone, made by uv as `make` does and by plain pip from the same lock file (`--pip`, a minute more).
"""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from figures import Figure, show

ROOT = Path(__file__).resolve().parents[1]
PATIENCE = 300
"""Seconds after which the server is given up."""


@contextmanager
def fresh_clone() -> Iterator[tuple[Path, dict[str, str]]]:
    """A clone of the last commit, and an environment in which no package was ever loaded."""
    with tempfile.TemporaryDirectory() as folder:
        clone = Path(folder) / "course"
        subprocess.run(["git", "clone", "--quiet", str(ROOT), str(clone)], check=True)
        caches = {"UV_CACHE_DIR": f"{folder}/uv", "PIP_NO_CACHE_DIR": "1"}
        yield clone, os.environ | caches


def lab_seconds(clone: Path, environment: dict[str, str]) -> float:
    """Wall time from `make lab` to the first answer of its server [s]."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    options = f"--no-browser --ip=127.0.0.1 --port={port} --IdentityProvider.token=t --allow-root"
    start = time.perf_counter()
    lab = subprocess.Popen(
        ["make", "lab", f"LAB_OPTIONS={options}"],
        cwd=clone,
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    try:
        _wait_for(f"http://127.0.0.1:{port}/api/status?token=t", start, lab)
        return time.perf_counter() - start
    finally:
        os.killpg(lab.pid, signal.SIGKILL)
        lab.wait()


def _wait_for(url: str, start: float, lab: subprocess.Popen[bytes]) -> None:
    while time.perf_counter() - start < PATIENCE and lab.poll() is None:
        try:
            urllib.request.urlopen(url, timeout=5).close()
        except OSError:
            time.sleep(0.1)
        else:
            return
    sys.exit("make lab: its server did not answer; run it by hand to see why")


def environment_seconds(clone: Path, environment: dict[str, str], *commands: list[str]) -> float:
    """Wall time of commands that make an environment in a clone [s]."""
    start = time.perf_counter()
    for command in commands:
        subprocess.run(command, cwd=clone, env=environment, check=True, capture_output=True)
    return time.perf_counter() - start


def main() -> None:
    """Print the figures."""
    with fresh_clone() as (clone, environment):
        show(
            Figure(
                "make lab, fresh clone, until its server answers",
                lab_seconds(clone, environment),
                "s",
                30,
            )
        )
    if "--pip" not in sys.argv:
        return
    with fresh_clone() as (clone, environment):
        ours = environment_seconds(clone, environment, ["make", ".venv/.ready"])
    with fresh_clone() as (clone, environment):
        pip = [
            "v/bin/python",
            "-m",
            "pip",
            "install",
            "--require-hashes",
            "-r",
            "requirements.lock",
        ]
        theirs = environment_seconds(clone, environment, [sys.executable, "-m", "venv", "v"], pip)
    show(Figure("the environment alone, by uv", ours, "s"))
    show(Figure("the same, by pip", theirs, "s"))
    show(Figure("pip over uv", theirs / ours, "x"))


if __name__ == "__main__":
    main()
