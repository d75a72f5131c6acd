from __future__ import annotations

import pytest

from simkit.errors import UnknownNameError


@pytest.mark.parametrize(
    ("key", "linear", "angular"),
    [("up", 2.0, 0.0), ("down", -2.0, 0.0), ("left", 0.0, 2.0), ("right", 0.0, -2.0)],
)
def test_arrow_keys(bench, key: str, linear: float, angular: float) -> None:
    heard = bench.hear("/turtle1/cmd_vel", "geometry_msgs/Twist")
    bench.start("turtle_teleop_key").press(key)
    bench.run(1.0)
    ((twist),) = heard
    assert (twist.linear.x, twist.angular.z) == (linear, angular)


def test_scales_are_parameters(bench) -> None:
    bench.graph.params.set("/scale_linear", 3)
    bench.graph.params.set("/scale_angular", 0.5)
    heard = bench.hear("/turtle1/cmd_vel", "geometry_msgs/Twist")
    teleop = bench.start("turtle_teleop_key")
    teleop.press("up")
    teleop.press("right")
    bench.run(0.0)
    assert [(twist.linear.x, twist.angular.z) for twist in heard] == [(3.0, 0.0), (0.0, -0.5)]


def test_one_press_moves_the_turtle_two_metres(bench) -> None:
    window = bench.start("turtlesim_node")
    teleop = bench.start("turtle_teleop_key")
    bench.run(0.1)
    teleop.press("up")
    bench.run(2.0)
    assert window.frame.turtle("turtle1").pose.x == pytest.approx(5.544 + 2.0, abs=0.03)


def test_it_says_what_to_do(bench) -> None:
    assert bench.start("turtle_teleop_key").output.splitlines() == [
        "Reading from keyboard",
        "---------------------------",
        "Use arrow keys to move the turtle. 'q' to quit.",
    ]


def test_q_ends_the_node(bench) -> None:
    bench.start("turtle_teleop_key").press("q")
    assert "/teleop_turtle" not in bench.graph.nodes


def test_another_key_is_refused(bench) -> None:
    with pytest.raises(UnknownNameError, match="no key 'rigth'; did you mean 'right'"):
        bench.start("turtle_teleop_key").press("rigth")
