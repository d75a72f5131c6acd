from __future__ import annotations

import pytest

from grader.checks.given import broadcast_frame, broadcast_turtle
from grader.errors import CheckFailed
from oracles.frames import age_of, expect_frame
from oracles.turtles import TurtleWatch
from simkit import Simulation


@pytest.fixture
def sim() -> Simulation:
    return Simulation(screen=None)


def test_a_turtle_is_where_turtlesim_says(sim: Simulation) -> None:
    sim.rosrun("turtlesim", "turtlesim_node")
    broadcast_turtle(sim, "turtle1")
    sim.call("/turtle1/teleport_absolute", 2, 3, 1.5)
    sim.run(0.1)
    place = sim.tf.lookup_transform("world", "turtle1").transform
    assert (place.translation.x, place.translation.y) == pytest.approx((2, 3))
    assert place.rotation.z == pytest.approx(0.6816, abs=1e-4)
    assert age_of(sim, "turtle1", "world") < 0.02


def test_a_frame_of_its_own(sim: Simulation) -> None:
    watch = TurtleWatch(sim, [])
    broadcast_frame(sim, "carrot1", "turtle1", translation=(2, 0, 0), rate=4)
    sim.run(1.05)
    heard = expect_frame(watch.transforms(), child="carrot1", parent="turtle1")
    assert [one.translation for one in heard] == [(2, 0, 0)] * 4
    assert age_of(sim, "carrot1", "turtle1") == pytest.approx(0.05)


@pytest.mark.parametrize(
    ("child", "parent", "words"),
    [
        ("turtle1", "carrot1", "parent and child are swapped"),
        ("carrot1", "world", "got world -> carrot1"),
        ("Carrot1", "turtle1", "got turtle1 -> Carrot1"),
    ],
)
def test_what_is_wrong_with_a_frame(sim: Simulation, child: str, parent: str, words: str) -> None:
    watch = TurtleWatch(sim, [])
    broadcast_frame(sim, child, parent, translation=(0, 0, 0))
    sim.run(0.5)
    with pytest.raises(CheckFailed, match=words):
        expect_frame(watch.transforms(), child="carrot1", parent="turtle1")


def test_given_frames_do_not_count(sim: Simulation) -> None:
    watch = TurtleWatch(sim, [])
    broadcast_frame(sim, "turtle1", "world", translation=(0, 0, 0))
    sim.run(0.5)
    with pytest.raises(CheckFailed, match="no transform of carrot1 was received"):
        expect_frame(watch.transforms(), child="carrot1", parent="turtle1", given=["turtle1"])
