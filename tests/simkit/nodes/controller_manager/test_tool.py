"""controller_manager: what each of its commands does and prints."""

from __future__ import annotations

import pytest


def run(desk, *words):
    program = desk.start("controller_manager", *words)
    desk.run(0.1)
    return program


@pytest.mark.parametrize(
    ("words", "asked", "printed"),
    [
        (["load", "arm"], ["load arm"], "Loaded arm\n"),
        (["load", "bad"], ["load bad"], "Error when loading bad\n"),
        (["unload", "run"], ["unload run"], "Unloaded run successfully\n"),
        (["unload", "x"], ["unload x"], "Error when unloading x\n"),
        (["start", "run"], ["switch ['run'] [] 2"], "Started ['run'] successfully\n"),
        (["start", "x"], ["switch ['x'] [] 2"], "Error when starting  ['x']\n"),
        (["stop", "run"], ["switch [] ['run'] 2"], "Stopped ['run'] successfully\n"),
        (["stop", "x"], ["switch [] ['x'] 2"], "Error when stopping  ['x']\n"),
        (
            ["spawn", "a", "b"],
            ["load a", "load b", "switch ['a'] [] 2", "switch ['b'] [] 2"],
            "Loaded a\nLoaded b\nStarted ['a'] successfully\nStarted ['b'] successfully\n",
        ),
        (
            ["kill", "run"],
            ["switch [] ['run'] 2", "unload run"],
            "Stopped ['run'] successfully\nUnloaded run successfully\n",
        ),
        (["lt"], [], "a/A\nb/B\n"),
        (["list"], [], "run - hardware_interface::PositionJointInterface ( running )\n"),
        (["reload-libraries"], ["reload"], "Restore: False\nSuccessfully reloaded libraries\n"),
        (
            ["reload-libraries", "--restore"],
            ["reload", "load run", "switch ['run'] [] 1"],
            "Restore: True\nSuccessfully reloaded libraries\nControllers restored to original state\n",
        ),
    ],
)
def test_a_command_asks_the_manager_and_prints_what_came_of_it(desk, words, asked, printed):
    manager = desk.manager()
    manager.states = {"run": "running"}
    program = run(desk, *words)
    assert manager.asked == asked
    assert program.output == printed
    assert program.exit_code == 0


def test_an_empty_list_is_said(desk):
    desk.manager()
    assert run(desk, "list").output == "No controllers are loaded in mechanism control\n"


@pytest.mark.parametrize(("words", "code"), [([], 0), (["dance"], 1)])
def test_what_is_no_command_prints_all_that_are(desk, words, code):
    program = run(desk, *words)
    assert program.exit_code == code
    assert "spawn <name>" in program.output


def test_it_waits_for_the_manager_and_says_what_could_be_wrong(desk):
    program = run(desk, "list")
    desk.run(5.0)
    assert program.exit_code is None
    assert desk.said()[-1].startswith(
        "WARN hint: nobody offers /controller_manager/list_controllers"
    )
    desk.manager()
    desk.run(0.2)
    assert program.exit_code == 0
