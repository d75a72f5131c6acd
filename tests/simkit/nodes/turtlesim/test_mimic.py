from __future__ import annotations

import pytest


def test_the_second_turtle_does_what_the_first_does(bench) -> None:
    leader = bench.start("turtlesim_node", name="/a/turtlesim")
    follower = bench.start("turtlesim_node", name="/b/turtlesim")
    remappings = {"/input/pose": "/a/turtle1/pose", "/output/cmd_vel": "/b/turtle1/cmd_vel"}
    bench.start("mimic", **remappings)
    bench.run(0.1)
    bench.command("/a/turtle1/cmd_vel", linear=1.0, angular=0.7)
    bench.run(3.0)
    first, second = (window.frame.turtle("turtle1").pose for window in (leader, follower))
    assert second.x == pytest.approx(first.x, abs=0.02)
    assert second.y == pytest.approx(first.y, abs=0.02)
    assert first.theta == pytest.approx(0.7, abs=0.02)


def test_input_and_output_are_namespaces_to_remap(bench) -> None:
    leader = bench.start("turtlesim_node", name="/a/turtlesim")
    follower = bench.start("turtlesim_node", name="/b/turtlesim")
    bench.start("mimic", **{"/input": "/a/turtle1", "/output": "/b/turtle1"})
    bench.run(0.1)
    bench.command("/a/turtle1/cmd_vel", linear=1.0, angular=0.0)
    bench.run(2.0)
    first, second = (window.frame.turtle("turtle1").pose for window in (leader, follower))
    assert first.x > 6.0
    assert second.x == pytest.approx(first.x, abs=0.02)
