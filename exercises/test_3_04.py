"""Exercise 3.4, public checks: turtle2 follows to where turtle1 was two seconds ago."""

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.answers import given_answer, words_of
from grader.checks.given import broadcast_turtle
from oracles.pursuit import (
    come_near,
    come_to_rest,
    drive,
    gap,
    reaction_time,
    samples,
    usual_bearing,
)

SCRIPT = "turtle_tf_listener_time_travel.py"
DELAY = 2.0


@pytest.fixture
def turtlesim(sim):
    """Turtlesim."""
    sim.rosrun("turtlesim", "turtlesim_node")
    sim.run(0.1)


@pytest.fixture
def near(sim, turtlesim):
    """Turtle1 waits near the place where turtle2 will appear."""
    sim.call("/turtle1/teleport_absolute", 4.7, 2.0, 0.0)


@pytest.fixture
def circling(sim, turtlesim):
    """Turtle1 drives on a circle from the beginning."""
    drive(sim, speed=1.0, turn_rate=0.5)


@pytest.fixture
def chase(sim, turtlesim, run_node):
    """Turtlesim, both turtles' frames, the student's node, and three seconds of patience."""
    for turtle in ("turtle1", "turtle2"):
        broadcast_turtle(sim, turtle)
    node = run_node(SCRIPT)
    sim.run(3.0)
    expect(
        "/turtle2/pose" in sim.topics() and sim.latest("/turtle2/pose"),
        "there is no turtle2 after 3 s",
        hint="Spawn it as in exercise 3.3: call the service spawn with 4, 2, 0 and 'turtle2'.",
    )
    return node


@points(1)
def test_it_survives_the_time_without_a_past(sim, chase):
    """The script spawns turtle2, and keeps running while tf does not reach back far enough yet."""
    sim.run(1.0)
    expect(
        chase.alive,
        "the script ended while tf did not know the past yet; "
        "waiting and lookup both belong in one try block, with except tf.Exception",
        hint="In the except block, sleep and continue: a few seconds later tf knows the past.",
    )
    expect(
        not chase.refusals,
        chase.refusals[0] if chase.refusals else "",
        hint="This node spawns turtle2, and drives only turtle2.",
    )


@points(2)
@after("test_it_survives_the_time_without_a_past")
def test_it_comes_to_a_turtle_that_stands(sim, chase, rng):
    """When turtle1 stands still, turtle2 comes nearer than 1 m within 25 s, and stays there."""
    place = (rng.uniform(6, 9), rng.uniform(6, 9), rng.uniform(-1, 1))
    sim.call("/turtle1/teleport_absolute", *place)
    sim.run(0.1)
    before = sim.latest("/turtle2/pose")
    nearest = come_near(sim, 1.0, timeout=25.0)
    expect(
        gap(sim.latest("/turtle2/pose"), before) > 0.1,
        "turtle2 does not move",
        hint="Does the lookup ever succeed? Call waitForTransformFull before it, "
        "with the same frames and times.",
    )
    expect(
        nearest < 1.0,
        f"turtle2 came as near as {nearest:.1f} m to turtle1, and no nearer",
        hint="Look up turtle2 where it is now, and only turtle1 where it was: "
        "lookupTransformFull('turtle2', now, 'turtle1', past, 'world').",
    )
    farthest = max(gap(two, one) for one, two in samples(sim, 3.0))
    expect(
        farthest < 1.5,
        f"turtle2 was with turtle1, but then went {farthest:.1f} m away",
        hint="Look up turtle2 where it is now, and only turtle1 where it was: "
        "lookupTransformFull('turtle2', now, 'turtle1', past, 'world').",
    )


@points(2)
@after("test_it_comes_to_a_turtle_that_stands")
def test_it_is_two_seconds_late(sim, near, chase, rng):
    """When turtle1 jumps away, turtle2 sets out two seconds later: it follows the past."""
    sim.run(2.0)  # by now it is on its way
    come_near(sim, 1.0, timeout=25.0)
    come_to_rest(sim, timeout=10.0)
    jump = (rng.uniform(1, 3), rng.uniform(8, 10), 0.0)
    late = reaction_time(sim, jump, timeout=8.0)
    expect(
        late is not None,
        "turtle2 did not set out within 8 s after turtle1 had jumped away",
        hint="Set past to now - rospy.Duration(2.0), and compute both again each time round the loop.",
    )
    expect(
        late > 1.0,
        f"turtle2 set out {late:.1f} s after turtle1: it follows the present",
        hint="Pass past, 2 s before now, as the time of turtle1.",
    )
    expect_close(
        late,
        DELAY + 0.2,
        tolerance=0.4,
        what="the delay with which turtle2 follows",
        unit="s",
        hint="The book begins with 5 s; what you hand in has 2: past = now - rospy.Duration(2.0).",
    )


@points(1)
@after("test_it_is_two_seconds_late")
def test_it_follows_on_a_circle(sim, circling, chase):
    """While turtle1 drives a circle, turtle2 drives to where turtle1 was two seconds ago."""
    sim.run(3.0)
    seen = samples(sim, 5.0)
    late = round(DELAY / 0.1)
    pairs = [(one, two) for (one, _), (_, two) in zip(seen, seen[late:], strict=False)]
    farthest = max(gap(two, past) for past, two in pairs)
    expect(
        farthest < 2.5,
        f"turtle2 was {farthest:.1f} m away from where turtle1 had been 2 s before",
        hint="Compute now and past each time round the loop, and send the command at once.",
    )
    angle = usual_bearing(pairs)
    expect(
        angle < 0.8,
        f"turtle2 looks up to {angle:.1f} rad past the place where turtle1 was 2 s ago",
        hint="Look up turtle2 where it is now, and only turtle1 where it was 2 s ago.",
    )


@points(1)
def test_your_answers(submission):
    """The answers name the frame that stands still, and say why to wait and how long tf remembers."""
    expect(
        words_of(given_answer(submission, "frame_that_stands")) == ["world"],
        "frame_that_stands is not the frame that does not move between the two times",
        hint="Both turtles move. It is the fifth argument of lookupTransformFull.",
    )
    waiting = [word.lower() for word in words_of(given_answer(submission, "without_waiting"))]
    expect(
        waiting == ["future"],
        "2 s ago is well within what tf remembers; it is the other time that tf lacks"
        if waiting == ["past"]
        else 'without_waiting is not one of the two words: write "past" or "future"',
        hint="Compare now with the stamp of the newest transform that has arrived: which of the two is later?",
    )
    expect_close(
        given_answer(submission, "longest_delay"),
        10.0,
        tolerance=0.5,
        what="longest_delay",
        unit="s",
        hint="Run the cell with more delays, between the last one that works and the first one that fails.",
    )
