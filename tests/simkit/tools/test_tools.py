"""What holds for all tools."""

from __future__ import annotations

import subprocess
import sys

import pytest

from simkit import UnknownNameError
from simkit.tools import TOOLS, run_tool


@pytest.mark.parametrize("tool", TOOLS)
def test_each_tool_lists_its_commands(command, refusal, tool):
    assert f"{tool} list" in command(tool, "--help")
    text, code = refusal(tool, "lst")
    assert "did you mean list?" in text
    assert code == 64


def test_an_unknown_tool(sim):
    with pytest.raises(UnknownNameError, match="did you mean 'rostopic'"):
        run_tool(sim, "rostopik", [])


def test_what_is_printed_goes_to_standard_output_of_the_moment(sim, capsys):
    run_tool(sim, "rosnode", ["list"])
    assert capsys.readouterr().out == "/turtlesim\n"


def test_the_tools_load_nothing_heavy():
    program = (
        "import sys; from simkit.tools import rosnode, rosparam, rosservice, rostopic_command;"
        "assert not {'numpy', 'matplotlib', 'IPython'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", program], check=True)
