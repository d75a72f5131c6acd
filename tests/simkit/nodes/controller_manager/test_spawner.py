"""spawner: it waits, loads, starts, and takes down; and says why there is nothing to wait for."""

from __future__ import annotations

import pytest

WAITED = [
    f"INFO Controller Spawner: Waiting for service controller_manager/{name}"
    for name in ("load_controller", "switch_controller", "unload_controller")
]
LOST = "WARN Controller Spawner couldn't find the expected controller_manager ROS interface."


def test_controllers_are_loaded_and_started(desk):
    manager = desk.manager()
    desk.start("spawner", "arm", "hand")
    desk.run(1.0)
    assert manager.asked == ["load arm", "load hand", "switch ['arm', 'hand'] [] 2"]
    assert desk.said() == [
        *WAITED,
        "INFO Loading controller: arm",
        "INFO Loading controller: hand",
        "INFO Controller Spawner: Loaded controllers: arm, hand",
        "INFO Started controllers: arm, hand",
    ]


def test_it_waits_for_a_manager_that_comes_later(desk):
    desk.start("spawner", "arm")
    desk.run(3.0)
    manager = desk.manager()
    desk.run(0.2)
    assert manager.states == {"arm": "running"}


def test_one_that_cannot_be_loaded_is_named_and_the_others_start(desk):
    manager = desk.manager()
    desk.start("spawner", "bad", "arm")
    desk.run(2.0)
    assert manager.states == {"arm": "running"}
    assert "ERROR Failed to load bad" in desk.said()
    assert desk.said()[-1] == "INFO Started controllers: arm"


def test_those_that_cannot_be_started_are_named(desk):
    manager = desk.manager()
    manager.switch_controller = lambda request, response: setattr(response, "ok", False)
    desk.start("spawner", "arm")
    desk.run(1.0)
    assert desk.said()[-1] == "ERROR Failed to start controllers: arm"


def test_with_stopped_they_are_loaded_only(desk):
    manager = desk.manager()
    desk.start("spawner", "--stopped", "arm")
    desk.run(1.0)
    assert manager.states == {"arm": "initialized"}


def test_a_namespace_says_where_the_manager_is(desk):
    manager = desk.manager("/left")
    desk.start("spawner", "--namespace", "/left", "arm")
    desk.run(1.0)
    assert manager.states == {"arm": "running"}
    assert desk.said()[0].endswith("/left/controller_manager/load_controller")


def test_the_nodes_own_namespace_counts(desk):
    manager = desk.manager("/left")
    desk.start("spawner", "arm", name="/left/spawner")
    desk.run(1.0)
    assert manager.states == {"arm": "running"}


def test_when_it_ends_it_stops_and_unloads_them_in_turn(desk):
    manager = desk.manager()
    desk.start("spawner", "arm", "hand")
    desk.run(1.0)
    del manager.asked[:]
    desk.shut_down()
    assert manager.asked == ["switch [] ['arm', 'hand'] 2", "unload hand", "unload arm"]
    assert manager.states == {}
    assert desk.said()[-7:] == [
        "INFO Shutting down spawner. Stopping and unloading controllers...",
        "INFO Stopping all controllers...",
        "INFO Unloading all loaded controllers...",
        "INFO Trying to unload hand",
        "INFO Succeeded in unloading hand",
        "INFO Trying to unload arm",
        "INFO Succeeded in unloading arm",
    ]


def test_when_it_ends_after_the_manager_it_says_so(desk):
    manager = desk.manager()
    desk.start("spawner", "arm")
    desk.run(1.0)
    manager.node.shutdown()
    desk.shut_down()
    assert desk.said()[-1].startswith(
        "WARN Controller Spawner error while taking down controllers:"
    )


def test_one_that_is_ended_while_it_waits_takes_nothing_down(desk):
    desk.start("spawner", "arm")
    desk.run(1.0)
    desk.shut_down()
    desk.run(1.0)
    assert desk.said() == WAITED[:1]


def test_it_gives_up_after_its_timeout(desk):
    program = desk.start("spawner", "--timeout", "2", "arm")
    desk.run(3.0)
    assert program.exit_code == 0
    assert desk.said()[-1] == LOST


@pytest.mark.parametrize("words", [["--timeout", "0"], ["--timeout", "-1"], ["--no-timeout"]])
def test_without_a_timeout_it_waits_for_ever(desk, words):
    program = desk.start("spawner", *words, "arm")
    desk.run(100.0)
    assert program.exit_code is None
    assert LOST not in desk.said()


