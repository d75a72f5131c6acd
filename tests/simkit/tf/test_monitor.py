"""Delays and rates as tf_monitor tells them."""

from __future__ import annotations

import pytest

from simkit.tf.monitor import ChainDelay, TransformMonitor

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
