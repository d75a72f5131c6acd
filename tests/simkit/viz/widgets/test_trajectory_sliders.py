from __future__ import annotations

import math

import pytest

from simkit import SimkitError, Simulation, UnknownNameError
from simkit.msgs import message_class
from simkit.viz import TrajectorySliders, controlled_joints
from simkit.viz.widgets.trajectory_sliders import REST

ROBOT = """<robot name="r"><link name="a"/><link name="b"/><link name="c"/>
<joint name="hip" type="continuous"><parent link="a"/><child link="b"/></joint>
<joint name="elbow" type="revolute"><parent link="b"/><child link="c"/>
  <limit lower="-1" upper="2" effort="1" velocity="1"/></joint></robot>"""
STATE = "control_msgs/JointTrajectoryControllerState"


class Controller:
    """Is at once where it is told to be, and tells so."""

    def __init__(self, sim):
        self.goals = []
        node = sim.graph.create_node("/gazebo")
        self._state = node.advertise("/arm_controller/state", message_class(STATE))
        node.subscribe(
            "/arm_controller/command", message_class("trajectory_msgs/JointTrajectory"), self._hear
        )

    def tell(self, names, positions):
        state = message_class(STATE)(joint_names=names)
        state.actual.positions = positions
        self._state.publish(state)

    def _hear(self, goal):
        self.goals.append(goal)
        self.tell(goal.joint_names, goal.points[0].positions)


class Waiting:
    """Work that waits until it is told to go on."""

    def __init__(self):
        self.work = []

    def soon(self, work):
        self.work.append(work)

    def go(self):
        work, self.work = self.work, []
        for one in work:
            one()


@pytest.fixture
def sim():
    with Simulation(screen=None) as sim:
        sim.params.set("/robot_description", ROBOT)
        sim.params.set("/arm_controller/joints", ["hip", "elbow"])
        yield sim


@pytest.fixture
def controller(sim):
    return Controller(sim)


@pytest.fixture
def waiting():
    return Waiting()


@pytest.fixture
def sliders(sim, waiting):
    return TrajectorySliders(
        sim.graph.create_node("/sliders"),
        "/arm_controller",
        controlled_joints(sim.graph, "/arm_controller"),
        duration=0.5,
        run=sim.run,
        later=waiting,
    )


def joints(sliders):
    """What the script is told of each joint."""
    return {joint["name"]: joint for joint in sliders.state()["joints"]}


def test_a_move_is_one_goal_of_all_joints_and_takes_its_time(sim, controller):
    sliders = sim.trajectory_sliders(duration=2.0)
    begin = sim.now
    sliders.move({"elbow": 0.5})
    (goal,) = controller.goals
    assert goal.joint_names == ["hip", "elbow"]
    (point,) = goal.points
    assert list(point.positions) == [0.0, 0.5]
    assert point.time_from_start.to_sec() == 2.0
    assert goal.header.stamp.to_nsec() == 0  # at once
    assert (sim.now - begin).to_sec() == pytest.approx(2.0 + REST)
    sliders.move({"hip": -0.25}, duration=0.25)
    assert list(controller.goals[1].points[0].positions) == [-0.25, 0.5]
    assert (sim.now - begin).to_sec() == pytest.approx(2.25 + 2 * REST)
    assert sliders.goal == {"hip": -0.25, "elbow": 0.5}


@pytest.mark.parametrize("topic", ["/arm_controller/state", "/joint_states"])
def test_sliders_begin_where_the_joints_are(sim, topic):
    node = sim.graph.create_node("/gazebo")
    if topic == "/joint_states":
        message = message_class("sensor_msgs/JointState")(
            name=["elbow", "hip", "wheel"], position=[9.0, 0.3, 7.0]
        )
    else:
        message = message_class(STATE)(joint_names=["elbow", "hip"])
        message.actual.positions = [9.0, 0.3]
    node.advertise(topic, type(message)).publish(message)
    assert sim.trajectory_sliders("arm_controller").goal == {"hip": 0.3, "elbow": 2.0}


def test_what_cannot_be_reached_is_refused_and_nothing_is_sent(sim, controller):
    sliders = sim.trajectory_sliders()
    with pytest.raises(SimkitError, match=r"elbow goes from -1 to 2 rad, not to 2\.5"):
        sliders.move({"hip": 0.1, "elbow": 2.5})
    with pytest.raises(UnknownNameError, match="hipp"):
        sliders.move({"hipp": 0.1})
    for duration in (0.0, -1.0, 1e9, math.nan):
        with pytest.raises(SimkitError, match=r"a motion takes from 0\.01 to 60 s"):
            sliders.move({"hip": 0.1}, duration=duration)
    sim.run(0.1)
    assert controller.goals == []
    assert sliders.goal == {"hip": 0.0, "elbow": 0.0}


def test_a_slider_has_the_range_of_its_joint(sliders):
    assert sliders.state()["title"] == "Controller: /arm_controller"
    ranges = {name: (one["lower"], one["upper"]) for name, one in joints(sliders).items()}
    assert ranges == {"hip": (-math.pi, math.pi), "elbow": (-1.0, 2.0)}


def test_a_slider_that_is_moved_sends_one_goal_when_no_cell_runs(sim, controller, sliders, waiting):
    begin = sim.now
    sliders.hear({"move": "hip", "to": 0.5})
    sliders.hear({"move": "elbow", "to": 1})
    assert controller.goals == []
    waiting.go()
    (goal,) = controller.goals
    assert list(goal.points[0].positions) == [0.5, 1.0]
    assert (sim.now - begin).to_sec() == pytest.approx(0.5 + REST)
    assert joints(sliders)["elbow"]["words"] == "rad, is at 1.000"
    sliders.hear({"duration": 1.5})
    sliders.hear({"press": "All to zero"})
    waiting.go()
    assert list(controller.goals[1].points[0].positions) == [0.0, 0.0]
    assert (sim.now - begin).to_sec() == pytest.approx(2.0 + 2 * REST)
    assert joints(sliders)["hip"]["value"] == 0.0


def test_a_duration_that_makes_no_sense_is_refused_below_the_sliders(sliders):
    sliders.hear({"duration": 0})
    assert "a motion takes from 0.01 to 60 s" in sliders.state()["message"]
    assert sliders.state()["duration"] == 0.5


def test_without_a_controller_that_listens_the_window_says_so(sliders, waiting):
    sliders.hear({"move": "hip", "to": 0.5})
    waiting.go()
    assert sliders.state()["message"] == (
        "No node listens to /arm_controller/command: is the controller loaded and started?"
    )


def test_an_end_of_the_simulation_is_told(sim, controller, sliders, waiting):
    sim.close()
    sliders.hear({"move": "hip", "to": 0.5})
    waiting.go()
    assert "this simulation is closed" in sliders.state()["message"]


def test_without_a_kernel_it_is_a_text(sim, controller):
    sliders = sim.trajectory_sliders()
    sliders.move({"hip": 0.5})
    assert "hip  goal 0.500 rad, is at 0.500" in repr(sliders)
    assert "elbow  goal 0.000 rad" in sliders._repr_html_()
