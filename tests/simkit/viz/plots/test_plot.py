from __future__ import annotations

import io

import matplotlib
import matplotlib.image
import pytest

from simkit.errors import SimkitError, UnknownNameError
from simkit.msgs import Time, message_class
from simkit.viz.plots.plot import (
    LEAST_HEIGHT,
    Plot,
    finish,
    line_color,
    panels,
    recorded_topic,
    timed,
    topics_of,
)


class Flat(Plot):
    """A line that only rounding errors bend."""

    @property
    def title(self):
        return "a $flat$ <line>"

    def figure(self):
        figure, axes = panels(self.title, (1, 2))
        for one in axes:
            one.plot([0, 1], [5.0, 5.0 + 1e-12], label="flat")
        finish(axes)
        self.axes = axes
        return figure


@pytest.fixture
def plot():
    return Flat()


def test_the_title_is_text_and_no_formula(plot, texts):
    assert "a $flat$ <line>" in texts(plot.to_svg())
    assert repr(plot) == "Flat('a $flat$ <line>')"
    assert plot._repr_svg_() == plot.to_svg()


def test_rounding_errors_are_not_shown_as_motion(plot):
    plot.to_svg()
    for axes in plot.axes:
        low, high = axes.get_ylim()
        assert high - low >= LEAST_HEIGHT * 0.999


@pytest.mark.parametrize("suffix", [".svg", ".png", ".pdf"])
def test_it_is_saved_by_its_suffix_with_the_same_bytes_each_time(plot, tmp_path, suffix):
    plot.save(tmp_path / f"a{suffix}")
    with matplotlib.rc_context({"font.size": 30}):
        plot.save(tmp_path / f"b{suffix}")
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()


def test_another_suffix_is_refused(plot, tmp_path):
    with pytest.raises(UnknownNameError, match=r"\.jpg"):
        plot.save(tmp_path / "a.jpg")


def test_more_panels_make_a_higher_picture():
    heights = []
    for count in (1, 3):
        figure, axes = panels("t", [1] * count)
        assert len(axes) == count
        heights.append(figure.get_figheight())
    assert heights[1] > 2 * heights[0]


def test_a_png_can_be_read(plot):
    assert matplotlib.image.imread(io.BytesIO(plot.to_png()), format="png").ndim == 3


def test_colours_begin_again_after_the_last():
    colors = [line_color(number) for number in range(11)]
    assert len(set(colors)) == 10
    assert colors[10] == colors[0]


JOINTS, ODOMETRY = "sensor_msgs/JointState", "nav_msgs/Odometry"


class Recording:
    """Topics with so many messages of a type."""

    def __init__(self, **counts):
        self._counts = {
            f"/{name}": (message_class(type_name), n) for name, (type_name, n) in counts.items()
        }

    def topics(self):
        return sorted(self._counts)

    def __getitem__(self, topic):
        cls, count = self._counts[topic]
        return [(Time(100 + number), cls()) for number in range(count)]


@pytest.fixture
def recording():
    return Recording(
        joint_states=(JOINTS, 2), odom=(ODOMETRY, 1), truth=(ODOMETRY, 1), late=(JOINTS, 0)
    )


def test_the_only_topic_of_a_type_needs_no_name(recording):
    assert recorded_topic(recording, JOINTS, None) == "/joint_states"


def test_of_several_one_must_be_chosen(recording):
    with pytest.raises(SimkitError, match="/odom, /truth were recorded: say which"):
        recorded_topic(recording, ODOMETRY, None)
    assert recorded_topic(recording, ODOMETRY, "odom") == "/odom"
    assert topics_of(recording, ODOMETRY) == ["/odom", "/truth"]


def test_what_cannot_be_plotted_is_told(recording):
    with pytest.raises(UnknownNameError, match="/odm"):
        recorded_topic(recording, ODOMETRY, "/odm")
    with pytest.raises(SimkitError, match="/odom carries nav_msgs/Odometry, and this plot shows"):
        recorded_topic(recording, JOINTS, "/odom")
    with pytest.raises(SimkitError, match="no message on /late was recorded"):
        recorded_topic(recording, JOINTS, "/late")
    with pytest.raises(SimkitError, match="no message of nav_msgs/Path was recorded, but /joint"):
        recorded_topic(recording, "nav_msgs/Path", None)
    with pytest.raises(SimkitError, match="was recorded, but nothing"):
        recorded_topic(Recording(), JOINTS, None)


def test_the_time_of_a_message_is_that_of_its_header_or_of_its_arrival(recording):
    assert [time for time, _ in timed(recording, "/joint_states")] == [100 * 10**9, 101 * 10**9]
    ((_, message),) = recording["/odom"]
    message.header.stamp = Time(7)
    one = Recording(odom=(ODOMETRY, 1))
    one.__class__ = type("Fixed", (Recording,), {"__getitem__": lambda *_: [(Time(9), message)]})
    assert [time for time, _ in timed(one, "/odom")] == [7 * 10**9]
