"""tf_monitor: what it prints, and its delays and rates."""

from __future__ import annotations

import re

import pytest

from simkit.nodes.tf_tools.monitor import ChainDelay, TransformMonitor

SECOND = 10**9


@pytest.fixture
def monitor():
    return TransformMonitor()


def note(monitor, frame, *, now, late=0.0, by="/a", static=False):
    stamp = round((now - late) * SECOND)
    monitor.note([(frame, stamp)], authority=by, now=round(now * SECOND), static=static)


def test_delays_rates_and_broadcasters_of_all_frames(monitor):
    for turn in range(11):
        note(monitor, "turtle1", now=100 + turn / 10, late=0.02 if turn % 2 else 0.04)
        note(monitor, "carrot1", now=100 + turn / 10, late=-0.1, by="/carrot")
    note(monitor, "base", now=100, late=50, by="/fixed", static=True)
    assert monitor.report().splitlines() == [
        "",
        "",
        "",
        "RESULTS: for all Frames",
        "",
        "Frames:",
        "Frame: base published by /fixed(static) Average Delay: 0 Max Delay: 0",
        "Frame: carrot1 published by /carrot Average Delay: -0.1 Max Delay: 0",
        "Frame: turtle1 published by /a Average Delay: 0.0309091 Max Delay: 0.04",
        "",
        "All Broadcasters:",
        "Node: /a 11 Hz, Average Delay: 0.0309091 Max Delay: 0.04",
        "Node: /carrot 11 Hz, Average Delay: -0.1 Max Delay: 0",
        "Node: /fixed(static) 1e+08 Hz, Average Delay: 0 Max Delay: 0",
    ]


def test_two_broadcasters_of_one_frame_are_both_listed(monitor):
    for turn in range(4):
        note(monitor, "carrot1", now=turn / 2, by="/good" if turn % 2 else "/rival")
    report = monitor.report()
    assert report.count("Frame: carrot1") == 1
    assert "Node: /good 2 Hz" in report
    assert "Node: /rival 2 Hz" in report


def test_a_window_of_a_thousand(monitor):
    for turn in range(2000):
        note(monitor, "a", now=turn / 100, late=1.0 if turn < 1000 else 0.0)
    report = monitor.report()
    assert "Frame: a published by /a Average Delay: 0 Max Delay: 0" in report
    assert "Node: /a 100.1 Hz" in report


def test_a_message_of_several_transforms_counts_once_for_its_sender(monitor):
    monitor.note([("a", 0), ("b", 2 * SECOND)], authority="/n", now=2 * SECOND, static=False)
    assert "Node: /n 1e+08 Hz, Average Delay: 1 Max Delay: 1\n" in monitor.report()


def test_a_chain_shows_its_own_frames_and_its_delay(monitor):
    for frame in ("turtle1", "carrot1", "other"):
        note(monitor, frame, now=1.0)
    chain = ChainDelay(frames=["world", "turtle1", "carrot1"])
    for _ in range(2):
        chain.note(0.5)
    lines = monitor.report(chain).splitlines()
    assert lines[3:6] == [
        "RESULTS: for world to carrot1",
        "Chain is: world -> turtle1 -> carrot1",
        "Net delay     avg = 0.00995: max = 0.5",
    ]
    assert [line.split()[1] for line in lines if line.startswith("Frame:")] == [
        "carrot1",
        "turtle1",
    ]


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
