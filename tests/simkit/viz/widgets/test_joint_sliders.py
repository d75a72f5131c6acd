from __future__ import annotations

import gc
import math
import sys
import weakref

import pytest

from simkit import SimkitError, Simulation, UnknownNameError
from simkit.viz import JointSliders
from simkit.viz.widgets import panel
from simkit.viz.widgets.kernel_loop import KernelLoop

ROBOT = """<robot name="r"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>
<joint name="hip" type="continuous"><parent link="a"/><child link="b"/></joint>
<joint name="elbow" type="revolute"><parent link="b"/><child link="c"/>
  <limit lower="-1" upper="2" effort="1" velocity="1"/></joint>
<joint name="lift&lt;" type="prismatic"><parent link="c"/><child link="d"/>
  <limit lower="0" upper="0.5" effort="1" velocity="1"/></joint></robot>"""
START = ("joint_state_publisher_gui", "joint_state_publisher_gui")


@pytest.fixture
def sim():
    with Simulation(seed=1, screen=None) as sim:
        sim.params.set("/robot_description", ROBOT)
        sim.rosrun(*START)
        yield sim


@pytest.fixture
def sliders(sim):
    return sim.joint_sliders()


def shown(sliders):
    """What the script is told of each joint."""
    return {joint["name"]: joint for joint in sliders.state()["joints"]}


class Waiting:
    """Work that waits until it is told to go on."""

    def __init__(self):
        self.work = []
        self.settle = []

    def soon(self, work):
        self.work.append(work)

    def after(self, seconds, work):
        self.settle.append((seconds, work))


def told(sim):
    latest = sim.latest("/joint_states")
    return dict(zip(latest.name, latest.position, strict=True))


def test_a_slider_for_each_joint_with_its_range_and_its_unit(sliders):
    state = sliders.state()
    assert state["title"] == "Node: /joint_state_publisher_gui"
    assert [(one["lower"], one["upper"], one["words"]) for one in state["joints"]] == [
        (-math.pi, math.pi, "rad = 0.0°"),
        (-1.0, 2.0, "rad = 0.0°"),
        (0.0, 0.5, "m"),
    ]
    assert state["buttons"] == ["Randomize", "Center"]
    assert state["message"] == ""


def test_a_move_moves_the_joint_and_time(sim, sliders):
    begin = sim.now
    sliders.hear({"move": "hip", "to": 0.5})
    assert told(sim)["hip"] == 0.5
    assert (sim.now - begin).to_sec() == pytest.approx(0.1)
    assert shown(sliders)["hip"]["words"] == "rad = 28.6°"


def test_the_picture_beside_the_sliders_follows_and_has_words(sim):
    waiting = Waiting()
    drawn = []
    sliders = JointSliders(
        sim.joint_sliders().gui,
        run=sim.run,
        later=waiting,
        picture=lambda: drawn.append(1) or b"PNG",
    )
    assert sliders.widget.picture["words"].startswith("The robot with hip 0.000 rad")
    sliders.hear({"move": "hip", "to": 0.5})
    assert len(drawn) == 1
    (seconds, draw), *_ = waiting.settle
    assert seconds == pytest.approx(0.1)
    draw()
    assert sliders.widget.picture["words"].startswith("The robot with hip 0.500 rad")


def test_the_buttons_do_what_the_program_does(sim, sliders):
    sliders.hear({"move": "hip", "to": 0.5})
    sliders.hear({"press": "Randomize"})
    drawn = told(sim)
    assert drawn["hip"] == shown(sliders)["hip"]["value"] != 0.5
    sliders.hear({"press": "Center"})
    assert told(sim)["hip"] == shown(sliders)["hip"]["value"] == 0.0
    assert [record.text for record in sim.log][-2:] == ["Randomizing", "Centering"]


def test_moves_from_elsewhere_move_the_sliders(sim, sliders):
    sim.joint_sliders().gui.set_position("elbow", 1.25)
    sim.run(0.1)
    assert shown(sliders)["elbow"]["value"] == 1.25
    assert shown(sliders)["elbow"]["words"] == "rad = 71.6°"
    assert told(sim)["elbow"] == 1.25


def test_a_source_beyond_the_range_is_shown_at_the_end_and_kept_as_it_is(sim):
    sim.params.set("/source_list", ["moves"])
    sim.rosrun(*START)
    sliders = sim.joint_sliders()
    for position, place in ((5.0, 2.0), (math.nan, 2.0)):
        publisher = sim.rostopic_pub(
            "/moves", "sensor_msgs/JointState", {"name": ["elbow"], "position": [position]}
        )
        sim.run(0.2)
        publisher.shutdown()
        assert shown(sliders)["elbow"]["value"] == place
        assert told(sim)["elbow"] == pytest.approx(position, nan_ok=True)


def test_moves_that_come_faster_than_they_can_be_shown_are_one_run(sim):
    waiting, ran = Waiting(), []
    gui = sim.joint_sliders().gui
    sliders = JointSliders(gui, run=ran.append, later=waiting)
    for step in range(1, 50):
        sliders.hear({"move": "hip", "to": step / 100})
    assert gui.joints[0].position == 0.49
    assert ran == []
    (advance,) = waiting.work
    advance()
    assert ran == [0.1]
    ((seconds, settle),) = waiting.settle
    assert seconds == pytest.approx(0.1)
    settle()
    assert ran == [0.1, 0.0]
    sliders.hear({"move": "hip", "to": 0.0})
    settle()
    assert ran == [0.1, 0.0]
    assert len(waiting.work) == 2


