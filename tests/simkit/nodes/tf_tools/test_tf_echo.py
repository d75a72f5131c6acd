from __future__ import annotations

import pytest

from simkit.nodes.tf_tools import tf_echo


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
        (["world"], tf_echo.USAGE),
        (["world", "a", "1", "2"], tf_echo.USAGE),
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
