from __future__ import annotations

import gc
import math
import sys
import weakref

import pytest

from simkit import SimkitError, Simulation, UnknownNameError
from simkit.viz import JointSliders
from simkit.viz.kernel_loop import KernelLoop

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


class Window:
    """The widgets of a box, by what a person sees."""

    def __init__(self, sliders):
        title, *rows, buttons, message = sliders.widget.children
        self.title = title.value
        self.sliders = {row.children[0].description: row.children[0] for row in rows}
        self.readouts = {row.children[0].description: row.children[1] for row in rows}
        self.buttons = {button.description: button for button in buttons.children}
        self.message = message


@pytest.fixture
def window(sim):
    return Window(sim.joint_sliders())


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


def test_a_slider_for_each_joint_with_its_range_and_its_unit(window):
    assert window.title == "Node: /joint_state_publisher_gui"
    assert [(s.min, s.max) for s in window.sliders.values()] == [
        (-math.pi, math.pi),
        (-1.0, 2.0),
        (0.0, 0.5),
    ]
    assert [readout.value for readout in window.readouts.values()] == [
        "rad = 0.0°",
        "rad = 0.0°",
        "m",
    ]
    assert list(window.buttons) == ["Randomize", "Center"]
    assert window.message.layout.display == "none"


def test_a_move_moves_the_joint_and_time(sim, window):
    begin = sim.now
    window.sliders["hip"].value = 0.5
    assert told(sim)["hip"] == 0.5
    assert (sim.now - begin).to_sec() == pytest.approx(0.1)
    assert window.readouts["hip"].value == "rad = 28.6°"


def test_a_browser_that_draws_a_slider_does_not_move_the_joint(sim, window):
    sim.joint_sliders().gui.set_position("hip", 0.5)
    sim.run(0.1)
    begin = sim.now
    step = window.sliders["hip"].step
    nearest = -math.pi + step * 580  # what JupyterLab reports as soon as the slider is on the page
    assert 0 < abs(nearest - 0.5) < step / 2
    window.sliders["hip"].value = nearest
    assert sim.now == begin
    assert window.readouts["hip"].value == "rad = 28.6°"
    sim.run(0.1)
    assert told(sim)["hip"] == 0.5
    window.sliders["hip"].value = nearest + step  # an arrow key
    assert told(sim)["hip"] == nearest + step
    window.sliders["hip"].value = nearest
    assert told(sim)["hip"] == nearest
    window.sliders["hip"].value = 0.501  # typed
    assert told(sim)["hip"] == 0.501


def test_the_buttons_do_what_the_program_does(sim, window):
    window.sliders["hip"].value = 0.5
    window.buttons["Randomize"].click()
    drawn = told(sim)
    assert drawn["hip"] == window.sliders["hip"].value != 0.5
    window.buttons["Center"].click()
    assert told(sim)["hip"] == window.sliders["hip"].value == 0.0
    assert [record.text for record in sim.log][-2:] == ["Randomizing", "Centering"]


def test_moves_from_elsewhere_move_the_sliders(sim, window):
    sim.joint_sliders().gui.set_position("elbow", 1.25)
    sim.run(0.1)
    assert window.sliders["elbow"].value == 1.25
    assert window.readouts["elbow"].value == "rad = 71.6°"
    assert told(sim)["elbow"] == 1.25


def test_a_source_beyond_the_range_is_shown_at_the_end_and_kept_as_it_is(sim):
    sim.params.set("/source_list", ["moves"])
    sim.rosrun(*START)
    window = Window(sim.joint_sliders())
    for position, shown in ((5.0, 2.0), (math.nan, 2.0)):
        publisher = sim.rostopic_pub(
            "/moves", "sensor_msgs/JointState", {"name": ["elbow"], "position": [position]}
        )
        sim.run(0.2)
        publisher.shutdown()
        assert window.sliders["elbow"].value == shown
        assert told(sim)["elbow"] == pytest.approx(position, nan_ok=True)


def test_moves_that_come_faster_than_they_can_be_shown_are_one_run(sim):
    waiting, ran = Waiting(), []
    gui = sim.joint_sliders().gui
    window = Window(JointSliders(gui, run=ran.append, later=waiting))
    for step in range(1, 50):
        window.sliders["hip"].value = step / 100
    assert gui.joints[0].position == 0.49
    assert ran == []
    (advance,) = waiting.work
    advance()
    assert ran == [0.1]
    ((seconds, settle),) = waiting.settle
    assert seconds == pytest.approx(0.1)
    settle()
    assert ran == [0.1, 0.0]
    window.sliders["hip"].value = 0.0
    settle()
    assert ran == [0.1, 0.0]
    assert len(waiting.work) == 2


def test_what_cannot_be_done_is_said_below_the_sliders(sim):
    def refuse(_):
        raise SimkitError("time stands still")

    window = Window(JointSliders(sim.joint_sliders().gui, run=refuse, later=KernelLoop()))
    window.sliders["hip"].value = 0.5
    assert (window.message.value, window.message.layout.display) == ("time stands still", None)


def test_when_the_node_ends_so_do_the_sliders(sim, window):
    sim.graph.nodes["/joint_state_publisher_gui"].shutdown()
    sim.run(0.1)
    assert window.message.value == "/joint_state_publisher_gui has ended"
    controls = (*window.sliders.values(), *window.buttons.values())
    assert all(control.disabled for control in controls)
    with pytest.raises(SimkitError, match="no joint_state_publisher_gui runs"):
        sim.joint_sliders()


def test_widgets_do_not_keep_a_simulation_alive():
    sim = Simulation(screen=None)
    sim.params.set("/robot_description", ROBOT)
    sim.rosrun(*START)
    sliders = sim.joint_sliders()
    window, gone = Window(sliders), weakref.ref(sim)
    sim.close()
    window.sliders["hip"].value = 0.1
    assert "this simulation is closed" in window.message.value
    del sim
    gc.collect()
    assert gone() is None
    window.sliders["hip"].value = 0.2
    assert "this simulation is gone" in window.message.value


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
    assert [child.value for child in sliders.widget.children[:2]] == [
        "Node: /joint_state_publisher_gui",
        "This robot has no joint to move.",
    ]
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
    notebook.end_cell()
    assert notebook.updates == []
    sliders.set_position("hip", 0.25)
    notebook.end_cell()
    (update,) = notebook.updates
    assert "0.250 rad" in update["text/html"]
    assert update["text/plain"] == repr(sliders)


def test_without_ipywidgets_a_notebook_shows_the_table(sim, notebook, monkeypatch):
    monkeypatch.setitem(sys.modules, "ipywidgets", None)
    sliders = sim.joint_sliders()
    sliders._ipython_display_()
    (still,) = notebook.shown
    assert sliders._repr_html_() in still["text/html"]
    with pytest.raises(SimkitError, match="pip install ipywidgets"):
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
