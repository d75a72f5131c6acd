"""Exercise 3.2, hidden checks: carrots in the world, after jumps, in curves, and a minute later."""

import math
from itertools import pairwise

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.given import broadcast_turtle
from oracles.frames import age_of
from oracles.turtles import TurtleWatch

FIXED = "fixed_tf_broadcaster.py"
MOVING = "moving_tf_broadcaster.py"


@pytest.fixture
def world(sim):
    """A simulation in which turtlesim runs, and the turtle's frame is broadcast."""
    sim.rosrun("turtlesim", "turtlesim_node")
    broadcast_turtle(sim)
    sim.run(0.1)
    return sim


def drive_curve(sim, rng):
    """Let turtle1 drive a curve from now on."""
    command = {"linear": {"x": rng.uniform(0.5, 1.0)}, "angular": {"z": rng.uniform(0.6, 1.2)}}
    sim.rostopic_pub("/turtle1/cmd_vel", "geometry_msgs/Twist", command, rate=10)


@points(1)
def test_the_carrot_jumps_with_the_turtle(world, run_node, rng):
    """Wherever the turtle is put, carrot1 is 2 m in front of it, in the frame world."""
    run_node(FIXED)
    world.run(0.5)
    for _ in range(3):
        x, y, theta = rng.uniform(3, 8), rng.uniform(3, 8), rng.uniform(-math.pi, math.pi)
        world.call("/turtle1/teleport_absolute", x, y, theta)
        world.run(0.5)
        place = world.tf.lookup_transform("world", "carrot1").transform.translation
        expect_close(
            (place.x, place.y, place.z),
            (x + 2 * math.cos(theta), y + 2 * math.sin(theta), 0.0),
            tolerance=0.02,
            what="the position of carrot1",
            unit="m",
            frame="world",
            hint="Make turtle1 the parent; tf then moves and turns the carrot with the turtle.",
        )


@points(1)
def test_the_circle_moves_with_the_turtle(world, run_node, rng):
    """While the turtle drives a curve, the moving carrot1 stays 2 m from it, in the plane."""
    run_node(MOVING)
    drive_curve(world, rng)
    world.run(1.0)
    for _ in range(12):
        world.run(rng.uniform(0.1, 0.5))
        # Between two transforms tf interpolates along a straight line, so the last one itself is looked at.
        carrot = world.tf.lookup_transform("turtle1", "carrot1").transform.translation
        expect_close(
            (math.hypot(carrot.x, carrot.y), carrot.z),
            (2.0, 0.0),
            tolerance=0.05,
            what="distance and height of carrot1, seen from the turtle",
            unit="m",
            hint="The circle is around turtle1, so turtle1 is the parent and (0, 0, 0) the centre.",
        )
        age = age_of(world, "carrot1", "turtle1")
        expect(
            age <= 0.5,
            f"the newest transform of carrot1 is {age:.2f} s old",
            hint="Send in a loop, each time with rospy.Time.now().",
        )


@points(1)
@after("test_the_moving_carrot_circles")
def test_it_still_circles_after_a_minute(world, run_node):
    """After a minute the moving carrot1 still circles at 2 m, each transform with its own time."""
    run_node(MOVING)
    world.run(60.0)
    watch = TurtleWatch(world, [])
    world.run(5.0)
    heard = watch.of_frame("carrot1")
    expect(
        len(heard) >= 5,
        f"{len(heard)} transforms were received in the 5 s after the first minute",
        hint="Send in a loop that ends with the node: while not rospy.is_shutdown().",
    )
    stamps = [transform.stamp for transform in heard]
    expect(
        all(a < b for a, b in pairwise(stamps)),
        "two transforms carry the same time",
        hint="Call rospy.Time.now() again for each transform.",
    )
    for transform in heard:
        expect_close(
            math.hypot(*transform.translation),
            2.0,
            tolerance=0.05,
            what="the distance of carrot1 from the turtle",
            unit="m",
            hint="Only the angle may grow with the time, not the distance.",
        )
    ways = [math.dist(a.translation, b.translation) for a, b in pairwise(heard)]
    expect(
        min(ways) > 1e-4,
        "carrot1 stands still",
        hint="Let the angle grow with the time, for ever.",
    )
