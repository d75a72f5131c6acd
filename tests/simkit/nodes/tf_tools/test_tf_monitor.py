from __future__ import annotations

import re


def test_all_frames(sim, rosrun):
    rosrun("tf static_transform_publisher 1 0 0 0 0 0 world a 100")
    rosrun("tf2_ros static_transform_publisher 1 0 0 0 0 0 a b")
    monitor = sim.rosrun("tf", "tf_monitor")
    sim.run(4.21)
    reports = monitor.output.split("\n\n\nRESULTS: ")[1:]
    assert len(reports) == 20
    assert reports[-1].splitlines() == [
        "for all Frames",
        "",
        "Frames:",
        "Frame: a published by /static_transform_publisher_1 Average Delay: -0.1 Max Delay: 0",
        "Frame: b published by /static_transform_publisher_2(static) Average Delay: 0 Max Delay: 0",
        "",
        "All Broadcasters:",
        "Node: /static_transform_publisher_1 10.25 Hz, Average Delay: -0.1 Max Delay: 0",
        "Node: /static_transform_publisher_2(static) 1e+08 Hz, Average Delay: 0 Max Delay: 0",
    ]


def test_two_mothers_of_one_frame(sim, rosrun):
    for parent, name in (("world", "right"), ("turtle1", "wrong")):
        frames = f"{parent} carrot1"
        rosrun(f"tf static_transform_publisher 1 0 0 0 0 0 {frames} 100 __name:={name}")
    monitor = sim.rosrun("tf", "tf_monitor")
    sim.run(1.0)
    nodes = re.findall(r"Node: (\S+) (\S+) Hz", monitor.output)
    assert {name for name, _ in nodes} == {"/right", "/wrong"}


def test_a_chain(sim, rosrun):
    monitor = sim.rosrun("tf", "tf_monitor", "/world", "b")
    sim.run(2.5)
    waiting = "Waiting for transform chain to become available between world and b "
    assert monitor.output == waiting + ".."
    for parent, child in (("world", "a"), ("a", "b"), ("world", "other")):
        rosrun(f"tf static_transform_publisher 1 0 0 0 0 0 {parent} {child} 100")
    sim.run(1.0)
    lines = monitor.output.splitlines()
    assert lines[0] == waiting + ".."
    assert lines[4] == "RESULTS: for world to b"
    assert lines[5] == "Chain is: world -> a -> b"
    # Dated ahead by a tenth of a second, so between -0.1 and 0.
    assert re.fullmatch(r"Net delay     avg = -0\.0\d+: max = 0", lines[6])
    assert "Frame: other" not in monitor.output


def test_a_chain_of_static_frames_is_never_late(sim, rosrun):
    rosrun("tf2_ros static_transform_publisher 1 0 0 0 0 0 world a")
    monitor = sim.rosrun("tf", "tf_monitor", "world", "a")
    sim.run(1.0)
    assert "Net delay     avg = 0: max = 0" in monitor.output


def test_one_frame_alone_is_refused(sim, said):
    monitor = sim.rosrun("tf", "tf_monitor", "world")
    assert not monitor.alive
    assert monitor.program.exit_code == 255
    assert said("INFO") == ["TF_Monitor: usage: tf_monitor framea frameb"]
