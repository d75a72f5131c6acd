from __future__ import annotations

import io
import math
import xml.etree.ElementTree as ET

import matplotlib
import matplotlib.image
import pytest

from simkit import Simulation
from simkit.errors import UnknownNameError
from simkit.msgs import Duration, Time, message_class
from simkit.tf import ConnectivityException, LookupException, TransformBroadcaster
from simkit.tf.transformations import quaternion_from_euler
from simkit.viz import TransformPlot, transform_series

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture
def plot(turtles):
    return TransformPlot(turtles, target="world", source="turtle1")


def test_the_figure_says_what_it_shows(plot, texts):
    shown = texts(plot.to_svg())
    assert {'"turtle1" seen from "world"', "position [m]", "yaw [rad]", "x", "y", "z", "yaw"} < set(
        shown
    )
    assert "virtual time [s] since 1600088400.000" in shown
    root = ET.fromstring(plot.to_svg())
    assert root.attrib["role"] == "img"
    assert root.findtext(f"{SVG}title") == '"turtle1" seen from "world"'


def test_a_static_transform_is_a_level_line(buffer, texts):
    buffer.put("a", "b", 0, (1, 2, 3), static=True)
    plot = TransformPlot(buffer, target="a", source="b")
    assert any("static transform" in text for text in texts(plot.to_svg()))
    assert plot.series.x == (1.0,)


def test_equal_data_give_equal_bytes_whatever_the_reader_set(plot, turtles):
    svg, png, pdf = plot.to_svg(), plot.to_png(), plot.to_pdf()
    with matplotlib.rc_context({"font.size": 30, "axes.facecolor": "black", "svg.hashsalt": "x"}):
        again = TransformPlot(turtles, target="world", source="turtle1")
        assert again.to_svg() == svg
        assert again.to_png() == png
        assert again.to_pdf() == pdf


def test_png_has_its_size(plot):
    image = matplotlib.image.imread(io.BytesIO(plot.to_png()), format="png")
    assert image.shape[:2] == (644, 1008)


def test_odd_names_are_only_names(hostile, texts):
    for name in ("<script>alert(1)</script>", "\"&'<b>", "a\x00b\x1bc\ud800", "x" * 5000, "世界"):
        svg = TransformPlot(hostile, target="wörld", source=name).to_svg()
        assert max(map(len, texts(svg))) < 120
        assert "<script" not in svg
        svg.encode("utf-8")


def test_unknown_frames_are_refused(turtles):
    with pytest.raises(LookupException, match="turtle9"):
        TransformPlot(turtles, target="world", source="turtle9")


def test_save_writes_by_suffix(plot, tmp_path):
    for suffix in (".svg", ".png", ".pdf"):
        plot.save(tmp_path / f"plot{suffix}")
    assert (tmp_path / "plot.svg").read_text(encoding="utf-8") == plot.to_svg()
    assert (tmp_path / "plot.png").read_bytes() == plot.to_png()
    assert (tmp_path / "plot.pdf").read_bytes() == plot.to_pdf()
    with pytest.raises(UnknownNameError, match=r"no picture format '\.eps'"):
        plot.save(str(tmp_path / "plot.eps"))


def test_notebooks_show_it(plot):
    assert plot._repr_svg_() == plot.to_svg()
    assert repr(plot) == 'TransformPlot(\'"turtle1" seen from "world"\')'


START = 1_600_088_400


@pytest.fixture
def sim():
    with Simulation(screen=None) as simulation:
        yield simulation


@pytest.fixture
def circling(sim):
    """A frame that circles once in 6.28 s, ten times a second, and a recording of it."""
    recording = sim.record({"/tf": "tf2_msgs/TFMessage", "/tf_static": "tf2_msgs/TFMessage"})
    node = sim.graph.create_node("/circling")
    broadcaster = TransformBroadcaster(node)

    def send():
        angle = (node.now() - Time(START)).to_sec()
        message = message_class("geometry_msgs/TransformStamped")()
        message.header.frame_id, message.child_frame_id = "world", "moon"
        message.header.stamp = node.now()
        p, q = message.transform.translation, message.transform.rotation
        p.x, p.y = 3 * math.cos(angle), 3 * math.sin(angle)
        q.x, q.y, q.z, q.w = map(float, quaternion_from_euler(0, 0, angle))
        broadcaster.send_transform(message)

    node.create_timer(Duration(0, 10**8), send)
    sim.run(30)
    return recording


