"""Exercise 3.5, hidden checks: frames that come late, and turtles that jump."""

import math

import pytest

from grader.checks import expect, expect_close, points
from grader.checks.given import broadcast_frame, broadcast_turtle
from oracles.pursuit import ahead_of, seen_from


@pytest.fixture
def world(sim):
    """Two turtles that are not broadcast yet."""
    sim.rosrun("turtlesim", "turtlesim_node")
    sim.call("/spawn", 3.0, 7.0, 2.0, "turtle2")
    sim.run(0.1)
    return sim


def jump(sim, rng):
    """Put both turtles somewhere else."""
    for turtle in ("turtle1", "turtle2"):
        place = (rng.uniform(3, 8), rng.uniform(3, 8), rng.uniform(-math.pi, math.pi))
        sim.call(f"/{turtle}/teleport_absolute", *place)


def last_place(sim):
    """What was published last on /place."""
    expect(
        "/place" in sim.topics() and sim.latest("/place"),
        "nothing was received on /place",
        hint="look() must return what the lookup returns, and None only while tf cannot answer.",
    )
    point = sim.latest("/place")
    return (point.x, point.y, point.z)


@points(1)
@pytest.mark.parametrize("script", ["listener_1.py", "listener_2.py"])
def test_frames_come_late(world, run_node, rng, script):
    """Started before the turtles are broadcast, a listener waits, and then publishes the right place."""
    node = run_node(script)
    world.run(1.5)
    expect(
        node.alive,
        f"{script} ended while tf did not know the turtles yet; a lookup that may fail belongs in a try block",
        hint="In the block of except tf.Exception, return None: the loop sleeps and asks again.",
    )
    for turtle in ("turtle1", "turtle2"):
        broadcast_turtle(world, turtle)
    jump(world, rng)
    world.run(2.0)
    one, two = (world.latest(f"/{turtle}/pose") for turtle in ("turtle1", "turtle2"))
    expect_close(
        last_place(world),
        (*seen_from(two, one), 0.0),
        tolerance=0.05,
        what=f"the place that {script} published",
        unit="m",
        frame="turtle2",
        hint="Look up turtle1, seen from turtle2, each time round the loop.",
    )


@points(0.5)
def test_listener_3_remembers_a_place_that_was_left(world, run_node, rng):
    """Listener 3 still shows the old place up to five seconds after a jump, and then the new one."""
    for turtle in ("turtle1", "turtle2"):
        broadcast_turtle(world, turtle)
    run_node("listener_3.py")
    world.run(8.0)
    old = world.latest("/turtle1/pose")
    jump(world, rng)
    for seconds, name in ((4.5, "4.5 s after a jump"), (1.0, "5.5 s after a jump")):
        world.run(seconds)
        pose = old if seconds > 4 else world.latest("/turtle1/pose")
        expect_close(
            last_place(world),
            (pose.x, pose.y, 0.0),
            tolerance=0.05,
            what=f"the place of turtle1 that was published {name}",
            unit="m",
            frame="world",
            hint="The time of the lookup is rospy.Time.now() - rospy.Duration(5.0), computed again in every call.",
        )


@points(0.5)
def test_the_bridge_follows_a_jump(world, run_node, rng):
    """The point of the bridge jumps with the turtle, and turns with it."""
    broadcast_turtle(world, "turtle1")
    broadcast_frame(world, "carrot1", "turtle1", translation=(2.0, 0.0, 0.0))
    run_node("point_bridge.py")
    for _ in range(3):
        jump(world, rng)
        world.run(1.0)
        expect(
            "/carrot_in_world" in world.topics() and world.latest("/carrot_in_world"),
            "nothing was received on /carrot_in_world",
            hint="Catch tf.Exception, and try again the next time round the loop.",
        )
        point = world.latest("/carrot_in_world").point
        expect_close(
            (point.x, point.y, point.z),
            (*ahead_of(world.latest("/turtle1/pose"), 4.0), 0.0),
            tolerance=0.05,
            what="the point that was published",
            unit="m",
            frame="world",
            hint="Let tf rotate and translate the point: transformPoint('world', point).",
        )
