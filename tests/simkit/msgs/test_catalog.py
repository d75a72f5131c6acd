from __future__ import annotations

import pytest

from simkit.errors import UnknownNameError
from simkit.msgs import message_class, message_types, packages, service_class, service_types
from simkit.msgs.catalog import DEFINITIONS


def test_the_packages_of_the_course_are_there():
    assert {
        "actionlib_msgs",
        "control_msgs",
        "gazebo_msgs",
        "geometry_msgs",
        "nav_msgs",
        "rosgraph_msgs",
        "sensor_msgs",
        "std_msgs",
        "std_srvs",
        "tf2_msgs",
        "trajectory_msgs",
        "turtlesim",
        "visualization_msgs",
    } <= set(packages())


def test_names_are_sorted_and_found():
    assert message_types() == sorted(message_types())
    assert "geometry_msgs/Twist" in message_types()
    assert "turtlesim/Spawn" in service_types()


def test_every_file_is_served():
    files = {path.stem for path in DEFINITIONS.glob("*/*/*")}
    served = {name.split("/")[1] for name in (*message_types(), *service_types())}
    assert {stem for stem in files if stem not in served} <= {
        path.stem for path in DEFINITIONS.glob("*/action/*")
    }


def test_an_action_gives_seven_messages():
    prefix = "control_msgs/FollowJointTrajectory"
    names = {name for name in message_types() if name.startswith(prefix)}
    assert names == {
        prefix + suffix
        for suffix in (
            "Action",
            "ActionFeedback",
            "ActionGoal",
            "ActionResult",
            "Feedback",
            "Goal",
            "Result",
        )
    }
    action = message_class(f"{prefix}ActionGoal")
    assert action.__slots__ == ["header", "goal_id", "goal"]
    assert message_class(f"{prefix}Result").PATH_TOLERANCE_VIOLATED == -4


@pytest.mark.parametrize(
    "name",
    [
        "geometry_msgs/Twst",
        "geometry_msgs/twist",
        "Twist",
        "",
        "../catalog",
        "a/b/c",
        "/",
        "turtlesim/Spawn",
    ],
)
def test_unknown_message(name):
    with pytest.raises(UnknownNameError, match="no message type"):
        message_class(name)


def test_near_names_are_given():
    with pytest.raises(UnknownNameError, match="did you mean 'geometry_msgs/Twist'"):
        message_class("geometry_msgs/Twst")
    with pytest.raises(UnknownNameError, match=r"no service type .*did you mean 'turtlesim/Spawn'"):
        service_class("turtlesim/Span")
