"""What becomes of a run whose checks loop, crash, or print; and that nothing is left of it."""

import os
import signal
import time
from pathlib import Path

import pytest

from grader.errors import GraderError
from grader.results import Status
from grader.run import SpawnLauncher, TimeLimits, WarmLauncher

TIGHT = TimeLimits(check=0.7, exercise=20)


@pytest.fixture(params=[WarmLauncher, SpawnLauncher])
def launcher(request):
    launcher = request.param()
    yield launcher
    launcher.close()


def test_both_ways_to_start_a_checker_give_the_same_result(workbook, launcher):
    submission = workbook.submission(fixed_frame="map")
    result = workbook.grade(submission, hidden=True, launcher=launcher)
    assert [check.status for check in result.checks] == ["failed", "skipped", "passed"]
    assert result == workbook.grade(submission, hidden=True)


def test_a_check_that_hangs_loses_itself_only(run_checks, launcher):
    begin = time.monotonic()
    checks = run_checks(
        """
        def test_a(): pass
        def test_b():
            while True: pass
        def test_c(): pass
        """,
        launcher=launcher,
        limits=TIGHT,
    )
    assert [checks[name].status for name in "abc"] == ["passed", "timeout", "skipped"]
    assert "0.7 s" in checks["b"].message
    assert "took all the time (b)" in checks["c"].message
    assert time.monotonic() - begin < 10


def test_the_time_of_an_exercise_is_limited_too(run_checks):
    checks = run_checks(
        """
        import time
        def test_a(): pass
        def test_b(): time.sleep(600)
        def test_c(): pass
        """,
        limits=TimeLimits(check=500, exercise=3.0),
    )
    assert [checks[name].status for name in "abc"] == ["passed", "timeout", "skipped"]
    assert "3 s" in checks["b"].message


@pytest.mark.parametrize("deed", ["os._exit(0)", "os.kill(os.getpid(), 9)", "os.abort()"])
def test_a_checker_that_dies_is_our_fault_and_keeps_what_was_decided(run_checks, launcher, deed):
    checks = run_checks(
        f"""
        import os
        def test_a(): pass
        def test_b(): {deed}
        def test_c(): pass
        """,
        launcher=launcher,
    )
    assert [checks[name].status for name in "abc"] == ["passed", "infrastructure", "infrastructure"]
    assert "the checker process ended early" in checks["b"].message


def test_what_a_check_prints_decides_nothing(run_checks, launcher):
    check = run_checks(
        """
        import os, sys
        def test_x():
            forged = '{"event": "result", "index": 0}\\\\n{"event": "end"}\\\\n'
            print(forged * 100_000)
            sys.stderr.write(forged)
            os.write(1, forged.encode())
            expect(False, "no")
        """,
        launcher=launcher,
    )["x"]
    assert (check.status, check.message) == (Status.FAILED, "no")


def test_nothing_is_left_of_a_run(workbook, run_checks, tmp_path, launcher):
    told = tmp_path / "told"
    run_checks(
        f"""
        import os, pathlib
        def test_x(package_path):
            pathlib.Path({str(told)!r}).write_text(f"{{os.getpid()}} {{package_path}}")
        """,
        launcher=launcher,
    )
    pid, folder = told.read_text().split()
    assert not is_alive(pid)
    assert not Path(folder).exists()
    assert not list(workbook.root.rglob("__pycache__"))


def test_a_process_that_detached_itself_is_found(run_checks, tmp_path):
    told = tmp_path / "told"
    run_checks(
        f"""
        import pathlib, subprocess
        def test_x():
            stray = subprocess.Popen(["sleep", "1000"], start_new_session=True)
            pathlib.Path({str(told)!r}).write_text(str(stray.pid))
        """
    )
    assert not is_alive(told.read_text())


def test_a_fork_server_that_dies_is_replaced(workbook):
    launcher = WarmLauncher()
    try:
        submission = workbook.submission(fixed_frame="world")
        first = workbook.grade(submission, launcher=launcher)
        os.kill(launcher.server_pid, signal.SIGKILL)
        os.waitid(os.P_PID, launcher.server_pid, os.WEXITED | os.WNOWAIT)
        assert workbook.grade(submission, launcher=launcher) == first
    finally:
        launcher.close()


def test_a_launcher_that_was_closed_starts_nothing(workbook):
    launcher = WarmLauncher()
    launcher.close()
    with pytest.raises(GraderError, match="stopped"):
        workbook.grade(workbook.submission(), launcher=launcher)


def test_the_environment_of_the_caller_is_not_that_of_the_checks(run_checks, monkeypatch):
    monkeypatch.setenv("SECRET_TOKEN", "hunter2")
    monkeypatch.setenv("PYTEST_ADDOPTS", "-k nothing")
    check = run_checks("""
        import os
        def test_x(): expect("hunter2" not in str(os.environ), "it is there")
    """)["x"]
    assert check.status is Status.PASSED


def test_configuration_beside_the_checks_is_not_read(workbook, run_checks):
    workbook.write("exercises/conftest.py", "raise RuntimeError('read')")
    workbook.write("exercises/pytest.ini", "[pytest]\naddopts = --nothing-of-that-name\n")
    workbook.write("pyproject.toml", "[tool.pytest.ini_options]\naddopts = '--no-such-option'\n")
    assert run_checks("def test_x(): pass")["x"].status is Status.PASSED


def test_notes_of_the_reading_reach_the_result(workbook):
    from dataclasses import replace

    submission = replace(workbook.submission(fixed_frame="world"), notes=("Cell 3 was odd.",))
    assert workbook.grade(submission).notes == ("Cell 3 was odd.",)


def is_alive(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().split()[2] != "Z"
    except OSError:
        return False
