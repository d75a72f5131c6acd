"""How watchers are let look: now and then, while there is something to look at, and without a trace."""

from __future__ import annotations

import pytest

from simkit.gazebo.watchers.watch import WATCHERS
from simkit.urdf.rules import all_rules
from tests.simkit.plugins.conftest import Stage


@pytest.mark.parametrize("watcher", WATCHERS, ids=lambda one: one.rule)
def test_every_watcher_speaks_under_an_id_that_check_urdf_explains(watcher):
    assert watcher.rule in {rule.id for rule in all_rules()}


def test_watching_changes_nothing(new_watched):
    def drive(stage):
        spawned = new_watched().car.__func__(stage)
        heard = stage.listen("/odom", "nav_msgs/Odometry")
        stage.run(0.35)
        new_watched().tell.__func__(stage, 0.4, 0.6)
        stage.run(1.0)
        return spawned.model.pose, [one.to_bytes() for one in heard]

    assert drive(new_watched()) == drive(Stage())


def test_it_looks_ten_times_a_second_while_the_world_moves(watched, monkeypatch):
    watched.car()
    looks = []
    scene = watched.watch._scenes["car"]
    look = scene.motion.look
    monkeypatch.setattr(scene.motion, "look", lambda: looks.append(1) or look())
    watched.run(1.0)
    assert len(looks) == 10
    watched.gazebo.pause()
    watched.run(1.0)
    assert len(looks) == 10
    watched.gazebo.unpause()
    watched.run(1.0)
    assert len(looks) in (19, 20)


def test_with_nothing_left_to_look_at_there_is_no_timer(watched):
    executor = watched.graph.executor
    waiting = executor.next_time_ns()
    watched.car()
    assert executor.next_time_ns() is not None
    watched.gazebo.delete("car")
    watched.run(0.2)
    assert executor.next_time_ns() == waiting


def test_each_model_is_told_once(watched):
    watched.car(z=0.0)
    watched.run(0.3)
    assert len(watched.found("GZ-W06")) == 1
    watched.gazebo.delete("car")
    watched.car(z=0.0)
    watched.run(0.3)
    assert len(watched.found("GZ-W06")) == 2
