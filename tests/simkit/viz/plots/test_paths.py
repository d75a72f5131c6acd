from __future__ import annotations

import math

import pytest

from simkit import Simulation
from simkit.errors import SimkitError, UnknownNameError
from simkit.msgs import Time, message_class
from simkit.viz import PathPlot
from simkit.viz.plots.paths import end_error, laid_on, path_series, path_within


class Ways:
    """Odometry of robots that drive a quarter of a circle with a radius of 2 m in 1 s."""

    def __init__(self):
        self._messages = {}

    def drive(self, topic, *, rate, x=0.0, y=0.0, yaw=0.0, radius=2.0, begin=0.0):
        cls, found = message_class("nav_msgs/Odometry"), []
        for step in range(rate + 1):
            angle = math.pi / 2 * step / rate
            ahead, aside = radius * math.sin(angle), radius * (1 - math.cos(angle))
            message = cls()
            message.header.frame_id = "odom"
            message.header.stamp = Time.from_nsec(round(1e9 * (100 + begin + step / rate)))
            message.pose.pose.position.x = x + ahead * math.cos(yaw) - aside * math.sin(yaw)
            message.pose.pose.position.y = y + ahead * math.sin(yaw) + aside * math.cos(yaw)
            message.pose.pose.orientation.z = math.sin((yaw + angle) / 2)
            message.pose.pose.orientation.w = math.cos((yaw + angle) / 2)
            found.append((message.header.stamp, message))
        self._messages[topic] = found
        return self

    def topics(self):
        return sorted(self._messages)

    def __getitem__(self, topic):
        return self._messages[topic]


@pytest.fixture
def ways():
    return Ways().drive("/odom", rate=20)


def test_the_series_is_what_odometry_told(ways):
    path = path_series(ways, "/odom")
    assert (path.x[-1], path.y[-1], path.yaw[-1]) == pytest.approx((2, 2, math.pi / 2))
    assert path.frame == "odom"
    assert path.at(path.times[3]) == pytest.approx((path.x[3], path.y[3], path.yaw[3]))
    assert path.at(0) == (path.x[0], path.y[0], path.yaw[0])
    assert path.at(10**18) == (path.x[-1], path.y[-1], path.yaw[-1])


def test_between_two_poses_it_is_straight_and_turns_the_short_way():
    path = path_series(Ways().drive("/odom", rate=1, yaw=math.pi * 0.75), "/odom")
    start, end = ((path.x[i], path.y[i]) for i in (0, 1))
    x, y, yaw = path.at(path.times[0] + 5 * 10**8)
    assert (x, y) == pytest.approx(((start[0] + end[0]) / 2, (start[1] + end[1]) / 2))
    assert math.remainder(yaw - math.pi, math.tau) == pytest.approx(0.0)


def test_a_way_is_laid_on_another_wherever_the_robot_stood(ways):
    true = path_series(Ways().drive("/t", rate=200, x=5, y=-3, yaw=2.0), "/t")
    path = path_series(ways, "/odom")
    assert end_error(path, true) > 4
    laid = laid_on(true, path)
    assert (laid.x[-1], laid.y[-1]) == pytest.approx((2, 2))
    assert math.remainder(laid.yaw[-1] - math.pi / 2, math.tau) == pytest.approx(0.0, abs=1e-9)
    assert end_error(path, laid) == pytest.approx(0.0, abs=1e-9)


def test_a_true_way_is_cut_to_the_time_of_the_others(ways):
    true = path_series(Ways().drive("/t", rate=100), "/t")
    short = path_series(Ways().drive("/odom", rate=10, begin=0.455), "/odom")
    cut = path_within(true, [short])
    assert cut.times[0] <= short.times[0] < cut.times[1]
    assert cut.times[-1] == true.times[-1]


def test_the_title_says_how_far_off_it_ends(ways, texts):
    truth = Ways().drive("/car/pose", rate=100, x=1, yaw=1.0, radius=2.5)
    plot = PathPlot(ways, truth=truth)
    assert plot.title == f"way of /odom: ends {math.hypot(0.5, 0.5):.3g} m from the true one"
    shown = texts(plot.to_svg())
    assert {"/odom", "true", "x [m] in odom", "y [m]", plot.title} < set(shown)


def test_without_alignment_the_ways_are_where_they_were_told(ways):
    truth = Ways().drive("/car/pose", rate=100, x=1)
    assert PathPlot(ways, truth=truth, align=False).truth.x[0] == pytest.approx(1)
    assert PathPlot(ways, truth=truth).truth.x[0] == pytest.approx(0)


def test_the_truth_may_be_another_topic_of_the_recording(ways):
    ways.drive("/ground_truth", rate=50)
    plot = PathPlot(ways, truth="/ground_truth")
    assert [path.name for path in plot.paths] == ["/odom"]
    assert plot.truth.name == "/ground_truth"
    assert [path.name for path in PathPlot(ways).paths] == ["/ground_truth", "/odom"]
    assert PathPlot(ways).truth is None
    assert [path.name for path in PathPlot(ways, topics=["odom"]).paths] == ["/odom"]


def test_what_is_not_there_is_told(ways):
    with pytest.raises(UnknownNameError, match="/odm"):
        PathPlot(ways, topics=["/odm"])
    with pytest.raises(SimkitError, match="the true way is to have one topic"):
        PathPlot(ways, truth=Ways())
    with Simulation(screen=None) as sim, pytest.raises(SimkitError, match="no message of nav_msgs"):
        sim.path_plot(sim.record({"/odom": "nav_msgs/Odometry"}))
