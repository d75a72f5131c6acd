"""`simkit` itself: help, unknown words, errors in one line."""

import shutil
import subprocess
import sys

import pytest

from simkit import __version__
from simkit.cli import main
from simkit.commands.parser import terminal_width
from simkit.commands.table import COMMANDS


@pytest.mark.parametrize("words", [(), ("-h",), ("--help",), ("help",)])
def test_the_help_lists_every_command_under_its_group(simkit, words):
    code, out, err = simkit(*words)
    assert (code, err) == (0, "")
    for command in COMMANDS.values():
        assert f"  {command.name} " in out
        assert f"{command.group}:\n" in out
    assert len({command.group for command in COMMANDS.values()}) > 2


def test_the_version(simkit):
    assert simkit("--version") == (0, f"simkit {__version__}\n", "")


def test_an_unknown_command_names_near_ones(simkit):
    code, out, err = simkit("rosmsgs")
    assert (code, out) == (2, "")
    assert err.startswith("simkit: no command 'rosmsgs'; did you mean rosmsg")
    assert err.count("\n") == 1


@pytest.mark.parametrize("name", list(COMMANDS))
def test_every_command_has_help_and_refuses_nonsense_in_one_line(simkit, name):
    code, out, _ = simkit(name, "--help")
    assert code == 0
    assert out.startswith(f"usage: simkit {name}")
    code, out, err = simkit(name, "--no-such-option")
    assert code in (1, 2)
    assert err.count("\n") == 1
    assert "Traceback" not in err


@pytest.mark.parametrize("columns", [None, "", "0", "-3", "many", "33", "200"])
def test_help_is_as_wide_as_the_terminal(simkit, monkeypatch, columns):
    monkeypatch.delenv("COLUMNS", raising=False)
    if columns is not None:
        monkeypatch.setenv("COLUMNS", columns)
    assert terminal_width() == shutil.get_terminal_size().columns
    monkeypatch.setattr("sys.__stdout__", None)
    assert terminal_width() == shutil.get_terminal_size().columns
    _, out, _ = simkit("check_urdf", "--help")
    options = out.partition("options:")[2].partition("Standard output")[0]
    assert max(map(len, options.splitlines())) <= terminal_width()


def test_a_reader_that_has_enough_is_no_error():
    command = [sys.executable, "-m", "simkit.cli", "rosmsg", "list"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        process.stdout.readline()
        process.stdout.close()
        assert process.stderr.read() == b""


def test_ctrl_c_is_an_exit_code(monkeypatch):
    def interrupt(_call):
        raise KeyboardInterrupt

    monkeypatch.setattr("simkit.commands.rospack.run", interrupt)
    assert main(["rospack", "list"]) == 130


def test_the_console_script_is_the_module():
    command = [sys.executable, "-m", "simkit.cli", "--version"]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout.startswith(
        "simkit"
    )
