"""tf_echo of tf, and echo.py of tf2_tools."""

from __future__ import annotations

import pytest

from simkit.nodes.tf_tools import echo


def publish(sim, x="2"):
    return sim.rosrun(
        "tf", "static_transform_publisher", x, "0", "0", "1.5708", "0", "0", "world", "a", "100"
    )


def test_it_waits_a_second_and_tells_what_is_missing(sim):
    echo = sim.rosrun("tf", "tf_echo", "/world", "/a")
    sim.run(0.9)
    assert echo.output == ""
    sim.run(0.2)
    assert echo.output.splitlines() == [
        "Failure at 1600088401.000000000",
        'Exception thrown:"world" passed to lookupTransform argument target_frame does not exist. ',
        "The current list of frames is:",
        "",
    ]


def test_it_prints_at_once_and_then_every_second(sim):
    publish(sim)
    sim.run(0.3)
    echo = sim.rosrun("tf", "tf_echo", "/world", "/a")
    sim.run(2.3)
    blocks = echo.output.split("At time ")[1:]
    assert len(blocks) == 3
    assert [block.splitlines()[0] for block in blocks] == [
        "1600088400.500",
        "1600088401.500",
        "1600088402.500",
    ]
    assert blocks[0].splitlines()[1:] == [
        "- Translation: [2.000, 0.000, 0.000]",
        "- Rotation: in Quaternion [0.000, 0.000, 0.707, 0.707]",
        "            in RPY (radian) [0.000, -0.000, 1.571]",
        "            in RPY (degree) [0.000, -0.000, 90.000]",
    ]


@pytest.mark.parametrize(("argument", "parameter"), [("10", None), (None, "_rate:=10")])
def test_a_rate_and_a_precision(sim, argument, parameter):
    publish(sim)
    words = [word for word in ("world", "a", argument, parameter, "_precision:=5") if word]
    echo = sim.rosrun("tf", "tf_echo", *words)
    sim.run(2.05)
    assert echo.output.count("At time") == pytest.approx(20, abs=1)
    assert "- Translation: [2.00000, 0.00000, 0.00000]" in echo.output


def test_two_of_them_at_once(sim):
    publish(sim)
    names = [sim.rosrun("tf", "tf_echo", "world", "a").name for _ in range(2)]
    assert names == ["/tf_echo_1", "/tf_echo_2"]
    assert sim.rosrun("tf", "tf_echo", "world", "a", "__name:=mine").name == "/mine"
    sim.run(0.1)
    assert {"/mine", *names} <= set(sim.nodes())


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["world"], echo.USAGE),
        (["world", "a", "1", "2"], echo.USAGE),
        (["world", "a", "0"], "Echo rate must be > 0.0\n"),
        (["world", "a", "often"], "Echo rate must be > 0.0\n"),
    ],
)
def test_wrong_arguments_end_it(sim, words, text):
    echo = sim.rosrun("tf", "tf_echo", *words)
    sim.run(1)
    assert not echo.alive
    assert echo.program.exit_code == 255
    assert echo.output == text


@pytest.fixture
def tf2_echo(sim, rosrun):
    rosrun("tf static_transform_publisher 2 0 0 0 0 0 world a 100")
    sim.run(0.25)

    def run(*words, seconds=2.05):
        node = sim.rosrun("tf2_tools", "echo.py", *words)
        sim.run(seconds)
        return node

    return run


def test_of_tf2_what_it_prints(tf2_echo):
    node = tf2_echo("world", "a", "-r", "2", "-l", "3")
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


def test_of_tf2_an_offset_a_time_and_a_precision(tf2_echo, said):
    assert "[2.0, 0.0, 0.0]" in tf2_echo("world", "a", "-o", "-0.1", "-p", "1").output
    assert "At time 1600088402.5," in tf2_echo("world", "a", "-t", "1600088402.5").output
    tf2_echo("world", "a", "-o", "5", "-c", "5")
    assert "extrapolation" in said("ERROR")[-1]
    assert said("ERROR")[-1].startswith("(current time ")


def test_of_tf2_unknown_frames_are_told_of_and_it_goes_on(tf2_echo, said):
    node = tf2_echo("world", "b")
    assert node.alive
    assert said("ERROR")[0].startswith("At time 0.0, (current time 1600088401.25) ")


def test_of_tf2_a_slash_ends_it(tf2_echo):
    node = tf2_echo("/world", "a")
    assert node.program.exit_code == 1
    assert node.output.splitlines()[-1].startswith('hint: Write "world"')


@pytest.mark.parametrize("words", [["world"], ["world", "a", "-r", "0"], ["world", "a", "-l", "x"]])
def test_of_tf2_wrong_words_end_it(tf2_echo, words):
    node = tf2_echo(*words)
    assert node.program.exit_code == 2
    assert "echo.py: error:" in node.output