def test_a_recording_reaches_further_back_than_a_buffer(sim, circling):
    long = transform_series(circling, target="world", source="moon")
    short = transform_series(sim.tf, target="world", source="moon")
    assert long.start == Time(START, 10**8)
    assert long.seconds[-1] == pytest.approx(29.9)
    assert short.seconds[-1] == pytest.approx(10.0)
    assert short.x[-1] == long.x[-1]


def test_values_are_those_of_lookups_and_yaw_does_not_jump(circling):
    series = transform_series(circling, target="world", source="moon")
    for t, x, y, z, yaw in zip(
        series.seconds, series.x, series.y, series.z, series.yaw, strict=True
    ):
        angle = t + 0.1
        assert x == pytest.approx(3 * math.cos(angle), abs=0.005)
        assert y == pytest.approx(3 * math.sin(angle), abs=0.005)
        assert z == 0.0
        assert yaw == pytest.approx(angle, abs=0.001)
    assert series.yaw[-1] > 4 * math.pi


def test_the_other_way_round_is_the_inverse(circling):
    there = transform_series(circling, target="world", source="moon")
    back = transform_series(circling, target="moon", source="world")
    assert back.start == there.start
    assert back.x[5] == pytest.approx(-3.0, abs=0.01)
    assert back.yaw[-1] == pytest.approx(-there.yaw[-1], abs=0.01)


def test_static_frames_on_the_way_set_no_limits(circling, buffer):
    buffer.put("world", "a", START + 1, (1, 0, 0))
    buffer.put("world", "a", START + 3, (3, 0, 0))
    buffer.put("a", "b", 0, (0, 1, 0), static=True)
    series = transform_series(buffer, target="world", source="b")
    assert series.start == Time(START + 1)
    assert series.seconds[-1] == 2.0
    assert (series.x[0], series.x[-1]) == (1.0, 3.0)
    assert set(series.y) == {1.0}


def test_only_the_time_that_all_frames_share_counts(buffer):
    for t in (1, 2, 3, 4):
        buffer.put("world", "a", START + t)
    for t in (3, 4, 5):
        buffer.put("a", "b", START + t)
    series = transform_series(buffer, target="world", source="b")
    assert series.start == Time(START + 3)
    assert series.seconds[-1] == 1.0


def test_frames_above_the_meeting_point_do_not_count(buffer):
    buffer.put("map", "world", START + 100)
    for t in (1, 2):
        buffer.put("world", "a", START + t)
        buffer.put("world", "b", START + t)
    series = transform_series(buffer, target="a", source="b")
    assert series.start == Time(START + 1)
    assert series.seconds[-1] == 1.0


def test_a_static_transform_is_one_value(buffer):
    buffer.put("a", "b", 0, (1, 2, 3), (0, 0, 0.5), static=True)
    series = transform_series(buffer, target="a", source="b")
    assert (series.seconds, series.x, series.y, series.z) == ((0.0,), (1.0,), (2.0,), (3.0,))
    assert series.yaw[0] == pytest.approx(0.5)


def test_errors_teach(two_trees, sim):
    with pytest.raises(LookupException) as unknown:
        transform_series(two_trees, target="world", source="turtel1")
    assert "turtle1" in unknown.value.hint
    with pytest.raises(ConnectivityException) as apart:
        transform_series(two_trees, target="world", source="laser")
    assert "two trees" in apart.value.hint
    with pytest.raises(LookupException):
        transform_series(sim.record({"/tf": "tf2_msgs/TFMessage"}), target="a", source="b")
