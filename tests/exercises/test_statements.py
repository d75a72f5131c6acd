"""What the texts of the exercises state of simulated robots, and no cell prints."""

import math
import re
from pathlib import Path

import pytest

from simkit import Simulation

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
CAR = (ROBOTS / "gazebo_car" / "urdf" / "practice_car.urdf").read_text(encoding="utf-8")
FRICTION = re.compile(r'<gazebo reference="front_wheel">.*?</gazebo>', re.DOTALL)
BALL = re.compile(r'(<link name="front_wheel">.*?)<inertial>.*?</inertial>', re.DOTALL)


@pytest.fixture
def sim():
    with Simulation(screen=None) as running:
        yield running


def test_s_02_with_a_ball_that_grips_the_car_goes_straight_on_and_too_slowly(sim):
    text, removed = FRICTION.subn("", CAR)
    assert removed == 1
    car = sim.spawn(text, name="car").model
    sim.run(0.5)
    command = {"linear": {"x": 0.3}, "angular": {"z": 0.5}}
    sim.rostopic_pub("/cmd_vel", "geometry_msgs/Twist", command)
    sim.run(2.0)
    x, y, _ = car.pose.translation
    assert abs(2 * math.atan2(*car.pose.rotation[2:])) < 0.05
    assert 0.1 < math.hypot(x, y) / 2.0 < 0.25


def test_s_02_a_ball_without_inertial_stays_and_its_mass_is_missing(sim):
    text, removed = BALL.subn(r"\1", CAR)
    assert removed == 1
    car = sim.spawn(text, name="car").model
    assert "front_wheel" in car.links
    assert car.mass == pytest.approx(2.5 - 0.5)


def test_3_09_a_swing_from_horizontal_takes_longer_since_the_sine_is_less_than_the_angle(sim):
    arm = sim.spawn(ROBOTS / "hello_ros" / "urdf" / "hello_gazebo_robot_1.urdf", name="arm").model
    arm.joint("hip").command_position(0.0)
    sim.run(1.0)
    before = arm.joint("shoulder").position
    sim.run(0.2305)
    small = 2 * math.pi * math.sqrt((0.01396 + 0.2**2) / (9.8 * 0.2))
    assert small == pytest.approx(1.043, abs=5e-4)
    assert before > 0.1
    assert arm.joint("shoulder").position == pytest.approx(0.0, abs=0.01)
    assert math.sin(math.pi / 2) / (math.pi / 2) == pytest.approx(0.64, abs=5e-3)
