from __future__ import annotations

import math

import pytest

from simkit import Simulation
from simkit.errors import SimkitError, UnknownNameError
from simkit.msgs import Duration, Time, message_class


@pytest.fixture
def sim():
    with Simulation(screen=None) as sim:
        yield sim


@pytest.fixture
def swing(sim):
    """Publishes joints that swing; what is told besides the position may be chosen."""

    def swing(*told, names=("hip", "elbow"), topic="/joint_states"):
        node = sim.graph.create_node("/swing")
        publisher = node.advertise(topic, message_class("sensor_msgs/JointState"))
        begin = sim.now.to_nsec()

        def say():
            t = (sim.now.to_nsec() - begin) / 1e9
            message = message_class("sensor_msgs/JointState")(
                name=list(names), position=[math.sin(t), 2 * t]
            )
            message.header.stamp = sim.now
            if "velocity" in told:
                message.velocity = [math.cos(t), 2.0]
            if "effort" in told:
                message.effort = [0.5, -0.5]
            publisher.publish(message)

        node.create_timer(Duration.from_sec(0.1), say)
        return sim.record([topic])

    return swing


def test_the_series_is_what_was_told(sim, swing):
    recording = swing("velocity", "effort")
    sim.run(1.05)
    series = sim.joint_plot(recording).series
    assert series.topic == "/joint_states"
    assert series.start == Time.from_nsec(1_600_088_400 * 10**9 + 10**8)
    assert sorted(series.position) == ["elbow", "hip"]
    assert [time for time, _ in series.position["hip"]] == pytest.approx(
        [number / 10 for number in range(10)]
    )
    assert [v for _, v in series.position["elbow"]] == pytest.approx(
        [2 * (number + 1) / 10 for number in range(10)]
    )
    assert {v for _, v in series.velocity["elbow"]} == {2.0}
    assert {v for _, v in series.effort["hip"]} == {0.5}


def test_there_is_a_panel_for_each_quantity_that_was_told(sim, swing, texts):
    recording = swing()
    sim.run(0.5)
    shown = texts(sim.joint_plot(recording).to_svg())
    assert {"joints on /joint_states", "hip", "elbow", "position [rad, m]"} < set(shown)
    assert not any("velocity" in text or "effort" in text for text in shown)
    with_efforts = swing("velocity", "effort", topic="/more")
    sim.run(0.5)
    shown = texts(sim.joint_plot(with_efforts).to_svg())
    assert {"position [rad, m]", "velocity [rad/s, m/s]", "effort [N m, N]"} < set(shown)
    assert shown.count("hip") == 1


def test_joints_can_be_chosen(sim, swing):
    recording = swing()
    sim.run(0.5)
    assert list(sim.joint_plot(recording, joints=["hip"]).series.position) == ["hip"]
    with pytest.raises(UnknownNameError, match="knee"):
        sim.joint_plot(recording, joints=["knee"])


def test_two_nodes_may_tell_of_different_joints(sim, swing):
    recording = swing()
    other = sim.graph.create_node("/other").advertise(
        "/joint_states", message_class("sensor_msgs/JointState")
    )
    sim.run(0.5)
    other.publish(message_class("sensor_msgs/JointState")(name=["wheel"], position=[1.0]))
    sim.run(0.5)
    series = sim.joint_plot(recording).series
    assert len(series.position["wheel"]) == 1
    assert len(series.position["hip"]) == 10


def test_odd_names_are_only_names(sim, swing, texts):
    recording = swing(names=("<b>$x_1$", "y" * 500))
    sim.run(0.3)
    svg = sim.joint_plot(recording).to_svg()
    assert max(map(len, texts(svg))) < 120
    assert "<b>" not in svg


def test_a_recording_without_joints_is_told(sim):
    with pytest.raises(SimkitError, match="no message of sensor_msgs/JointState was recorded"):
        sim.joint_plot(sim.record({"/joint_states": "sensor_msgs/JointState"}))


TYPE = "control_msgs/JointTrajectoryControllerState"


@pytest.fixture
def recording(sim):
    """A controller of two joints, whose second one lags behind."""
    node = sim.graph.create_node("/gazebo")
    publisher = node.advertise("/arm_controller/state", message_class(TYPE))
    begin = sim.now.to_nsec()

    def say():
        t = (sim.now.to_nsec() - begin) / 1e9
        state = message_class(TYPE)(joint_names=["hip", "elbow"])
        state.header.stamp = sim.now
        state.desired.positions = [t, 2 * t]
        state.actual.positions = [t, 2 * t - 0.25]
        state.error.positions = [0.0, 0.25]
        publisher.publish(state)

    node.create_timer(Duration.from_sec(0.1), say)
    recording = sim.record(["/arm_controller/state"])
    sim.run(1.05)
    return recording


def test_what_is_wanted_and_what_is(sim, recording):
    plot = sim.tracking_plot(recording)
    hip, elbow = plot.joints["hip"], plot.joints["elbow"]
    assert hip.seconds == pytest.approx([number / 10 for number in range(10)])
    assert hip.desired == hip.actual
    assert [d - a for d, a in zip(elbow.desired, elbow.actual, strict=True)] == pytest.approx(
        elbow.error
    )
    assert plot.title == "/arm_controller/state: greatest error 0.25"


def test_the_figure_says_what_it_shows(sim, recording, texts):
    shown = texts(sim.tracking_plot(recording).to_svg())
    assert {"hip", "elbow", "desired", "position [rad, m]", "error [rad, m]"} < set(shown)


def test_joints_of_a_controller_can_be_chosen(sim, recording):
    plot = sim.tracking_plot(recording, joints=["hip"])
    assert list(plot.joints) == ["hip"]
    assert plot.title.endswith("greatest error 0")
    with pytest.raises(UnknownNameError, match="knee"):
        sim.tracking_plot(recording, joints=["knee"])


def test_without_a_controller_there_is_nothing_to_plot(sim):
    with pytest.raises(SimkitError, match=f"no message of {TYPE}"):
        sim.tracking_plot(sim.record({"/arm_controller/state": TYPE}))
