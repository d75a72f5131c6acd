"""`simkit env` and `simkit shell`: the words of ROS in the shells that are installed."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys

import pytest

from simkit.commands.shells import SHELLS, begin_text, program_elsewhere, words_folder
from simkit.commands.table import COMMANDS, THIS_INSTALLATION
from simkit.commands.words import ABSENT, SHORTHANDS, all_words
from simkit.live.session import SessionError
from tests.laws import broken_laws

SIMKIT = f"'{sys.executable}' -m simkit.cli"
CLEAN = {name: value for name, value in os.environ.items() if "PACKAGE_PATH" not in name}
BEGIN = {
    "fish": f"{SIMKIT} env --shell fish | source",
    "powershell": f"& {SIMKIT} env --shell powershell | Out-String | Invoke-Expression",
}


@pytest.fixture(params=SHELLS)
def shell(request):
    """Does lines in one of the shells, after `simkit env`; what they print."""
    program = shutil.which(request.param)
    if program is None:
        pytest.skip(f"{request.param} is not installed")
    begin = BEGIN.get(request.param, f'eval "$({SIMKIT} env --shell {request.param})"')

    def run(*lines, folder):
        done = subprocess.run(
            [program, "-c", "\n".join([begin, *lines])],
            cwd=folder,
            env=CLEAN,
            capture_output=True,
            text=True,
            check=False,
        )
        assert not done.stderr
        return done.stdout

    run.name = request.param
    return run


def test_the_words_of_the_book_are_programs(shell, package):
    printed = shell("command -v rosrun", "rosversion -d", folder=package.folder)
    assert printed.split() == [str(words_folder() / "rosrun"), "noetic"]


def test_roscd_goes_to_a_package_from_anywhere(shell, package):
    printed = shell("cd /", "roscd play", "pwd", "roscd", "pwd", folder=package.folder)
    assert printed.split() == [str(package.folder / "play"), str(package.folder)]


def test_undo_leaves_the_environment_as_it_was(shell, package):
    undo = f"{SIMKIT} env --undo --shell {shell.name}"
    lines = {"fish": f"{undo} | source"}.get(shell.name, f'eval "$({undo})"')
    ask = f"'{sys.executable}' -c 'import os; print(os.environ)'"
    before, after = (
        dict(re.findall(r"'(PATH|\w+_PACKAGE_PATH)': '([^']+)'", text))
        for text in (repr(CLEAN), shell(lines, ask, folder=package.folder))
    )
    assert after == before


def test_what_is_no_program_of_ros_is_no_word():
    ours = {name for name, entry in COMMANDS.items() if entry.group == THIS_INSTALLATION}
    assert {"doctor", "env", "shell"} <= ours  # env is another program, too, on every machine
    assert not ours & set(all_words())


def test_what_stands_in_for_an_absent_program_is_there():
    named = {
        word: set(re.findall(r"simkit (\w+)", text)) - set(COMMANDS)
        for word, text in ABSENT.items()
    }
    named |= {word: {lead(["x"])[0]} - set(COMMANDS) for word, lead in SHORTHANDS.items()}
    broken_laws(
        {word: f"names {sorted(missing)}" for word, missing in named.items() if missing},
        "name a command of `simkit --help`",
    )


def test_an_absent_program_says_what_to_use(simkit):
    code, out, err = simkit("rqt_plot", "/odom")
    assert (code, out) == (1, "")
    assert err == f"simkit: there is no rqt_plot here: {ABSENT['rqt_plot']}\n"


def test_a_real_ros_is_not_hidden_unless_that_is_asked_for(simkit, monkeypatch, tmp_path):
    real = tmp_path / "roscore"
    real.write_text("#!/bin/sh\n")
    real.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.environ['PATH']}")
    code, out, err = simkit("env")
    assert (code, out) == (1, "")
    assert str(real) in err
    assert "--force" in err
    assert simkit("env", "--force")[0] == 0


def test_words_of_an_environment_that_is_read_only_lie_in_the_users_own_folder(
    monkeypatch, tmp_path
):
    (tmp_path / "file").touch()
    monkeypatch.setattr(sys, "prefix", str(tmp_path / "file"))
    monkeypatch.setenv("SIMKIT_SESSION", str(tmp_path / "mine" / "session.json"))
    assert words_folder() == tmp_path / "mine" / "words"
    assert program_elsewhere("surely_nothing_has_this_name") is None
    assert str(words_folder()) in begin_text("sh")


def test_words_in_a_folder_of_another_user_are_refused(monkeypatch, tmp_path):
    (tmp_path / "file").touch()
    monkeypatch.setattr(sys, "prefix", str(tmp_path / "file"))
    monkeypatch.setenv("SIMKIT_SESSION", str(tmp_path / "session.json"))
    monkeypatch.setattr(os, "getuid", lambda: 12345)
    with pytest.raises(SessionError, match="belongs to another user"):
        words_folder()


def test_a_shell_of_its_own_has_the_words(package):
    program = [sys.executable, "-m", "simkit.cli", "shell", "--shell", "bash", "--force"]
    if shutil.which("bash") is None:
        pytest.skip("bash is not installed")
    done = subprocess.run(
        program,
        cwd=package.folder,
        input="rosls play\nexit 3\n",
        capture_output=True,
        text=True,
        check=False,
    )
    assert "package.xml" in done.stdout
    assert done.returncode == 3
