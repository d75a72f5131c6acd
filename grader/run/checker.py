"""The checker process: pytest, the simulation and the checks, on one submission as data.

Nothing of the student is imported here: scripts run as nodes, in the sandbox. What the checks find
leaves by a private pipe, event by event.

Run as `python -m grader.run.checker` it takes its job from standard input; a warm parent calls
`work` in a fork of itself instead.
"""

from __future__ import annotations

import json
import os
import sys
import threading
from pathlib import Path

import pytest

import simkit.simulation  # noqa: F401
from grader.checks.context import CONTEXT, CheckContext, Event
from grader.checks.values import bounded
from grader.run.job import Job
from grader.run.launch import read_framed

MEMORY_BYTES = 4 * 1024**3
"""Address space of a checker [bytes]: what nodes publish is recorded here, and they may flood."""
_UNUSED = (
    "cacheprovider debugging doctest faulthandler junitxml legacypath logging pastebin setuponly "
    "setupplan stepwise threadexception tmpdir unittest unraisableexception warnings"
)
"""Parts of pytest that a check does not need; without them it starts twice as fast."""


class _Context:
    """Gives the plugin its context, before anything else of pytest runs."""

    def __init__(self, context: CheckContext) -> None:
        self._context = context

    @pytest.hookimpl(tryfirst=True)
    def pytest_configure(self, config: pytest.Config) -> None:
        config.stash[CONTEXT] = self._context

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed:
            lines = bounded(str(report.longrepr)).strip().splitlines()
            self._context.report({"event": "broken", "text": lines[-1] if lines else "no reason"})


def work(data: bytes, results: int) -> None:
    """Run the checks of a job.

    Args:
        data: The job, as JSON.
        results: File descriptor that takes the events.
    """
    job = Job.loads(data)
    _limit_memory()
    # Beside the process's own standard output: what a check prints is no event.
    with os.fdopen(results, "wb", buffering=0) as pipe:

        def report(event: Event) -> None:
            pipe.write(json.dumps(event, allow_nan=False).encode() + b"\n")

        context = CheckContext(
            exercise=job.exercise,
            submission=job.submission,
            sandbox=job.sandbox,
            folder=job.folder,
            report=report,
            only_list=job.only_list,
            for_author=job.for_author,
        )
        run_pytest(context, job.check_files())
        report({"event": "end"})


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # Windows has no such limits
        return
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))


def run_pytest(context: CheckContext, files: list[Path]) -> None:
    """Run check files in this process; what they find goes to `context.report`."""
    os.environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"
    sys.dont_write_bytecode = True  # nothing is left beside the checks
    missing = [path.name for path in files if not path.is_file()]
    if missing:
        context.report({"event": "broken", "text": f"there is no file {missing[0]}"})
        return
    # `oracles` lies beside the public checks, and the hidden checks import it too.
    sys.path.append(str(context.exercise.public_checks.parent))
    code = pytest.main([*_options(files[0].parent), *map(str, files)], plugins=[_Context(context)])
    expected = [pytest.ExitCode.OK, pytest.ExitCode.TESTS_FAILED]
    if context.only_list:
        expected.append(pytest.ExitCode.NO_TESTS_COLLECTED)
    if code not in expected:
        context.report({"event": "broken", "text": f"pytest ended with {code!r}"})


def _options(root: Path) -> list[str]:
    unused = [part for name in _UNUSED.split() for part in ("-p", f"no:{name}")]
    return [
        *("-p", "grader.checks.plugin", *unused),
        *("-c", os.devnull, "-o", "addopts=", "--rootdir", str(root), "--noconftest"),
        *("--import-mode=importlib", "--assert=plain", "--capture=no", "--tb=short", "-q"),
    ]


def main() -> None:
    """Entry point of a checker that was not forked."""
    results = os.dup(1)
    os.dup2(2, 1)
    # As a raw stream: a buffer would swallow the end that the watching thread waits for.
    stdin = os.fdopen(os.dup(0), "rb", buffering=0)
    job = read_framed(lambda size: stdin.read(size) or b"")
    if job is None:
        return
    threading.Thread(target=_end_with, args=(stdin.fileno(),), daemon=True).start()
    work(job, results)


def _end_with(lifeline: int) -> None:
    """End when the runner is gone; the nodes then end with us."""
    while os.read(lifeline, 1):
        pass
    os._exit(1)


if __name__ == "__main__":
    main()
