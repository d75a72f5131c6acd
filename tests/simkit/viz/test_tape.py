from __future__ import annotations

import pytest

from simkit.msgs import Time, message_class
from simkit.viz import RvizReplay, RvizSettings
from simkit.viz.rviz_tape import MOST_POINTS, TopicTape
from simkit.viz.stage.rviz_settings import LaserScanDisplay, OdometryDisplay, displays_of
from simkit.viz.tape import marks_track_data

START = 1_600_088_400


def scan(*ranges, frame="laser"):
    message = message_class("sensor_msgs/LaserScan")()
    message.header.frame_id, message.range_max, message.ranges = frame, 1e6, list(ranges)
    return message


def odometry(x):
    message = message_class("nav_msgs/Odometry")()
    message.header.frame_id = "world"
    message.pose.pose.position.x, message.pose.pose.orientation.w = float(x), 1.0
    return message


def tape_of(buffer, *displays, frame="laser"):
    return TopicTape(displays, buffer=buffer, fixed_frame=frame)


def test_a_moment_is_kept_when_something_has_changed(buffer):
    tape = tape_of(buffer, LaserScanDisplay(topic="/scan"))
    tape.look(0.0)
    tape.hear("/scan", scan(1.0))
    tape.look(0.5)
    tape.look(0.6)
    tape.hear("/other", scan(5.0))
    tape.hear("/scan", scan(2.0, 3.0))
    tape.look(1.0)
    (track,) = tape.tracks()
    assert [(time, len(shown.points)) for time, shown in track.moments] == [(0.5, 1), (1.0, 2)]
    assert len(track.marks.points) == 2
    assert track.keep == 0
    moments = marks_track_data(track)["moments"]
    assert [moment["time"] for moment in moments] == [0.5, 1.0]
    assert moments[0]["points"] == [1, 0, 0]
    assert moments[0]["palette"][moments[0]["colors"][0]].startswith("#")


def test_of_a_trail_each_moment_has_the_lines_that_are_new(buffer):
    tape = tape_of(buffer, OdometryDisplay(topic="/odom", keep=2), frame="world")
    for time, xs in ((0.1, [0]), (0.2, [1, 2, 3]), (0.3, [4])):
        for x in xs:
            tape.hear("/odom", odometry(x))
        tape.look(time)
    (track,) = tape.tracks()
    begins = [[line[0][0] for line in shown.lines] for _, shown in track.moments]
    assert begins == [[0], [2, 3], [4]]
    assert track.keep == 2
    assert [line[0][0] for line in track.marks.lines] == [3, 4]


def test_a_long_recording_has_fewer_moments_and_keeps_its_end(buffer):
    tape = tape_of(buffer, LaserScanDisplay(topic="/scan"))
    size = MOST_POINTS // 50
    for number in range(120):
        tape.hear("/scan", scan(*[number + 1.0] * size))
        tape.look(float(number))
    (track,) = tape.tracks()
    assert sum(len(shown.points) for _, shown in track.moments) <= MOST_POINTS + size
    assert track.moments[-1][0] == 119.0


def test_what_could_not_be_shown_is_told(buffer):
    tape = tape_of(buffer, LaserScanDisplay(topic="/scan"), frame="map")
    tape.hear("/scan", scan(1.0))
    assert "No transform from [laser] to [map]" in tape.troubles()[0]


class WithScan:
    """The drive of a turtle with a laser on its back, and odometry."""

    def __init__(self, drive):
        self._drive = drive

    def topics(self):
        return ["/odom", "/scan", *self._drive.topics()]

    def __getitem__(self, topic):
        if topic == "/tf":
            return self._drive[topic]
        found = []
        for time, _ in self._drive["/tf"][::10]:
            x = (time.to_nsec() - START * 10**9) / 1e9
            message = scan(1.0, frame="turtle1") if topic == "/scan" else odometry(x)
            message.header.stamp = time
            found.append((time, message))
        return found


@pytest.fixture
def replay(drive):
    types = {"/odom": "nav_msgs/Odometry", "/scan": "sensor_msgs/LaserScan"}
    return RvizReplay(WithScan(drive), RvizSettings(topics=displays_of(types)))


def test_a_replay_shows_where_the_laser_was_at_each_time(replay):
    odom, scans = replay.tape.marks
    for time, shown in scans.moments:
        assert shown.points[0][0] == pytest.approx(time + 1.0, abs=0.06)
    assert len(odom.moments) == 11
    assert replay.tape.scene.marks == (odom.marks, scans.marks)
    assert replay.tape.scene.problems == ()


def test_the_page_of_a_replay_has_the_moments_and_a_checkbox(replay, read_page):
    page = read_page(replay.to_html())
    odom, scans = page.data["tape"]["marks"]
    assert len(scans["moments"]) == 11
    assert odom["keep"] == 100
    assert page.by_id("marks-topic-1")[0] == "input"
    assert "LaserScan /scan" in "".join(page.texts)
    assert Time(START).to_nsec() == replay.tape.start_ns
