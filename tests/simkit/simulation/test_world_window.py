from __future__ import annotations

import inspect
import urllib.request
from dataclasses import fields
from pathlib import Path

import pytest

from simkit import Simulation
from simkit.errors import SimkitError
from simkit.nodes.gzclient import HINT
from simkit.viz import LiveWorld, WorldReplay, WorldSettings, WorldView

CAR = Path(__file__).resolve().parents[3] / "robots/gazebo_car/urdf/practice_car.urdf"


@pytest.fixture
def sim():
    with Simulation(screen=None) as sim:
        yield sim


@pytest.fixture
def car(sim):
    spawned = sim.spawn(CAR, name="car")
    sim.run(0.1)
    return spawned


@pytest.mark.parametrize("ask", ["gzclient", "record_world"])
def test_without_a_world_there_is_nothing_to_see(sim, ask):
    with pytest.raises(SimkitError, match=r"there is no world to see: .*sim\.gazebo"):
        getattr(sim, ask)()
    assert not sim.has_world


def test_gzclient_shows_the_world(sim, car):
    view = sim.gzclient("car", contacts=True, joints=True)
    assert isinstance(view, WorldView)
    assert view.scene.headline == "car, after 0.10 s"
    assert view.scene.marks[0].is_on
    assert view.problems == ()
    with pytest.raises(SimkitError, match="no model 'cat'"):
        sim.gzclient("cat")


def test_gzclient_takes_all_settings(sim):
    asked = inspect.signature(sim.gzclient).parameters
    assert {field.name for field in fields(WorldSettings)} == set(asked) - {"live"}
    defaults = {field.name: field.default for field in fields(WorldSettings)}
    assert defaults == {name: one.default for name, one in asked.items() if name != "live"}


def test_a_recording_is_played_again(sim, car):
    tape = sim.record_world(rate=20.0)
    sim.rostopic_pub("/cmd_vel", "geometry_msgs/Twist", "{linear: {x: 0.5}}", rate=10)
    sim.run(0.5)
    replay = sim.gzclient_replay(tape, trail="car", contacts=True, scans=False)
    assert isinstance(replay, WorldReplay)
    assert replay.tape.duration == pytest.approx(0.5)
    assert [one.marks.name for one in replay.tape.marks] == ["contacts", "trail-0"]
    assert tape.joint("car", "left_wheel_joint")[-1][1] > 0.5


def test_a_live_window_follows_until_the_simulation_ends(sim, car):
    live = sim.gzclient(live=True)
    assert isinstance(live, LiveWorld)
    with urllib.request.urlopen(live.url) as page:
        assert b"<title>Gazebo</title>" in page.read()
    before = live._live.state
    sim.gazebo.delete("car")
    sim.run(0.1)
    assert live._live.state.number == before.number + 1
    sim.close()
    assert not live.alive


def test_the_window_of_gzclient_that_was_run_alone_is_shown(sim, car):
    node = sim.rosrun("gazebo_ros", "gzclient")
    assert node.name == "/gazebo_gui_1"
    node.shutdown()
    assert isinstance(sim.window_of(node), WorldView)


def test_a_gzclient_that_goes_on_says_where_to_look(sim, car):
    node = sim.rosrun("gazebo_ros", "gzclient", "__name:=gazebo_gui")
    assert sim.window_of(node) is None
    sim.run(0.5)
    assert HINT in node.output


def test_in_a_terminal_gzclient_is_told_its_address(sim, car):
    node = sim.rosrun("gazebo_ros", "gzclient")
    live = sim.serve_window_of(node)
    assert live is not None
    assert live.url in node.output
    sim.run(0.5)
    assert HINT not in node.output
    node.shutdown()
    sim.run(0.1)
    assert not live.alive


def test_other_nodes_keep_their_windows(sim):
    node = sim.rosrun("rviz", "rviz")
    assert type(sim.window_of(node)).__name__ == "RvizView"
    mimic = sim.rosrun("turtlesim", "mimic")
    assert sim.window_of(mimic) is None
    assert sim.serve_window_of(mimic) is None
