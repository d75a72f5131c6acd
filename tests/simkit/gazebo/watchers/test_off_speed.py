"""A robot that is faster or slower than it is told, though its wheels obey."""

from __future__ import annotations

from tests.simkit.plugins.samples import CAR

SMOOTH = "".join(
    f'<gazebo reference="{name}"><mu1>0.001</mu1><mu2>0.001</mu2></gazebo>'
    for name in ("left", "right")
)


def drive(watched, speed, turn=0.0):
    watched.run(0.2)
    watched.tell(speed, turn)
    watched.run(3)


def test_a_separation_that_is_not_that_of_the_wheels(watched):
    watched.sdf_car(separation=0.8)
    drive(watched, 0.0, 0.5)
    (text,) = watched.found("GZ-W03")
    assert "told to turn at +0.50 rad/s, and does so at +1.0" in text
    assert text.endswith("Write <wheelSeparation>0.4</wheelSeparation>")


def test_a_diameter_that_is_not_that_of_the_wheels(watched):
    watched.sdf_car(diameter=0.4)
    drive(watched, 0.4)
    (text,) = watched.found("GZ-W03")
    assert "told to drive at +0.40 m/s, and does so at +0.20 m/s" in text
    assert text.endswith("Write <wheelDiameter>0.2</wheelDiameter>")


def test_right_numbers(watched):
    watched.sdf_car()
    drive(watched, 0.4, 0.5)
    assert watched.found() == []


def test_what_check_urdf_has_warned_of_is_not_said_again(watched):
    watched.car(separation=0.8)
    drive(watched, 0.0, 0.5)
    assert watched.found() == []


def test_wheels_that_slip(watched):
    watched.car(more=SMOOTH)
    drive(watched, 0.5)
    (text,) = watched.found()
    assert text.startswith("[GZ-W05] car is told to drive at +0.50 m/s, and drives at +0.00 m/s")
    assert "They bear" in text
    share = int(text.partition("They bear ")[2].partition("%")[0])
    assert 20 < share < 100


def test_wheels_that_hold(watched):
    watched.car(robot=CAR)
    drive(watched, 0.5, 0.5)
    assert watched.found() == []
