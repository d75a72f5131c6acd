"""Attempts to read what is not the student's; what was found would be shouted in an exception."""

import os
import socket
import subprocess
import sys
from pathlib import Path

import pytest

import simkit

SECRET = "hidden-secret-4711"
ROOT = Path(simkit.__file__).parent.parent


def assert_nothing_stolen(outcome):
    assert "STOLEN" not in outcome.text
    assert SECRET not in outcome.text
    assert outcome.result.points == 0


def test_checks_and_solutions_cannot_be_read(sandboxed):
    outcome = sandboxed.attack(f"""
        import os
        found = []
        for root in ({str(sandboxed.root)!r}, {str(ROOT)!r}):
            for folder in ("exercises", "solutions", "grader", "tests", ".git"):
                found += [folder] if os.path.exists(os.path.join(root, folder)) else []
        for folder, folders, files in os.walk("/"):
            folders[:] = [name for name in folders if name not in ("proc", "usr", "site-packages")]
            found += [name for name in files if "test_9_01" in name or name.endswith(".ipynb")]
        if found:
            raise RuntimeError("STOLEN " + str(found[:5]))
    """)
    assert_nothing_stolen(outcome)
    assert "without sleeping" not in outcome.text  # it had the time to look everywhere


@pytest.mark.slow
def test_the_files_of_whoever_grades_cannot_be_read(sandboxed):
    outcome = sandboxed.attack(f"""
        import os
        for path in ({str(Path.home())!r} + "/.ssh", {str(Path.home())!r} + "/.bashrc",
                     "/etc/passwd", "/etc/shadow", "/var", "/home", "/run", "/opt"):
            if os.path.exists(path):
                raise RuntimeError("STOLEN " + path)
    """)
    assert_nothing_stolen(outcome)


def test_nothing_secret_is_in_the_environment_or_another_process(sandboxed, monkeypatch):
    monkeypatch.setenv("SECRET_TOKEN", "STOLEN")
    outcome = sandboxed.attack("""
        import os
        seen = [str(os.environ)]
        for name in os.listdir("/proc"):
            for file in ("environ", "cmdline", "maps", "mem"):
                try: seen.append(open(f"/proc/{name}/{file}", errors="replace").read(100_000))
                except OSError: pass
        text = "".join(seen)
        if "STOLEN" in text or "hidden" in text or "grader.run" in text:
            raise RuntimeError("STOLEN")
    """)
    assert_nothing_stolen(outcome)


@pytest.mark.slow
def test_nothing_of_the_grader_is_in_the_process(sandboxed):
    outcome = sandboxed.attack("""
        import gc, sys
        names = [name for name in sys.modules if name.split(".")[0] in ("grader", "_pytest")]
        texts = [x for x in gc.get_objects() if isinstance(x, dict) and "expect_close" in x]
        frame, files = sys._getframe(), []
        while frame:
            files.append(frame.f_code.co_filename)
            frame = frame.f_back
        if names or texts or any("test_9_01" in file for file in files):
            raise RuntimeError("STOLEN")
        try:
            import grader
            raise RuntimeError("STOLEN")
        except ImportError:
            pass
    """)
    assert_nothing_stolen(outcome)


def test_there_is_no_way_out(sandboxed):
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(0.1)
        outcome = sandboxed.attack(f"""
            import socket
            for family, address in (
                (socket.AF_INET, ("127.0.0.1", {server.getsockname()[1]})),
                (socket.AF_INET, ("192.0.2.1", 80)),
                (socket.AF_UNIX, "/var/run/docker.sock"),
                (socket.AF_UNIX, "\\0/tmp/dbus"),
            ):
                try:
                    socket.socket(family).connect(address)
                    raise RuntimeError("STOLEN")
                except OSError:
                    pass
        """)
        with pytest.raises(TimeoutError):
            server.accept()
    assert_nothing_stolen(outcome)


@pytest.mark.slow
def test_a_link_leads_nowhere(sandboxed):
    outcome = sandboxed.attack(f"""
        import os
        os.symlink({str(sandboxed.root)!r}, "/tmp/link")
        if os.path.exists("/tmp/link/solutions"):
            raise RuntimeError("STOLEN")
    """)
    assert_nothing_stolen(outcome)


def test_nothing_is_left_for_the_next_student(sandboxed):
    write = """
        import os
        for path in ("/tmp/note", "/tmp/sitecustomize.py", os.path.expanduser("~/note")):
            try: open(path, "w").write("raise SystemExit('STOLEN')")
            except OSError: pass
    """
    read = """
        import os
        for path in ("/tmp/note", os.path.expanduser("~/note")):
            if os.path.exists(path):
                raise RuntimeError("STOLEN")
    """
    assert_nothing_stolen(sandboxed.attack(write))
    assert_nothing_stolen(sandboxed.attack(read))


@pytest.mark.slow
def test_hidden_checks_show_nothing_of_themselves(arena):
    for script in (
        "x = 1",
        "raise RuntimeError",
        "import rospy; rospy.init_node('x'); rospy.spin()",
    ):
        assert SECRET not in arena.attack(script).text


@pytest.mark.slow
def test_the_same_is_seen_whoever_runs_the_checks(arena):
    """A script cannot tell grading from practice by what it sees of itself."""
    script = """
        import os, sys
        raise RuntimeError(str([sys.argv, os.getcwd()[-20:], sorted(os.environ), __file__]))
    """
    graded = arena.attack(script).result.checks
    assert graded[0].message == graded[1].message
    assert "PYTEST" not in graded[0].message


@pytest.mark.skipif(sys.platform != "linux", reason="/proc")
@pytest.mark.slow
def test_the_checker_does_not_show_its_job_on_its_command_line(arena):
    arena.honest()
    pid = arena.launcher.server_pid
    text = subprocess.run(["ps", "-o", "args=", "-p", str(pid)], capture_output=True, text=True)
    assert "hidden" not in text.stdout
    assert os.environ.get("SECRET_TOKEN") is None
