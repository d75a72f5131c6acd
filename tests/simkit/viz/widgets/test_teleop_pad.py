from __future__ import annotations

import gc
import weakref

import pytest

from simkit import SimkitError, Simulation, UnknownNameError
from simkit.viz.widgets.teleop_pad import TICK, TeleopPad


class Waiting:
    """Work that waits until it is told to go on."""

    def __init__(self):
        self.work = []
        self.later = []

    def soon(self, work):
        self.work.append(work)

    def after(self, seconds, work):
        self.later.append((seconds, work))

    def go(self):
        work, self.work = self.work, []
        for one in work:
            one()

    def wait(self):
        """What should happen later happens now; how long it should have waited."""
        later, self.later = self.later, []
        for _, work in later:
            work()
        return [seconds for seconds, _ in later]


@pytest.fixture
def sim():
    with Simulation(screen=None) as sim:
        yield sim


@pytest.fixture
def turtle(sim):
    sim.rosrun("turtlesim", "turtlesim_node")
    sim.run(0.1)
    return sim.turtlesim


@pytest.fixture
def waiting():
    return Waiting()


@pytest.fixture
def pad(sim, waiting):
    return TeleopPad(
        sim.graph.create_node("/pad"),
        "/turtle1/cmd_vel",
        linear=2.0,
        angular=1.5,
        step=0.25,
        run=sim.run,
        later=waiting,
    )


@pytest.fixture
def click(pad):
    """Does what the script of the pad does when a button is clicked."""
    return lambda key: pad.hear({"press": key})


def pose(sim):
    found = sim.latest("/turtle1/pose")
    return found.x, found.y, found.theta


@pytest.mark.parametrize(
    ("key", "linear", "angular"),
    [
        ("up", 0.5, 0.0),
        ("down", -0.5, 0.0),
        ("left", 0.0, 1.0),
        ("right", 0.0, -1.0),
        ("stop", 0.0, 0.0),
    ],
)
def test_a_key_publishes_its_velocity_once_and_takes_one_step(sim, key, linear, angular):
    recording = sim.record({"/cmd_vel": "geometry_msgs/Twist"})
    begin = sim.now
    sim.teleop().press(key)
    ((time, twist),) = recording["/cmd_vel"]
    assert time == begin
    assert (twist.linear.x, twist.angular.z) == (linear, angular)
    assert "-0.0" not in str(twist)
    assert (sim.now - begin).to_sec() == pytest.approx(0.2)


def test_a_turtle_is_driven(sim, turtle):
    pad = sim.teleop("turtle1/cmd_vel", 2.0, angular=2.0, step=0.5)
    x, y, theta = pose(sim)
    pad.press("up")
    assert pose(sim) == pytest.approx((x + 1.0, y, theta), abs=0.07)
    pad.press("left")
    assert pose(sim)[2] == pytest.approx(theta + 1.0, abs=0.07)


def test_a_key_that_is_none_is_refused(sim):
    with pytest.raises(UnknownNameError, match="upp"):
        sim.teleop().press("upp")


@pytest.mark.parametrize("wrong", [{"linear": -1}, {"angular": float("nan")}, {"step": 1e9}])
def test_numbers_that_make_no_sense_are_refused(sim, wrong):
    with pytest.raises(SimkitError, match="of a teleop pad is a number from 0 to 1000"):
        sim.teleop(**wrong)


def test_a_click_waits_until_no_cell_runs(sim, turtle, pad, click, waiting):
    begin, (x, _, _) = sim.now, pose(sim)
    click("up")
    assert sim.now == begin
    waiting.go()
    assert (sim.now - begin).to_sec() == pytest.approx(0.25)
    assert pose(sim)[0] == pytest.approx(x + 0.5, abs=0.07)
    assert pad.state()["message"] == ""


def test_of_clicks_that_come_too_fast_the_last_one_counts(sim, turtle, pad, click, waiting):
    recording = sim.record(["/turtle1/cmd_vel"])
    begin = sim.now
    for key in ("up", "left", "up", "down"):
        click(key)
    waiting.go()
    ((_, twist),) = recording["/turtle1/cmd_vel"]
    assert twist.linear.x == -2.0
    assert (sim.now - begin).to_sec() == pytest.approx(0.25)