def test_it_gives_up_after_half_a_minute_and_hints_before(desk):
    program = desk.start("spawner", "arm")
    desk.run(5.05)
    assert [one.split(" ")[1] for one in desk.said()] == ["Controller", "hint:"]
    desk.run(24.9)
    assert program.exit_code is None
    desk.run(0.2)
    assert program.exit_code == 0
    assert len([one for one in desk.said() if "hint:" in one]) == 1


def hint(desk):
    desk.start("spawner", "arm")
    desk.run(6.0)
    (found,) = (one for one in desk.said() if "hint:" in one)
    return found


def simulate(desk):
    """A node that offers what a simulation offers."""
    from simkit.msgs import service_class

    kind = service_class("gazebo_msgs/SpawnModel")
    node = desk.graph.create_node("/gazebo")
    node.advertise_service("/gazebo/spawn_urdf_model", kind, lambda _: kind._response_class())


def test_a_hint_says_that_no_simulation_runs(desk):
    assert "empty_world.launch" in hint(desk)


def test_a_hint_says_that_the_robot_has_no_plugin(desk):
    simulate(desk)
    desk.graph.params.set("/robot_description", "<robot name='r'/>")
    assert 'filename="libgazebo_ros_control.so"' in hint(desk)


def test_a_hint_says_that_no_robot_is_described(desk):
    simulate(desk)
    assert "no parameter robot_description is set" in hint(desk)


def test_a_hint_says_that_the_robot_is_not_spawned(desk):
    simulate(desk)
    text = '<plugin filename="libgazebo_ros_control.so"/>'
    desk.graph.params.set("/robot_description", text)
    assert "by spawn_model" in hint(desk)


def test_a_hint_names_the_other_namespace(desk):
    desk.manager("/left")
    assert "add --namespace /left" in hint(desk)


def test_it_can_wait_for_a_topic_to_say_true(desk):
    manager = desk.manager()
    desk.start("spawner", "--wait-for", "ready", "--timeout", "1", "arm")
    desk.run(2.0)
    assert manager.asked == []
    warning = 'WARN Controller Spawner hasn\'t heard anything from its "wait for" topic (ready)'
    assert desk.said()[-1] == warning
    desk.publish("/ready", "std_msgs/Bool", data=True)
    desk.run(0.1)
    assert manager.states == {"arm": "running"}


def test_a_yaml_file_is_loaded_and_names_controllers(desk, tmp_path):
    manager = desk.manager()
    path = tmp_path / "c.yaml"
    path.write_text("arm:\n  type: a/A\nhand:\n  type: b/B\n")
    desk.start("spawner", str(path))
    desk.run(1.0)
    assert manager.asked[:2] == ["load arm", "load hand"]
    assert desk.graph.params.get("/hand/type") == "b/B"


@pytest.mark.parametrize(("words", "code"), [([], 2), (["--nonsense", "arm"], 2), (["--help"], 0)])
def test_a_command_line_that_cannot_be_prints_how_it_is_used(desk, words, code):
    program = desk.start("spawner", *words)
    assert program.exit_code == code
    assert program.output.startswith("usage: spawner")


def test_a_manager_that_goes_meanwhile_is_an_error(desk):
    manager = desk.manager()
    desk.start("spawner", "bad", "arm")
    desk.run(0.5)
    manager.node.shutdown()
    desk.run(1.0)
    assert desk.said()[-1].startswith("WARN Controller Spawner error")
    assert any("unavailable" in one for one in desk.said())


# -- unspawner: controllers stay stopped while it runs


def test_it_stops_them_again_and_again_and_starts_them_when_it_ends(desk):
    manager = desk.manager()
    manager.states = {"arm": "running", "hand": "running"}
    desk.start("unspawner", "arm")
    desk.run(0.1)
    assert manager.states == {"arm": "stopped", "hand": "running"}
    assert desk.said() == ["INFO Inhibiting controllers: arm"]
    manager.states["arm"] = "running"
    desk.run(3.0)
    assert manager.states["arm"] == "stopped"
    desk.shut_down()
    assert manager.asked[-1] == "switch ['arm'] [] 1"
    assert manager.states["arm"] == "running"


def test_without_names_it_says_how_it_is_used(desk):
    program = desk.start("unspawner")
    assert program.exit_code == 1
    assert "Stops a set of controllers until killed." in program.output


def test_one_that_loses_its_manager_ends(desk):
    manager = desk.manager()
    program = desk.start("unspawner", "arm")
    desk.run(0.1)
    manager.node.shutdown()
    desk.run(3.0)
    assert program.exit_code == 1
