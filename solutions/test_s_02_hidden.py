"""Exercise S.2, hidden checks: the car stands still where it is put, and turns as it is commanded."""

import math

import pytest

from grader.checks import after, expect_close, points
from grader.checks.robots import RobotFiles
from grader.checks.worlds import loads, spawned_robot

ROBOT = "practice_car.urdf"
CAR = "practice_car"


@pytest.fixture
def robots(exercise, submission, package_path):
    """The student's URDF files."""
    return RobotFiles(exercise, submission, package_path)


@points(1)
@after("test_it_falls_and_comes_to_rest")
def test_it_stands_still(sim, robots, rng):
    """Wherever the car is put down it stays, with most of its weight on the wheels."""
    where = (rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0), 0.02)
    yaw = rng.uniform(-3.0, 3.0)
    model = spawned_robot(sim, robots.text(ROBOT), name=CAR, xyz=where, rpy=(0.0, 0.0, yaw)).model
    sim.run(0.6)
    before = model.pose.translation
    forces = loads(sim.gazebo, CAR)
    expect_close(
        (
            forces.get("right_wheel", 0.0) + forces.get("left_wheel", 0.0),
            forces.get("front_wheel", 0.0),
        ),
        (15.4, 9.1),
        tolerance=0.4,
        what="the force of the ground on both wheels together, and on the ball,",
        unit="N",
        hint="It depends on the masses and on their positions: compare them with the table in the exercise.",
    )
    sim.run(1.0)
    expect_close(
        [1000 * (now - then) for now, then in zip(model.pose.translation, before, strict=True)],
        (0.0, 0.0, 0.0),
        tolerance=0.1,
        what="how far the car creeps in a second without a command",
        unit="mm",
        hint="Look at the inertias, and at the heights of wheels and ball.",
    )


@points(1)
@after("test_it_drives_straight")
def test_it_turns_as_it_is_told(sim, robots, rng):
    """Commanded to turn, the car turns in the right direction and at the right rate, on the spot and in a curve."""
    model = spawned_robot(sim, robots.text(ROBOT), name=CAR).model
    sim.run(0.2)
    rate = rng.choice((-1.0, 1.0)) * rng.uniform(0.5, 0.7)
    expect_close(
        turning(sim, model, speed=0.3, rate=rate),
        rate,
        tolerance=0.25 * abs(rate),
        what=f"how fast the car turns in a curve, commanded to drive at 0.3 m/s and to turn at {rate:.2f} rad/s,",
        unit="rad/s",
        hint="If it turns to the other side: leftJoint is the wheel with the positive y. If it hardly turns: the ball "
        "grips the ground, so take its friction away (mu1 and mu2 of front_wheel).",
    )
    # In a curve a tyre of 5 cm rests now on one edge, now on the other. On the spot, from rest, that makes no difference.
    sim.gazebo.reset_world()
    sim.run(0.1)
    expect_close(
        turning(sim, model, speed=0.0, rate=-rate),
        -rate,
        tolerance=0.05 * abs(rate),
        what=f"how fast the car turns on the spot, commanded to turn at {-rate:.2f} rad/s,",
        unit="rad/s",
        hint="wheelSeparation is the distance between the middles of the two wheels. If the car is a little too slow, "
        "the ball may still drag: set mu1 and mu2 of front_wheel to 0.",
    )


def turning(sim, model, *, speed, rate):
    """How fast a car turns in the second after the command [rad/s]; the first half of a second does not count."""
    node = sim.rostopic_pub(
        "/cmd_vel", "geometry_msgs/Twist", {"linear": {"x": speed}, "angular": {"z": rate}}
    )
    sim.run(0.5)
    before = heading(model)
    sim.run(1.0)
    node.shutdown()
    return math.remainder(heading(model) - before, math.tau)


def heading(model):
    """The heading of a car that stands upright [rad]."""
    _, _, z, w = model.pose.rotation
    return 2 * math.atan2(z, w)
