"""Exercise 3.1, hidden checks: other turtles, jumps, and the wall."""

import math

import pytest

from grader.checks import expect, expect_close, points
from oracles.turtles import TurtleWatch, turned, yaw_of

SCRIPT = "turtle_tf_broadcaster.py"


@pytest.fixture
def world(sim):
    """A simulation in which turtlesim runs."""
    sim.rosrun("turtlesim", "turtlesim_node")
    sim.run(0.1)
    return sim


def expect_to_be_on_the_turtle(watch, turtle, transform):
    """A transform has the position and heading that turtlesim publishes."""
    pose = watch.pose_at(transform.time, turtle)
    expect_close(
        transform.translation,
        (pose.x, pose.y, 0.0),
        tolerance=0.05,
        what=f"the position of {turtle}",
        unit="m",
        frame="world",
        hint="Send the position from the message that has just arrived, with z = 0.",
    )
    expect(
        turned(yaw_of(transform.rotation), pose.theta) < 0.06,
        f"the heading of {turtle} is not the turtle's",
        hint="Send the heading from the message that has just arrived.",
    )


@points(1)
def test_the_parameter_names_the_turtle(world, run_node, rng):
    """Started with _turtle:=turtle2, the script broadcasts turtle2 and not turtle1."""
    name = "turtle2"
    world.call("/spawn", rng.uniform(2, 9), rng.uniform(2, 9), rng.uniform(-3, 3), name)
    watch = TurtleWatch(world, ["turtle1", name])
    run_node(SCRIPT, f"_turtle:={name}", "__name:=second_broadcaster")
    world.run(1.0)
    frames = sorted({transform.child for transform in watch.transforms()})
    expect(
        frames == [name],
        f"with _turtle:={name} the script broadcasts {', '.join(frames) or 'nothing'}",
        hint="Read the private parameter, rospy.get_param('~turtle', default='turtle1'), "
        "and use it in the topic and in the frame.",
    )
    expect_to_be_on_the_turtle(watch, name, watch.of_frame(name)[-1])


@points(1)
def test_a_jump_is_followed_at_once(world, run_node, rng):
    """After a teleport the transform is at the turtle's new place within a tenth of a second."""
    watch = TurtleWatch(world)
    run_node(SCRIPT)
    world.run(0.5)
    for _ in range(3):
        target = (rng.uniform(1, 10), rng.uniform(1, 10), rng.uniform(-math.pi, math.pi))
        world.call("/turtle1/teleport_absolute", *target)
        world.run(0.1)
        heard = watch.of_frame("turtle1")
        expect(
            heard and heard[-1].time > world.now.to_sec() - 0.1,
            "no transform was received after a teleport",
            hint="Send a transform for every pose that arrives.",
        )
        expect_to_be_on_the_turtle(watch, "turtle1", heard[-1])


@points(1)
def test_at_the_wall(world, run_node, rng):
    """Pressed against the wall, the turtle and its frame stay together."""
    watch = TurtleWatch(world)
    run_node(SCRIPT)
    world.call("/turtle1/teleport_absolute", 9.5, rng.uniform(4, 7), rng.uniform(-0.4, 0.4))
    command = {"linear": {"x": 2.0}}
    world.rostopic_pub("/turtle1/cmd_vel", "geometry_msgs/Twist", command, rate=10)
    world.run(2.5)
    heard = watch.of_frame("turtle1")
    expect(
        len(heard) >= 20,
        "hardly any transform was received on the way to the wall",
        hint="Send a transform for every pose that arrives.",
    )
    for transform in heard[-10:]:
        expect_to_be_on_the_turtle(watch, "turtle1", transform)
