"""Exercise 3.5, public checks: four lookups that failed, and a point that changes its frame."""

import pytest

from grader.checks import expect, expect_close, points
from grader.checks.answers import given_answer, words_of
from grader.checks.given import broadcast_frame, broadcast_turtle
from oracles.frames import expect_frame
from oracles.pursuit import ahead_of, drive, seen_from
from oracles.turtles import TurtleWatch, last_before

BRIDGE = "point_bridge.py"
CAUSES = ("missing", "future", "past", "disconnected")


@pytest.fixture
def scene(sim, rng):
    """Turtlesim with a turtle that drives and one that stands, their frames, and a recording."""
    sim.rosrun("turtlesim", "turtlesim_node")
    sim.call("/spawn", rng.uniform(2, 9), rng.uniform(1, 4), rng.uniform(-3, 3), "turtle2")
    watch = TurtleWatch(sim, ["turtle1", "turtle2"])
    for turtle in ("turtle1", "turtle2"):
        broadcast_turtle(sim, turtle)
    drive(sim, speed=rng.uniform(0.4, 0.6), turn_rate=rng.uniform(0.2, 0.4))
    return watch


@pytest.fixture
def places(sim):
    """All that is heard on /place."""
    recording = sim.record({"/place": "geometry_msgs/Point"})

    def heard(since):
        return [
            (time.to_sec(), (point.x, point.y, point.z))
            for time, point in recording["/place"]
            if time.to_sec() >= since
        ]

    return heard


def expect_often(heard, seconds, node):
    """A listener has published, at least five times a second."""
    expect(
        len(heard) >= 5 * seconds,
        f"{len(heard)} places were received on /place in {seconds:.0f} s"
        + ("" if node.alive else "; the script had ended"),
        hint="look() must return what the lookup returns, and None only while tf cannot answer.",
    )
    expect(
        not node.refusals,
        node.refusals[0] if node.refusals else "",
        hint="A listener of this exercise publishes only on /place.",
    )


def expect_cause(submission, name, cause, hint):
    """The answer is the cause of a listener's failure."""
    answer = [word.lower() for word in words_of(given_answer(submission, name))]
    expect(
        len(answer) == 1 and answer[0] in CAUSES,
        f"{name} is none of the four causes",
        hint="Write one of " + ", ".join(f'"{cause}"' for cause in CAUSES) + ".",
    )
    expect(answer == [cause], f'{name} is not "{answer[0]}"', hint=hint)


@points(1)
def test_the_causes_in_the_tree(submission):
    """Listener 1 and listener 4 ask for a path through the tree that does not exist: the answers say why."""
    hint = "A frame that no node broadcasts is missing. Two frames without a path between them are in two trees."
    expect_cause(submission, "cause_1", "missing", hint)
    expect_cause(submission, "cause_4", "disconnected", hint)


@points(1)
def test_the_causes_in_time(submission):
    """Listener 2 and listener 3 ask for a time that tf does not have: the answers say if it is too late or too early."""
    hint = "The text of the exception says whether the requested time is before or after what tf has stored."
    expect_cause(submission, "cause_2", "future", hint)
    expect_cause(submission, "cause_3", "past", hint)


@points(1)
def test_listener_1_sees_turtle1(sim, scene, places, run_node):
    """listener_1.py publishes where turtle1 is, seen from turtle2."""
    node = run_node("listener_1.py")
    sim.run(4.0)
    expect_turtle1_seen_from_turtle2(sim, scene, places, node)


@points(1)
def test_listener_2_sees_turtle1_now(sim, scene, places, run_node):
    """listener_2.py publishes where turtle1 is at this very moment, seen from turtle2."""
    node = run_node("listener_2.py")
    sim.run(4.0)
    expect_turtle1_seen_from_turtle2(sim, scene, places, node)


