"""unspawner: controllers stay stopped while it runs."""

from __future__ import annotations


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
