"""Exercise 3.3, hidden checks: the other way round, jumps, a turtle right behind, and one that only tf knows."""

import math

import pytest

from grader.checks import expect, points
from grader.checks.given import broadcast_frame, broadcast_turtle
from oracles.pursuit import come_near, drive, gap, samples, usual_bearing

SCRIPT = "turtle_tf_listener.py"


@pytest.fixture
def chase(sim, run_node):
    """Turtlesim, both turtles' frames, and the student's node."""
    sim.rosrun("turtlesim", "turtlesim_node")
    for turtle in ("turtle1", "turtle2"):
        broadcast_turtle(sim, turtle)
    start(sim, run_node)
    return sim


def start(sim, run_node):
    """Start the student's node, and wait for turtle2."""
    run_node(SCRIPT)
    expect(
        sim.run_until(lambda: "/turtle2/pose" in sim.topics() and sim.latest("/turtle2/pose"), 2.0),
        "there is no turtle2 after 2 s",
        hint="Wait for the service spawn, then call it with 4, 2, 0 and 'turtle2'.",
    )


@points(1)
def test_it_follows_to_the_right(chase, rng):
    """When turtle1 circles clockwise, turtle2 follows too, and keeps looking at it."""
    speed = rng.uniform(0.8, 1.1)
    drive(chase, speed=speed, turn_rate=-speed / 2)
    chase.run(5.0)
    seen = samples(chase, 4.0)
    farthest = max(gap(two, one) for one, two in seen)
    expect(
        farthest < 2.5,
        f"turtle2 falls behind: it was {farthest:.1f} m away from turtle1",
        hint="Look turtle1 up each time round the loop, with rospy.Time(0), and send the command at once.",
    )
    angle = usual_bearing(seen)
    expect(
        angle < 0.8,
        f"turtle2 looks up to {angle:.1f} rad past the turtle that it follows",
        hint="Make the turn rate four times the angle atan2(y, x), for left and right alike.",
    )


@points(1)
def test_it_comes_after_a_jump(chase, rng):
    """After each jump of turtle1, turtle2 comes to the new place, nearer than 1 m within 15 s."""
    for _ in range(2):
        place = (rng.uniform(1, 10), rng.uniform(1, 10), rng.uniform(-math.pi, math.pi))
        chase.call("/turtle1/teleport_absolute", *place)
        chase.run(0.1)
        distance = come_near(chase, 1.0, timeout=15.0)
        expect(
            distance < 1.0,
            f"in the 15 s after a jump of turtle1, turtle2 came no nearer than {distance:.1f} m",
            hint="Ask tf for the latest transform each time round the loop, for as long as the node runs.",
        )


@points(1)
def test_it_turns_around(chase, rng):
    """When turtle1 appears right behind it, turtle2 turns around and comes back."""
    come_near(chase, 1.0, timeout=10.0)
    for side in (1, -1):
        two = chase.latest("/turtle2/pose")
        home = math.atan2(5.5 - two.y, 5.5 - two.x)
        chase.call("/turtle2/teleport_absolute", two.x, two.y, home + math.pi)
        chase.run(0.1)
        away = home + side * rng.uniform(0.1, 0.3)
        place = (two.x + 4 * math.cos(away), two.y + 4 * math.sin(away), 0.0)
        chase.call("/turtle1/teleport_absolute", *place)
        chase.run(0.1)
        distance = come_near(chase, 1.0, timeout=15.0)
        expect(
            distance < 1.0,
            f"in 15 s turtle2 came no nearer than {distance:.1f} m to a turtle that was behind it",
            hint="Use atan2(y, x), not atan(y / x): only atan2 knows what lies behind.",
        )


@points(1)
def test_it_goes_by_tf(sim, run_node, rng):
    """When tf has turtle1 elsewhere than turtlesim draws it, turtle2 goes to the place that tf has."""
    sim.rosrun("turtlesim", "turtlesim_node")
    broadcast_turtle(sim, "turtle2")
    place = (rng.uniform(1.5, 3.0), rng.uniform(8.0, 9.5))
    broadcast_frame(sim, "turtle1", "world", translation=(*place, 0.0))
    start(sim, run_node)

    def away():
        two = sim.latest("/turtle2/pose")
        return math.dist((two.x, two.y), place)

    sim.run_until(lambda: away() < 1.0, 15.0)
    expect(
        away() < 1.0,
        f"the frame turtle1 was not where the turtle was drawn; after 15 s turtle2 was {away():.1f} m from the frame",
        hint="Take the place of turtle1 from tf, with lookupTransform('turtle2', 'turtle1', ...), not from its topic pose.",
    )
