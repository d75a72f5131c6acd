"""Exercise 3.2, public checks: a carrot ahead of the turtle, and one that circles around it."""

import math
from itertools import pairwise

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.answers import given_answer, words_of
from grader.checks.given import broadcast_turtle
from oracles.frames import age_of, expect_frame
from oracles.turtles import TurtleWatch

FIXED = "fixed_tf_broadcaster.py"
MOVING = "moving_tf_broadcaster.py"
SLOWEST = 70.0  # the longest time that one revolution may take [s]
MOST = 200  # transforms a second: more is never needed


@pytest.fixture
def watch(sim):
    """Turtlesim, the turtle's frame, and a recording of everything that is received."""
    sim.rosrun("turtlesim", "turtlesim_node")
    broadcast_turtle(sim)
    return TurtleWatch(sim)


@pytest.fixture
def drive(sim):
    """Drive turtle1: `drive(seconds, speed, turn_rate)`."""

    def run(seconds, speed, turn_rate):
        command = {"linear": {"x": speed}, "angular": {"z": turn_rate}}
        driver = sim.rostopic_pub("/turtle1/cmd_vel", "geometry_msgs/Twist", command, rate=10)
        sim.run(seconds)
        driver.shutdown()

    return run


def expect_to_run(node):
    """A script is still running, and did only what it may do."""
    expect(
        node.alive,
        "the script ended by itself within 2 s",
        hint="Send in a loop: while not rospy.is_shutdown(): ... rate.sleep()",
    )
    expect(
        not node.refusals,
        node.refusals[0] if node.refusals else "",
        hint="This node only broadcasts one frame.",
    )


def expect_pauses(count, seconds):
    """A script does not send as fast as it can."""
    expect(
        count <= MOST * seconds,
        f"the transform is sent {count / seconds:.0f} times a second, as fast as the script can",
        hint="Sleep in the loop: rate.sleep(). A node that never sleeps floods every node that listens to tf.",
    )


@points(1)
def test_the_fixed_carrot_hangs_on_the_turtle(sim, watch, run_node):
    """fixed_tf_broadcaster.py keeps running, and broadcasts carrot1 with turtle1 as its parent."""
    node = run_node(FIXED)
    sim.run(2.0)
    expect_to_run(node)
    expect_frame(watch.transforms(), child="carrot1", parent="turtle1", given=["turtle1"])


@points(1)
@after("test_the_fixed_carrot_hangs_on_the_turtle")
def test_the_carrot_is_two_metres_ahead(sim, watch, run_node, drive, rng):
    """However the turtle drives, carrot1 is 2 m ahead of it, and looks where the turtle looks."""
    run_node(FIXED)
    for _ in range(2):
        drive(1.0, rng.uniform(0.5, 1.5), rng.uniform(-1.5, 1.5))
        place = sim.tf.lookup_transform("turtle1", "carrot1").transform
        expect_close(
            (place.translation.x, place.translation.y, place.translation.z),
            (2.0, 0.0, 0.0),
            tolerance=0.01,
            what="the position of carrot1",
            unit="m",
            frame="turtle1",
            hint="In the frame of the turtle x points forward, y to the left, z up.",
        )
        turn = place.rotation
        expect_close(
            (turn.x, turn.y, turn.z, abs(turn.w)),
            (0.0, 0.0, 0.0, 1.0),
            tolerance=0.01,
            what="the rotation of carrot1",
            frame="turtle1",
            hint="No rotation is the quaternion (0, 0, 0, 1): x, y, z, and the w last.",
        )


@points(1)
@after("test_the_fixed_carrot_hangs_on_the_turtle")
def test_the_carrot_can_be_looked_up_at_any_time(sim, watch, run_node, drive, rng):
    """At every moment tf knows where carrot1 is, and the node does not flood tf with transforms."""
    run_node(FIXED)
    drive(1.0, 1.0, 0.5)
    expect_pauses(len(watch.of_frame("carrot1")), 1.0)
    timeless = [one for one in watch.of_frame("carrot1") if one.stamp == 0]
    expect(
        not timeless or sim.tf.can_transform("world", "carrot1"),
        "the stamp is zero",
        hint="A transform without a time cannot be looked up: give rospy.Time.now() as the time.",
    )
    for _ in range(5):
        sim.run(rng.uniform(0.2, 0.6))
        age = age_of(sim, "carrot1", "turtle1")
        expect(
            age <= 0.3,
            f"the newest transform of carrot1 is {age:.2f} s old",
            hint="Send ten times a second, each time with rospy.Time.now().",
        )


@points(1)
def test_the_moving_carrot_hangs_on_the_turtle(sim, watch, run_node):
    """moving_tf_broadcaster.py keeps running, and broadcasts carrot1 with turtle1 as its parent."""
    node = run_node(MOVING)
    sim.run(2.0)
    expect_to_run(node)
    own = expect_frame(watch.transforms(), child="carrot1", parent="turtle1", given=["turtle1"])
    expect(
        all(abs(one.time - one.stamp) <= 0.1 for one in own),
        "the stamps are not the times at which the transforms were sent",
        hint="Give rospy.Time.now() as the time of each transform.",
    )


