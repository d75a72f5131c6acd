from __future__ import annotations

import pytest


@pytest.fixture
def echo(sim, rosrun):
    rosrun("tf static_transform_publisher 2 0 0 0 0 0 world a 100")
    sim.run(0.25)

    def run(*words, seconds=2.05):
        node = sim.rosrun("tf2_tools", "echo.py", *words)
        sim.run(seconds)
        return node

    return run


def test_what_it_prints(echo):
    node = echo("world", "a", "-r", "2", "-l", "3")
    assert not node.alive
    assert node.program.exit_code == 0
    assert node.output.count("At time") == 3
    assert node.output.splitlines()[:5] == [
        "At time 1600088400.8, (current time 1600088400.75)",
        "- Translation: [2.000, 0.000, 0.000]",
        "- Rotation: in Quaternion [0.000, 0.000, 0.000, 1.000]",
        "            in RPY (radian) [0.000, -0.000, 0.000]",
        "            in RPY (degree) [0.000, -0.000, 0.000]",
    ]


def test_an_offset_a_time_and_a_precision(echo, said):
    assert "[2.0, 0.0, 0.0]" in echo("world", "a", "-o", "-0.1", "-p", "1").output
    assert "At time 1600088402.5," in echo("world", "a", "-t", "1600088402.5").output
    echo("world", "a", "-o", "5", "-c", "5")
    assert "extrapolation" in said("ERROR")[-1]
    assert said("ERROR")[-1].startswith("(current time ")


def test_unknown_frames_are_told_of_and_it_goes_on(echo, said):
    node = echo("world", "b")
    assert node.alive
    assert said("ERROR")[0].startswith("At time 0.0, (current time 1600088401.25) ")


def test_a_slash_ends_it(echo):
    node = echo("/world", "a")
    assert node.program.exit_code == 1
    assert node.output.splitlines()[-1].startswith('hint: Write "world"')


@pytest.mark.parametrize("words", [["world"], ["world", "a", "-r", "0"], ["world", "a", "-l", "x"]])
def test_wrong_words_end_it(echo, words):
    node = echo(*words)
    assert node.program.exit_code == 2
    assert "echo.py: error:" in node.output