def test_what_cannot_be_done_is_said_below_the_sliders(sim):
    def refuse(_):
        raise SimkitError("time stands still")

    sliders = JointSliders(sim.joint_sliders().gui, run=refuse, later=KernelLoop())
    sliders.hear({"move": "hip", "to": 0.5})
    assert sliders.state()["message"] == "time stands still"


def test_when_the_node_ends_so_do_the_sliders(sim, sliders):
    sim.graph.nodes["/joint_state_publisher_gui"].shutdown()
    sim.run(0.1)
    assert sliders.state()["message"] == "/joint_state_publisher_gui has ended"
    assert sliders.state()["disabled"]
    with pytest.raises(SimkitError, match="no joint_state_publisher_gui runs"):
        sim.joint_sliders()


def test_widgets_do_not_keep_a_simulation_alive():
    sim = Simulation(screen=None)
    sim.params.set("/robot_description", ROBOT)
    sim.rosrun(*START)
    sliders = sim.joint_sliders()
    assert sliders.widget
    gone = weakref.ref(sim)
    sim.close()
    sliders.hear({"move": "hip", "to": 0.1})
    assert "this simulation is closed" in sliders.state()["message"]
    del sim
    gc.collect()
    assert gone() is None
    sliders.hear({"move": "hip", "to": 0.2})
    assert "this simulation is gone" in sliders.state()["message"]


def test_each_program_has_one_set_of_sliders_and_the_newest_is_meant(sim):
    first = sim.joint_sliders()
    sim.rosrun(*START, "__name:=other")
    assert sim.joint_sliders().title == "Node: /other"
    assert sim.joint_sliders("/joint_state_publisher_gui") is first
    with pytest.raises(SimkitError, match="no joint_state_publisher_gui runs as /nobody"):
        sim.joint_sliders("/nobody")


def test_a_robot_that_does_not_move_has_no_sliders(sim):
    sim.params.set("/robot_description", '<robot name="r"><link name="a"/></robot>')
    sim.rosrun(*START)
    sliders = sim.joint_sliders()
    assert sliders.state()["joints"] == []
    assert repr(sliders).splitlines()[1:] == [
        "  no joint moves",
        "  This robot has no joint to move.",
    ]


def test_without_a_notebook_there_is_a_table_and_a_line_of_python(sim):
    sliders = sim.joint_sliders()
    sliders.set_position("hip", 0.5)
    assert told(sim)["hip"] == 0.5
    text = repr(sliders).splitlines()
    assert text[0] == "Node: /joint_state_publisher_gui"
    assert text[1].split() == ["hip", "0.500", "rad", "=", "28.6°"]
    assert text[-1].strip() == 'From Python: sim.joint_sliders().set_position("hip", 0.5)'
    text = sliders._repr_html_()
    assert "<th>hip</th><td>0.500 rad = 28.6°</td>" in text
    assert "<th>lift&lt;</th>" in text
    assert '<img alt="The robot with hip 0.500 rad' in text
    with pytest.raises(NotImplementedError):
        sliders._ipython_display_()  # so that IPython shows the text
    with pytest.raises(UnknownNameError):
        sliders.set_position("hop", 0.5)


def test_in_a_notebook_there_are_widgets_and_behind_them_a_still_for_later(sim, notebook):
    sliders = sim.joint_sliders()
    sliders._ipython_display_()
    view, still = notebook.shown
    assert view["application/vnd.jupyter.widget-view+json"]["model_id"] == sliders.widget.model_id
    assert sliders._repr_html_() in still["text/html"]
    assert still["image/png"] in still["text/html"]
    notebook.end_cell()
    assert notebook.updates == []
    sliders.set_position("hip", 0.25)
    notebook.end_cell()
    (update,) = notebook.updates
    assert "0.250 rad" in update["text/html"]
    assert update["text/plain"] == repr(sliders)


def test_without_anywidget_a_notebook_shows_the_table(sim, notebook, monkeypatch):
    monkeypatch.setitem(sys.modules, "anywidget", None)
    panel._front_class.cache_clear()
    sliders = sim.joint_sliders()
    sliders._ipython_display_()
    (still,) = notebook.shown
    assert sliders._repr_html_() in still["text/html"]
    with pytest.raises(SimkitError, match="pip install anywidget"):
        assert sliders.widget


def test_the_line_of_python_names_a_position_that_the_slider_has(sim):
    joint = '<joint name="hip" type="revolute"><parent link="a"/><child link="b"/>{}</joint>'
    limit = '<limit lower="0.00001" upper="0.00004" effort="1" velocity="1"/>'
    sim.params.set(
        "/robot_description",
        f'<robot name="r"><link name="a"/><link name="b"/>{joint.format(limit)}</robot>',
    )
    sim.rosrun(*START)
    sliders = sim.joint_sliders()
    _, _, value = repr(sliders).rpartition(", ")
    sliders.set_position("hip", float(value.rstrip(")")))