@points(1)
@after("test_the_moving_carrot_hangs_on_the_turtle")
def test_the_moving_carrot_keeps_two_metres(sim, watch, run_node):
    """The moving carrot1 is always 2 m from the turtle, at the turtle's height."""
    run_node(MOVING)
    sim.run(8.0)
    for transform in watch.of_frame("carrot1"):
        x, y, z = transform.translation
        expect_close(
            z,
            0.0,
            tolerance=0.01,
            what="the height of carrot1",
            unit="m",
            frame="turtle1",
            hint="The circle lies in the plane of the turtle: x and y change, and z is 0.",
        )
        expect_close(
            math.hypot(x, y),
            2.0,
            tolerance=0.05,
            what="the distance of carrot1 from the turtle",
            unit="m",
            hint="x is 2 times the cosine of an angle, and y is 2 times the sine of the same angle.",
        )


@points(1)
@after("test_the_moving_carrot_keeps_two_metres")
def test_the_moving_carrot_circles(sim, watch, run_node):
    """The moving carrot1 goes all the way around the turtle, at any speed, and never turns back."""
    run_node(MOVING)
    begin, turned = sim.now.to_sec(), 0.0
    while abs(turned) < 1.2 * math.tau and sim.now.to_sec() < begin + SLOWEST:
        sim.run(3.0)
        places = [one.translation for one in watch.of_frame("carrot1")]
        expect_pauses(len(places), sim.now.to_sec() - begin)
        angles = [math.atan2(y, x) for x, y, _ in places]
        steps = [math.remainder(b - a, math.tau) for a, b in pairwise(angles)]
        turned = sum(steps)
    expect(
        steps,
        f"{len(angles)} transforms of carrot1 were received in {SLOWEST:.0f} s",
        hint="Send in a loop, ten times a second.",
    )
    expect(
        max(angles) - min(angles) > 0.01,
        "carrot1 stands still",
        hint="Compute the angle from the time: rospy.Time.now().to_sec() grows by one each second.",
    )
    expect_all_around(angles)
    sense = [step for step in steps if step * turned > 0]
    expect(
        len(sense) >= 0.95 * len([step for step in steps if abs(step) > 1e-9]),
        "carrot1 swings to and fro instead of going around",
        hint="Let the angle grow with the time and never shrink; sine and cosine do the rest.",
    )


def expect_all_around(angles):
    """Seen from the turtle, the directions leave no large gap."""
    directions = sorted({round(angle, 2) for angle in angles})
    gaps = [b - a for a, b in pairwise(directions)]
    gap = max([*gaps, math.tau - directions[-1] + directions[0]])
    expect(
        gap < 2.2 or len(directions) > 4,
        f"carrot1 only jumps between {len(directions)} places",
        hint="The carrot goes too far between two transforms: let it circle more slowly, or send more often.",
    )
    expect(
        gap < 2.2,
        f"carrot1 does not go all the way around: it leaves out {math.degrees(gap):.0f} degrees",
        hint="One coordinate is the cosine, the other the sine of the same angle, which grows with the time.",
    )


@points(0.5)
def test_what_tf_echo_prints(submission):
    """The answers give the position of carrot1 seen from turtle1, and the printout that changes."""
    expect_close(
        given_answer(submission, "carrot_seen_from_turtle"),
        (2.0, 0.0, 0.0),
        tolerance=0.01,
        what="carrot_seen_from_turtle",
        unit="m",
        hint="Read the line Translation that tf_echo turtle1 carrot1 prints, as three numbers.",
    )
    words = words_of(given_answer(submission, "changes_while_driving"))
    expect(
        "world" in words and "turtle1" not in words,
        'changes_while_driving is not one of the two: write "world carrot1" or "turtle1 carrot1"'
        if ("world" in words) == ("turtle1" in words)
        else "seen from turtle1, carrot1 stays where it is, however the turtle drives",
        hint="Compare the printouts of the two cells: in which one do the numbers differ?",
    )


@points(0.5)
def test_which_frame_is_seen_from_which(submission):
    """The answers say which frame tf_echo shows, seen from which frame, and which frame stands still."""
    pose_of = words_of(given_answer(submission, "pose_of"))
    seen_from = words_of(given_answer(submission, "seen_from"))
    expect(
        (pose_of, seen_from) != (["world"], ["carrot1"]),
        "pose_of and seen_from are the wrong way round",
        hint="tf_echo turtle1 carrot1 prints 2 m forward: the carrot is ahead of the turtle. "
        "So whose pose is printed, and from which frame is it seen?",
    )
    expect(
        (pose_of, seen_from) == (["carrot1"], ["world"]),
        "pose_of and seen_from must be the two frames of tf_echo world carrot1",
        hint='Each answer is one name, "world" or "carrot1".',
    )
    expect(
        words_of(given_answer(submission, "fixed_frame")) == ["world"],
        "fixed_frame is not the frame that stands still while the turtle drives",
        hint="It is the frame that your broadcaster of exercise 3.1 used as the turtle's parent.",
    )
