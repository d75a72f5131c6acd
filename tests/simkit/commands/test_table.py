"""What holds for all commands: one function each, in one table, for terminals, notebooks and Python."""

from __future__ import annotations

import inspect
import subprocess
import sys

import pytest

from simkit import Simulation, UnknownNameError
from simkit.commands.command import Call
from simkit.commands.errors import ToolError
from simkit.commands.table import COMMANDS, TerminalPlace, run_command
from simkit.notebook.lines import LINES

TOOLS = [name for name, entry in COMMANDS.items() if entry.place is TerminalPlace.SHARED]


@pytest.mark.parametrize("name", COMMANDS)
def test_each_command_is_one_function_of_a_call_that_yields(name):
    function = COMMANDS[name].load()
    assert len(inspect.signature(function).parameters) == 1
    assert inspect.isgenerator(function(Call(words=["--help"])))


@pytest.mark.parametrize("name", COMMANDS)
def test_each_command_is_a_line_of_a_notebook_or_says_why_not(name):
    assert (name in LINES) == (not COMMANDS[name].not_in_notebook)
    if name in LINES:
        assert LINES[name].__doc__


@pytest.mark.parametrize("name", sorted(set(COMMANDS) & set(dir(Simulation))))
def test_a_method_and_the_command_of_its_name_refuse_with_the_same_words(sim, name):
    words = ["play", "nothing.launch" if name == "roslaunch" else "nothing.py"]
    with pytest.raises(Exception) as of_method:
        getattr(sim, name)(*words)
    with pytest.raises(ToolError) as of_command:
        run_command(sim, name, words)
    assert str(of_command.value).removeprefix("ERROR: ") == str(of_method.value)


@pytest.mark.parametrize("tool", TOOLS)
def test_each_tool_lists_its_commands(command, refusal, tool):
    assert f"{tool} list" in command(tool, "--help")
    text, code = refusal(tool, "lst")
    assert "did you mean list?" in text
    assert code == 64


def test_an_unknown_command(sim):
    with pytest.raises(UnknownNameError, match="did you mean 'rostopic'"):
        run_command(sim, "rostopik", [])


def test_what_is_printed_goes_to_standard_output_of_the_moment(sim, capsys):
    run_command(sim, "rosnode", ["list"])
    assert capsys.readouterr().out == "/turtlesim\n"


def test_the_commands_load_nothing_heavy():
    program = (
        "import sys; from simkit.commands.table import COMMANDS; [one.load() for one in COMMANDS.values()];"
        "assert not {'numpy', 'matplotlib', 'IPython'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", program], check=True)
