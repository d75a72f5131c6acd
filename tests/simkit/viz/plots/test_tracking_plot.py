from __future__ import annotations

import pytest

from simkit import Simulation
from simkit.errors import SimkitError, UnknownNameError
from simkit.msgs import Duration, message_class

TYPE = "control_msgs/JointTrajectoryControllerState"


@pytest.fixture
def sim():
    with Simulation(screen=None) as sim:
        yield sim


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


def test_joints_can_be_chosen(sim, recording):
    plot = sim.tracking_plot(recording, joints=["hip"])
    assert list(plot.joints) == ["hip"]
    assert plot.title.endswith("greatest error 0")
    with pytest.raises(UnknownNameError, match="knee"):
        sim.tracking_plot(recording, joints=["knee"])


def test_without_a_controller_there_is_nothing_to_plot(sim):
    with pytest.raises(SimkitError, match=f"no message of {TYPE}"):
        sim.tracking_plot(sim.record({"/arm_controller/state": TYPE}))
