"""The command line `grader`, in a small course."""

import contextlib
import json
import os
import signal
import sqlite3
import subprocess
import sys
import time

import pytest

from grader.cli import main


@pytest.fixture
def course(workbook, monkeypatch):
    """A course with three submissions, as the current folder."""
    workbook.write("in/ada/9_01_talk.ipynb", workbook.notebook("x = 1\n"))
    workbook.write("in/bob/9_01_talk.ipynb", workbook.notebook("x = 1\n", answer='"map"'))
    workbook.write("in/eve/9_01_talk.ipynb", "{")
    monkeypatch.chdir(workbook.root)
    return workbook


@pytest.fixture
def run(capsys):
    """A function that runs a command line: exit code, standard output, standard error."""

    def run(*words):
        try:
            code = main([str(word) for word in words])
        except SystemExit as error:
            code = error.code
        return code, *capsys.readouterr()

    return run


def read(path):
    return json.loads(path.read_text("utf-8"))


def test_grade_writes_a_gradebook_and_prints_it(course, run, tmp_path):
    code, out, _ = run("grade", "in", "--out", tmp_path / "out", "--jobs", 2)
    assert code == 0
    assert out.splitlines()[2].split() == ["ada", "9.1", "passed", "4", "/", "4"]
    assert "got: 'map'" in out
    book = read(tmp_path / "out" / "gradebook.json")
    assert [entry["student"] for entry in book["submissions"]] == ["ada", "bob", "eve"]
    assert [entry["points"] for entry in book["submissions"]] == [4, 1, 0]
    assert book["sandbox"] in ("bubblewrap", "none")


def test_grade_one_student_without_hidden_checks(course, run, tmp_path):
    words = ("grade", "in", "--out", tmp_path, "--student", "bob", "--no-hidden", "--only", "9.1")
    assert run(*words)[0] == 0
    (entry,) = read(tmp_path / "gradebook.json")["submissions"]
    assert (entry["student"], entry["max_points"]) == ("bob", 3)


def test_grade_again_gives_the_same_bytes(course, run, tmp_path):
    for jobs, name in ((1, "a"), (3, "b")):
        assert run("grade", "in", "--out", tmp_path / name, "--jobs", jobs)[0] == 0
    assert run("grade", "in", "--out", tmp_path / "b", "--resume")[0] == 0
    first, second = (tmp_path / name / "gradebook.json" for name in "ab")
    assert first.read_bytes() == second.read_bytes()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("grade", "nowhere"), "nowhere"),
        (("grade", "in", "--only", "9.9"), "no exercise '9.9'"),
        (("grade", "in", "--student", "adda"), "did you mean 'ada'"),
        (("grade", "in", "--jobs", "0"), "number from 1 up"),
        (("grade",), "PATH"),
        (("check", "9.9"), "no exercise '9.9'"),
        (("start", "9.9"), "no exercise '9.9'"),
        (("--root", "/", "check", "9.1"), "no workbook"),
        (("gradle",), "invalid choice"),
        ((), "required"),
    ],
)
def test_a_wrong_call_is_one_line_and_exit_code_2(course, run, words, said):
    code, out, err = run(*words)
    assert code == 2
    assert said in err
    assert "Traceback" not in err
    assert out == ""


def test_a_fault_of_ours_is_exit_code_2(course, run, tmp_path):
    course.checks("def test_x(): raise RuntimeError('a bug')")
    code, out, _ = run("grade", "in", "--out", tmp_path)
    assert code == 2
    assert "not your fault" in out


def test_check_runs_the_public_checks_on_the_work(course, run):
    assert run("start", "9.1")[0] == 0
    code, out, _ = run("check", "9.1")
    assert code == 1
    assert "not attempted" in out
    course.write("work/9_01_talk.ipynb", course.notebook("x = 1\n"))
    course.write("work/hello_ros/scripts/talk.py", "x = 1\n")
    code, out, _ = run("check", "9.1")
    assert code == 0
    assert "public checks: 2 of 2 passed" in out


def test_new_and_build(workbook, run, monkeypatch):
    monkeypatch.chdir(workbook.root)
    (workbook.root / "exercises/9_01_talk.ipynb").unlink()
    assert run("new", "9.2", "--title", "Say it")[0] == 0
    assert run("build", "--check")[0] == 1
    code, out, _ = run("build")
    assert code == 0
    assert "exercises/9_02_say_it.ipynb" in out
    assert run("build", "--check")[0] == 0


def test_verify_names_what_is_wrong(workbook, run, monkeypatch):
    monkeypatch.chdir(workbook.root)
    code, out, _ = run("verify")
    assert code == 1
    assert "9_01_talk" in out


def _stored(path):
    """How many results a gradebook holds."""
    if not path.exists():
        return 0
    with contextlib.closing(sqlite3.connect(path, timeout=60)) as connection:
        try:
            return connection.execute("select count(*) from result").fetchone()[0]
        except sqlite3.OperationalError:  # it is being made
            return 0


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="signals of another kind")
def test_a_run_that_was_killed_goes_on_with_the_same_gradebook(course, run, tmp_path):
    course.checks("import time\ndef test_x(submission):\n    time.sleep(0.5)\n")
    for number in range(8):
        path = f"in/student{number}/9_01_talk.ipynb"
        course.write(path, course.notebook(f"x = {number}\n"))
    words = ["grade", "in", "--jobs", "1", "--out"]
    store = tmp_path / "killed" / "gradebook.sqlite"
    command = [sys.executable, "-m", "grader.cli", *words, str(tmp_path / "killed")]
    for number in (signal.SIGKILL, signal.SIGINT):
        process = subprocess.Popen(
            [*command, "--resume"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            # Tests that run in the background of a shell ignore Ctrl-C, and so would this one.
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        )
        before = _stored(store)
        while process.poll() is None and _stored(store) < before + 2:
            time.sleep(0.05)
        process.send_signal(number)
        _, err = process.communicate(timeout=60)
        assert b"Traceback" not in err
        assert not (tmp_path / "killed" / "gradebook.json").exists()
    assert run(*words, tmp_path / "killed", "--resume")[0] == 0
    assert run(*words, tmp_path / "whole", "--jobs", "4")[0] == 0
    killed, whole = (tmp_path / name / "gradebook.json" for name in ("killed", "whole"))
    assert killed.read_bytes() == whole.read_bytes()


def test_a_sandbox_can_be_required(course, run, tmp_path, monkeypatch):
    from grader.sandbox import detect

    detect._strongest.cache_clear()
    monkeypatch.setattr(detect, "platform_has_sandbox", lambda: False)
    code, _, err = run("grade", "in", "--out", tmp_path / "a", "--require-sandbox")
    assert code == 2
    assert "no sandbox works here" in err
    assert not (tmp_path / "a" / "gradebook.json").exists()
    code, out, err = run("grade", "in", "--out", tmp_path / "b")
    detect._strongest.cache_clear()
    assert code == 0
    assert "sandbox: none" in out
    assert "no sandbox" in err
    assert read(tmp_path / "b" / "gradebook.json")["sandbox"] == "none"
