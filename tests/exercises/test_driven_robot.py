"""A driven robot stands on the floor, goes as it is told, and is measured; its ball is found."""

import math
from pathlib import Path

import pytest

from grader.errors import CheckFailed
from oracles.driven_robot import (
    DrivenRobot,
    Stand,
    expect_ball,
    heading_of,
    lowest_point,
)
from simkit import Simulation
from simkit.urdf import load_robot

TEXT = (Path(__file__).resolve().parents[2] / "robots/my_robot_urdf/urdf/m2wr.urdf").read_text(
    encoding="utf-8"
)
WHEELS = ("link_left_wheel", "link_right_wheel")
SLIDING = "    <mu1>0.0</mu1>\n    <mu2>0.0</mu2>\n"


ORIGIN = Stand(0.0, 0.0, 0.0)


def driven(text=TEXT, at=ORIGIN):
    robot = load_robot(text, file="m2wr.urdf")
    sim = Simulation(screen=None)
    return sim, robot, DrivenRobot(sim, robot, text, name="m2wr", at=at)


def test_a_stand_is_seen_from_another():
    start = Stand(1.0, 2.0, math.pi / 2)
    assert Stand(1.0, 5.0, math.pi).seen_from(start) == pytest.approx((3.0, 0.0, math.pi / 2))
    assert Stand(0.0, 2.0, -math.pi).seen_from(start) == pytest.approx((0.0, 1.0, math.pi / 2))


def test_a_heading_is_read_from_a_quaternion():
    assert heading_of((0.0, 0.0, math.sin(0.4), math.cos(0.4))) == pytest.approx(0.8)
    assert heading_of((math.sin(0.4), 0.0, 0.0, math.cos(0.4))) == pytest.approx(0.0)


def test_it_begins_on_the_floor_where_it_shall():
    sim, robot, found = driven(at=Stand(1.0, -2.0, 2.5))
    with sim:
        assert lowest_point(robot, found.model) == pytest.approx(0.0, abs=1e-6)
        assert found.stand == pytest.approx((1.0, -2.0, 2.5))
        assert found.is_at_rest
        axle = found.axle(*WHEELS).seen_from(found.stand)
        assert axle == pytest.approx((-0.05, 0.0, 0.0), abs=1e-6)


def test_it_goes_as_it_is_told_until_it_is_told_otherwise():
    sim, _, found = driven(at=Stand(0.0, 0.0, 3.0))
    with sim:
        ahead = found.drive(0.4, 0.0, settle=0.5, seconds=0.5)
        assert ahead == pytest.approx((0.2, 0.0, 0.0), abs=5e-3)
        assert not found.is_at_rest
        turned = found.drive(0.0, 0.6, settle=0.5, seconds=0.5)
        assert turned.heading == pytest.approx(0.3, rel=0.12)  # wheels have a width
        found.command(0.0, 0.0)
        sim.run(0.5)
        assert found.is_at_rest


def test_a_ball_with_friction_drags():
    shares = []
    for text in (TEXT, TEXT.replace(SLIDING, "")):
        sim, _, found = driven(text)
        with sim:
            found.drive(0.0, 0.6, settle=0.3, seconds=0.1)
            shares.append(found.drag(*WHEELS))
    assert shares[0] == pytest.approx(0.0, abs=0.01)
    assert shares[1] > 0.9


def test_a_ball_is_where_it_shall_be():
    sim, robot, found = driven()
    with sim:
        expect_ball(
            robot,
            found.model,
            wheels=WHEELS,
            link="link_chassis",
            radius=0.05,
            centre=(0.2, 0.0, -0.05),
        )
        with pytest.raises(CheckFailed, match="not where its visual is") as caught:
            expect_ball(
                robot,
                found.model,
                wheels=WHEELS,
                link="link_chassis",
                radius=0.05,
                centre=(0.35, 0.0, -0.05),
            )
    assert caught.value.actual == "radius 0.05 m at 0.2 0 -0.05"
    assert caught.value.expected == "radius 0.05 m at 0.35 0 -0.05, in the frame link_chassis"


def test_no_ball_is_told():
    sim, robot, found = driven(TEXT.replace('<sphere radius="0.05"/>', '<box size="0.1 0.1 0.1"/>'))
    with sim, pytest.raises(CheckFailed) as caught:
        expect_ball(
            robot,
            found.model,
            wheels=WHEELS,
            link="link_chassis",
            radius=0.05,
            centre=(0.2, 0.0, -0.05),
        )
    assert caught.value.actual == "no ball on the floor"


def test_wheels_may_be_balls():
    wheel = '<cylinder length="0.04" radius="0.1"/>'
    sim, robot, found = driven(TEXT.replace(wheel, '<sphere radius="0.1"/>'))
    place = {"link": "link_chassis", "radius": 0.05, "centre": (0.2, 0.0, -0.05)}
    with sim:
        expect_ball(robot, found.model, wheels=WHEELS, **place)
        with pytest.raises(CheckFailed) as caught:
            expect_ball(robot, found.model, wheels=(), **place)
    assert caught.value.actual.count("radius") == 3
