"""The flat names of a simulation: each is the method of a part, with its signature and its docstring."""

from __future__ import annotations

import inspect
import pydoc

import pytest

from simkit import Simulation

FLAT = {
    name: method
    for name, method in vars(Simulation).items()
    if inspect.isfunction(method) and hasattr(method, "__wrapped__")
}


@pytest.mark.parametrize("name", FLAT)
def test_a_flat_name_is_the_method_of_that_name_of_a_part(name):
    of_part = FLAT[name].__wrapped__
    assert of_part.__name__ == name
    assert FLAT[name].__doc__ == of_part.__doc__
    assert (
        list(inspect.signature(FLAT[name]).parameters)[1:]
        == list(inspect.signature(of_part).parameters)[1:]
    )


def test_help_tells_arguments_and_what_they_mean(sim):
    text = pydoc.plain(pydoc.render_doc(sim.rviz))
    assert "rviz(fixed_frame: 'str' = 'world'" in text
    assert "Frame that stands still" in text


def test_the_names_that_notebooks_use_are_there():
    names = (
        "call gzclient gzclient_replay joint_plot joint_sliders latest launch_plan path_plot record record_model record_world "
        "roslaunch rosrun rostopic_pub rviz rviz_replay services spawn teleop tf_echo tf_plot topics tracking_plot "
        "trajectory_sliders turtlesim view_frames wait_for_message gazebo world has_world now run run_until step nodes log "
        "params tf graph packages close closed"
    )
    sim = Simulation(screen=None)
    missing = [name for name in names.split() if name not in dir(sim)]
    sim.close()
    assert missing == []


def test_a_dropped_simulation_is_forgotten_at_once_though_its_parts_know_it():
    import weakref

    sim = Simulation(screen=None)
    seen = weakref.ref(sim)
    del sim
    assert seen() is None


def test_a_plot_of_a_transform_over_time(sim):
    sim.rosrun("tf", "static_transform_publisher", "1", "2", "3", "0", "0", "0", "a", "b", "100")
    sim.run(1.0)
    plot = sim.tf_plot("a", "b")
    assert "<svg" in plot._repr_svg_()
