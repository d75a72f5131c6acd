"""What only a browser can tell of scans, trails and paths: that they are drawn, in their colours, and move in a replay."""

from __future__ import annotations

import json

import numpy as np
import pytest
from matplotlib.image import imread

from simkit.graph import Executor, Graph
from simkit.graph.params import ParameterServer
from simkit.msgs import Time, message_class
from simkit.packages import PackagePath
from simkit.viz import LiveRviz, RvizReplay, RvizSettings, RvizView, SceneSource, TopicListeners
from simkit.viz.stage.parts import moment_data
from simkit.viz.stage.rviz_settings import LaserScanDisplay, OdometryDisplay, PathDisplay

pytestmark = pytest.mark.slow

START = 1_600_088_400
TOPICS = (
    LaserScanDisplay(topic="/scan"),
    OdometryDisplay(topic="/odom", keep=3),
    PathDisplay(topic="/plan"),
)
MEASURE = """
await started;
const count = (number, kind) => view.objects.marks[number].many[kind]?.count ?? 0;
const state = () => found.push([count(0, "box"), count(1, "rod"), count(2, "rod")]);
const found = [];
"""


def scan(near=1.0):
    message = message_class("sensor_msgs/LaserScan")(range_max=10.0, angle_increment=0.02)
    message.header.frame_id = "world"
    message.ranges = [near + 8.9 * number / 60 for number in range(61)]
    return message


def odometry(x):
    message = message_class("nav_msgs/Odometry")()
    message.header.frame_id = "world"
    message.pose.pose.position.x, message.pose.pose.orientation.w = float(x), 1.0
    return message


def path():
    message = message_class("nav_msgs/Path")()
    message.header.frame_id = "world"
    for x in range(4):
        message.poses.append(message_class("geometry_msgs/PoseStamped")())
        message.poses[-1].pose.position.x, message.poses[-1].pose.position.y = float(x), -2.0
    return message


class Robot:
    """Says what is shown; a view of it can be had."""

    def __init__(self, buffer):
        buffer.put("world", "turtle1")
        self._graph = Graph(Executor(START * 10**9))
        node = self._graph.create_node("/robot")
        says = {"/scan": scan(), "/odom": odometry(0), "/plan": path()}
        self._publishers = {name: node.advertise(name, type(one)) for name, one in says.items()}
        self.source = SceneSource(
            RvizSettings(show_tf=False, show_grid=False, topics=TOPICS),
            buffer=buffer,
            parameters=ParameterServer(),
            packages=PackagePath([]),
            listeners=TopicListeners(self._graph.create_node("/simkit"), buffer),
        )
        self.source.marks()

    def say(self, topic, message):
        self._publishers[topic].publish(message)
        self._graph.executor.run_to(self._graph.executor.now_ns)


@pytest.fixture
def robot(buffer):
    return Robot(buffer)


@pytest.fixture
def said(robot):
    robot.say("/scan", scan())
    for x in range(5):
        robot.say("/odom", odometry(x))
    robot.say("/plan", path())
    return robot


def seen(image, color):
    """How many pixels have nearly a colour."""
    return int((np.abs(image[:, :, :3] - np.array(color)).max(axis=2) < 0.2).sum())


COLORS = {"near": (1, 0, 0), "far": (0.85, 0, 1), "middle": (0, 1, 0.5), "path": (0.1, 1, 0)}


def test_everything_is_drawn_in_its_colour_with_and_without_a_browser(said, browse, tmp_path):
    view = RvizView(said.source.scene())
    view.save(tmp_path / "view.html")
    view.save(tmp_path / "still.png")
    browse((tmp_path / "view.html").as_uri(), f"--screenshot={tmp_path / 'picture.png'}")
    for picture in ("picture.png", "still.png"):
        image = imread(tmp_path / picture)
        for name, color in COLORS.items():
            assert seen(image, color) > 15, f"{name} in {picture}"


def test_each_display_has_a_checkbox_that_hides_it(said, run_in_page):
    script = """
    view.draw();
    const shown = () => view.objects.marks.map(({ group }) => group.visible);
    found.push(shown());
    document.getElementById("marks-topic-1").click();
    view.draw();
    found.push(shown());
    return found;
    """
    found = run_in_page(RvizView(said.source.scene()).to_html(), MEASURE + script)
    assert found == [[True, True, True], [True, False, True]]


def test_a_live_view_hears_of_messages(robot, browse):
    live = LiveRviz(robot.source)
    robot.say("/scan", scan())
    live.refresh()
    try:
        shown = browse(live.url, "--dump-dom")
    finally:
        live.close()
    assert "<li>LaserScan /scan" not in shown
    assert "<li>Path /plan: No messages received. " in shown


def test_points_that_come_later_have_their_colours(robot, run_in_page):
    page = RvizView(robot.source.scene()).to_html()
    robot.say("/scan", scan())
    moment = json.dumps(moment_data(robot.source.marks()[0]))
    script = f"""
    view.draw();
    view.objects.marks[0].show({moment});
    view.draw();
    const copy = document.createElement("canvas"), picture = element("picture");
    [copy.width, copy.height] = [picture.width, picture.height];
    const paint = copy.getContext("2d");
    paint.drawImage(picture, 0, 0);
    const {{ data }} = paint.getImageData(0, 0, copy.width, copy.height);
    const seen = new Set();
    for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 250) seen.add(data.slice(i, i + 3).join());
    return [...seen];
    """
    assert len(run_in_page(page, MEASURE + script)) > 5


class Recording:
    """Two seconds of it."""

    def __init__(self):
        one = message_class("geometry_msgs/TransformStamped")()
        one.header.frame_id, one.child_frame_id, one.transform.rotation.w = "world", "turtle1", 1.0
        tf = message_class("tf2_msgs/TFMessage")(transforms=[one])
        self._messages = {
            "/tf": [(0.0, tf), (2.0, tf)],
            "/scan": [(0.5, scan()), (1.5, scan(5.0))],
            "/odom": [(number / 4, odometry(number)) for number in range(8)],
            "/plan": [(1.0, path())],
        }

    def topics(self):
        return sorted(self._messages)

    def __getitem__(self, topic):
        return [
            (Time.from_nsec(round((START + t) * 1e9)), message)
            for t, message in self._messages[topic]
        ]


def test_a_replay_shows_what_there_was_at_each_time(run_in_page):
    script = """
    const slider = document.getElementById("time");
    for (const time of [0, 0.6, 1.2, 2, 0]) {
      slider.value = time;
      slider.dispatchEvent(new Event("input"));
      state();
    }
    return found;
    """
    replay = RvizReplay(Recording(), RvizSettings(topics=TOPICS))
    found = run_in_page(replay.to_html(), MEASURE + script)
    # An arrow is four rods; no more than three are kept. The second scan reaches beyond its range.
    some = sum(1 for value in scan(5.0).ranges if value < 10.0)
    assert found == [[0, 4, 0], [61, 12, 0], [61, 12, 3], [some, 12, 3], [0, 4, 0]]