def test_a_speed_that_makes_no_sense_is_refused_below_the_pad(pad):
    pad.hear({"linear": -1})
    assert "is a number from 0 to 1000" in pad.state()["message"]
    assert pad.state()["linear"] == 2.0


def test_speeds_can_be_set(sim, turtle, pad, click, waiting):
    recording = sim.record(["/turtle1/cmd_vel"])
    pad.hear({"linear": 0.7})
    pad.hear({"angular": 0.3})
    for key in ("up", "right"):
        click(key)
        waiting.go()
    said = [(twist.linear.x, twist.angular.z) for _, twist in recording["/turtle1/cmd_vel"]]
    assert said == [(0.7, 0.0), (0.0, -0.3)]
    assert "0 m/s, -0.3 rad/s" in pad.state()["lines"]


def test_while_run_is_on_time_passes_by_itself(sim, turtle, pad, click, waiting):
    begin = sim.now
    pad.hear({"run": True})
    waiting.go()
    assert pad.is_running
    click("up")
    waiting.go()  # a press takes no time of its own then
    assert (sim.now - begin).to_sec() == pytest.approx(TICK)
    for _ in range(4):
        assert waiting.wait() == [TICK]
    assert (sim.now - begin).to_sec() == pytest.approx(5 * TICK)
    pad.hear({"run": False})
    waiting.wait()
    assert (sim.now - begin).to_sec() == pytest.approx(5 * TICK)
    assert waiting.wait() == []


def test_on_and_off_and_on_again_runs_once(sim, turtle, pad, click, waiting):
    for value in (True, False, True):
        pad.hear({"run": value})
    waiting.go()
    begin = sim.now
    waiting.wait()
    assert (sim.now - begin).to_sec() == pytest.approx(TICK)


def test_who_drives_nobody_is_told_so(sim, turtle, waiting):
    pad = TeleopPad(
        sim.graph.create_node("/pad"),
        "/cmd_vel",
        linear=1,
        angular=1,
        step=0.1,
        run=sim.run,
        later=waiting,
    )
    pad.hear({"press": "up"})
    waiting.go()
    assert pad.state()["message"] == (
        "No node listens to /cmd_vel; topics of geometry_msgs/Twist with listeners: /turtle1/cmd_vel."
    )


def test_an_end_of_the_simulation_is_told_and_stops_the_time(sim, turtle, pad, click, waiting):
    pad.hear({"run": True})
    sim.close()
    waiting.go()
    assert "this simulation is closed" in pad.state()["message"]
    assert not pad.is_running


def test_the_picture_of_a_turtlesim_is_beside_the_buttons_and_follows(sim, turtle, waiting):
    pad = TeleopPad(
        sim.graph.create_node("/pad"),
        "/turtle1/cmd_vel",
        linear=2,
        angular=2,
        step=0.5,
        run=sim.run,
        later=waiting,
        view=turtle,
    )
    front = pad.widget
    before = front.picture["svg"]
    assert before.startswith("<svg")
    pad.hear({"press": "up"})
    waiting.go()
    assert waiting.wait() == [0.1]
    assert front.picture["svg"] != before
    assert pad._repr_html_().startswith(pad.picture()["svg"])


def test_a_live_view_is_beside_the_buttons(sim):
    view = sim.rviz(live=True)
    pad = sim.teleop(view=view)
    beside, _ = pad.widget.children
    assert beside.children == (view.widget,)


def test_without_a_kernel_it_is_a_text(sim, notebook):
    pad = sim.teleop("/turtle1/cmd_vel")
    assert "/turtle1/cmd_vel" in repr(pad)
    assert "pad.press(&#x27;up&#x27;)" in pad._repr_html_()
    pad._ipython_display_()
    view, still = notebook.shown
    assert "application/vnd.jupyter.widget-view+json" in view
    assert pad._repr_html_() in still["text/html"]


def test_a_pad_does_not_keep_its_simulation():
    sim = Simulation(screen=None)
    pad = sim.teleop()
    gone = weakref.ref(sim)
    sim.close()
    del sim
    gc.collect()
    assert gone() is None
    with pytest.raises(SimkitError, match="this simulation is gone"):
        pad.press("up")
