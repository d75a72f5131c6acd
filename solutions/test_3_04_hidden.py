"""Exercise 3.4, hidden checks: a detour that only the past shows, and two seconds that stay two."""

import math

import pytest

from grader.checks import expect, expect_close, points
from grader.checks.given import broadcast_turtle
from oracles.pursuit import bearing, come_near, come_to_rest, reaction_time

SCRIPT = "turtle_tf_listener_time_travel.py"


@pytest.fixture
def chase(sim, run_node):
    """Turtlesim, both turtles' frames, and the student's node that has come to turtle1."""
    sim.rosrun("turtlesim", "turtlesim_node")
    sim.run(0.1)
    sim.call("/turtle1/teleport_absolute", 4.7, 2.0, 0.0)  # turtle2 will have a short way
    for turtle in ("turtle1", "turtle2"):
        broadcast_turtle(sim, turtle)
    run_node(SCRIPT)
    sim.run(4.0)
    expect(
        "/turtle2/pose" in sim.topics() and sim.latest("/turtle2/pose"),
        "there is no turtle2 after 4 s",
        hint="Spawn it as in exercise 3.3: call the service spawn with 4, 2, 0 and 'turtle2'.",
    )
    come_near(sim, 1.0, timeout=20.0)
    come_to_rest(sim, timeout=10.0)
    return sim


@points(2)
def test_it_heads_for_a_place_that_turtle1_has_left(chase, rng):
    """When turtle1 jumps to one place and then to another, turtle2 heads for them one by one."""
    side = rng.choice([-1, 1])
    first = (5.5 + side * rng.uniform(3, 4), rng.uniform(8, 10), 0.0)
    second = (5.5 - side * rng.uniform(3, 4), rng.uniform(1, 3), 0.0)
    chase.call("/turtle1/teleport_absolute", *first)
    chase.run(1.3)
    target = chase.latest("/turtle1/pose")
    chase.call("/turtle1/teleport_absolute", *second)
    chase.run(1.75)  # 3.05 s after the first jump, 1.75 s after the second
    angle = bearing(chase.latest("/turtle2/pose"), target)
    expect(
        abs(angle) < 0.5,
        f"turtle2 looks {abs(angle):.1f} rad past the place where turtle1 was 2 s ago",
        hint="Look up turtle2 where it is now, and turtle1 where it was 2 s ago.",
    )
    chase.run(2.25)
    angle = bearing(chase.latest("/turtle2/pose"), chase.latest("/turtle1/pose"))
    expect(
        abs(angle) < 0.5,
        f"4 s after the last jump turtle2 still looks {abs(angle):.1f} rad past turtle1",
        hint="Two seconds after the jump it must turn to the place that turtle1 jumped to.",
    )


@points(1)
def test_it_stays_two_seconds_late(chase, rng):
    """Longer than tf remembers after the start, turtle2 is still two seconds late."""
    chase.run(5.0)
    angle = rng.uniform(-math.pi, math.pi)
    pose = chase.latest("/turtle1/pose")
    away = (pose.x + 3 * math.cos(angle), pose.y + 3 * math.sin(angle), 0.0)
    late = reaction_time(chase, away, timeout=8.0)
    expect(
        late is not None,
        "turtle2 did not set out within 8 s after turtle1 had jumped away",
        hint="Compute now and past each time round the loop.",
    )
    expect_close(
        late,
        2.2,
        tolerance=0.4,
        what="the delay with which turtle2 follows",
        unit="s",
        hint="Set past to now - rospy.Duration(2.0), and compute both again each time round the loop.",
    )