def expect_turtle1_seen_from_turtle2(sim, scene, places, node):
    """In the last three seconds each place was that of turtle1, in the frame of turtle2."""
    heard = places(sim.now.to_sec() - 3.0)
    expect_often(heard, 3.0, node)
    ones, twos = scene.poses("turtle1"), scene.poses("turtle2")
    for time, place in heard:
        expect_close(
            place,
            (*seen_from(last_before(twos, time), last_before(ones, time)), 0.0),
            tolerance=0.1,
            what="the place that was published",
            unit="m",
            frame="turtle2",
            hint="lookupTransform('turtle2', 'turtle1', time): who looks, who is looked at, when. "
            "The time is the latest, or now.",
        )


@points(1)
def test_listener_3_sees_five_seconds_back(sim, scene, places, run_node):
    """listener_3.py publishes where turtle1 was five seconds ago, as soon as tf reaches back so far."""
    node = run_node("listener_3.py")
    sim.run(11.0)
    heard = places(sim.now.to_sec() - 3.0)
    expect_often(heard, 3.0, node)
    poses = scene.poses("turtle1")
    for time, place in heard:
        past = last_before(poses, time - 5.0)
        expect_close(
            place,
            (past.x, past.y, 0.0),
            tolerance=0.15,
            what="the place that was published",
            unit="m",
            frame="world",
            hint="The delay stays 5 s. Compute the time again in every call: what tf did not know "
            "a moment ago it may know now.",
        )


@points(1)
def test_listener_4_holds_the_carrot(sim, scene, places, run_node):
    """listener_4.py broadcasts carrot1 2 m ahead of turtle1, and publishes where it is in world."""
    node = run_node("listener_4.py")
    sim.run(4.0)
    expect_frame(
        scene.transforms(), child="carrot1", parent="turtle1", given=["turtle1", "turtle2"]
    )
    heard = places(sim.now.to_sec() - 3.0)
    expect_often(heard, 3.0, node)
    poses = scene.poses("turtle1")
    for time, place in heard:
        expect_close(
            place,
            (*ahead_of(last_before(poses, time), 2.0), 0.0),
            tolerance=0.3,
            what="the place of carrot1 that was published",
            unit="m",
            frame="world",
            hint="carrot1 is 2 m ahead of turtle1; look up where carrot1 is, seen from world.",
        )


@points(1)
def test_the_bridge_brings_the_point_to_the_world(sim, scene, run_node):
    """point_bridge.py publishes on /carrot_in_world the point (2, 0, 0) of carrot1, expressed in world."""
    broadcast_frame(sim, "carrot1", "turtle1", translation=(2.0, 0.0, 0.0))
    recording = sim.record({"/carrot_in_world": "geometry_msgs/PointStamped"})
    node = run_node(BRIDGE)
    sim.run(4.0)
    heard = [(time.to_sec(), point) for time, point in recording["/carrot_in_world"]][5:]
    expect(
        len(heard) >= 15,
        f"{len(heard)} points were received on /carrot_in_world in 4 s"
        + ("" if node.alive else "; the script had ended"),
        hint="Transform the point and publish it each time round the loop, as a geometry_msgs/PointStamped.",
    )
    frame = heard[-1][1].header.frame_id.strip("/")
    expect(
        frame == "world",
        f'the frame_id of the published point is "{frame}"',
        hint="Publish what listener.transformPoint('world', point) returns.",
    )
    poses = scene.poses("turtle1")
    for time, stamped in heard:
        pose = last_before(poses, stamped.header.stamp.to_sec() or time)
        expect(
            pose,
            "the stamp of the published point is a time before the turtle was there",
            hint="Use rospy.Time(0) as the stamp, or a time from rospy.Time.now().",
        )
        expect_close(
            (stamped.point.x, stamped.point.y, stamped.point.z),
            (*ahead_of(pose, 4.0), 0.0),
            tolerance=0.3,
            what="the point that was published",
            unit="m",
            frame="world",
            hint="The point is 2 m ahead of the carrot, so 4 m ahead of the turtle: "
            "set its frame_id to carrot1, x = 2, and its stamp to rospy.Time(0).",
        )
