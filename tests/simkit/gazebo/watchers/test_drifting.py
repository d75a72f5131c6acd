"""A robot that moves though nobody tells it to."""

from __future__ import annotations

FRICTIONLESS = "".join(
    f'<gazebo reference="{name}"><mu1>0</mu1><mu2>0</mu2></gazebo>' for name in ("left", "right")
)


def test_a_robot_that_creeps(watched):
    spawned = watched.car(more=FRICTIONLESS)
    watched.run(0.3)
    spawned.model.set_twist((0.02, 0.0, 0.0), (0.0, 0.0, 0.0))
    watched.run(14)
    (text,) = watched.found("GZ-W05")
    assert "moves though nothing is commanded: 0.1 m and" in text
    assert "degrees in 5 s" in text


def test_a_robot_that_stands(watched):
    spawned = watched.car()
    watched.run(0.3)
    spawned.model.set_twist((0.02, 0.0, 0.0), (0.0, 0.0, 0.0))
    watched.run(14)
    assert watched.found() == []


def test_a_robot_that_is_put_elsewhere_did_not_creep(watched):
    spawned = watched.car()
    watched.run(5)
    spawned.model.set_pose(watched.at(1, 1, 0.1, yaw=1))
    watched.run(9)
    assert watched.found() == []
