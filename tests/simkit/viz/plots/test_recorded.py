from __future__ import annotations

import pytest

from simkit.errors import SimkitError, UnknownNameError
from simkit.msgs import Time, message_class
from simkit.viz.plots.recorded import recorded_topic, timed, topics_of

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
