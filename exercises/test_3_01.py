"""Exercise 3.1, public checks: the turtle's pose is broadcast as a transform."""

import math

import pytest

from grader.checks import after, expect, expect_close, expect_close_angle, points
from oracles.turtles import TurtleWatch, turned, yaw_of

SCRIPT = "turtle_tf_broadcaster.py"
SEND = "sendTransform(translation, rotation, time, child, parent)"


@pytest.fixture
def turtle(sim, run_node):
    """Turtlesim and the student's node, with a recording; call it to drive for some seconds."""
    sim.rosrun("turtlesim", "turtlesim_node")
    watch = TurtleWatch(sim)
    watch.node = run_node(SCRIPT)
    sim.run(0.5)

    def drive(seconds, speed, turn_rate):
        command = {"linear": {"x": speed}, "angular": {"z": turn_rate}}
        driver = sim.rostopic_pub("/turtle1/cmd_vel", "geometry_msgs/Twist", command, rate=10)
        sim.run(seconds)
        driver.shutdown()

    watch.drive = drive
    return watch


@points(1)
def test_the_node_keeps_running(turtle):
    """The script starts, and keeps running while the turtle lives."""
    turtle.drive(1.0, 1.0, 0.0)
    expect(
        turtle.node.alive,
        "the script ended by itself within 1.5 s",
        hint="A subscriber works only while the script runs: end the script with rospy.spin().",
    )
    refusals = turtle.node.refusals
    expect(
        not refusals,
        refusals[0] if refusals else "",
        hint="This node only subscribes to the turtle's pose and broadcasts its transform.",
    )


@points(2)
@after("test_the_node_keeps_running")
def test_the_frames_are_world_and_turtle1(turtle):
    """A transform from the frame world to the frame turtle1 is broadcast."""
    turtle.drive(1.0, 1.0, 0.0)
    heard = turtle.transforms()
    expect(
        heard,
        "no transform was received on /tf",
        hint="Does the node subscribe to /turtle1/pose, and does the callback call sendTransform?",
    )
    pairs = sorted({(transform.parent, transform.child) for transform in heard})
    expect(
        ("turtle1", "world") not in pairs,
        "parent and child are swapped: world is the child of turtle1",
        hint=f"The child comes before the parent: {SEND}.",
    )
    expect(
        pairs == [("world", "turtle1")],
        "expected the one transform world -> turtle1, got "
        + ", ".join(f"{parent} -> {child}" for parent, child in pairs),
        hint='The parent is "world", and the child has the turtle\'s name. Capital letters count.',
    )


@points(1)
@after("test_the_frames_are_world_and_turtle1")
def test_it_is_sent_again_and_again_with_its_time(turtle):
    """The transform is sent at least ten times a second, each stamped with the time it is valid for."""
    turtle.drive(2.0, 1.0, 0.0)
    heard = turtle.of_frame("turtle1")
    expect(
        len(heard) >= 20,
        f"{len(heard)} transforms were received in 2.5 s; expected at least 20",
        hint="Send a transform for every pose: sendTransform belongs in the callback.",
    )
    expect(
        all(transform.stamp > 0 for transform in heard),
        "the stamp is zero",
        hint="A transform without a time cannot be looked up: give rospy.Time.now() as the time.",
    )
    oldest = max(abs(transform.time - transform.stamp) for transform in heard)
    expect(
        oldest <= 0.1,
        f"the stamp of a transform is {oldest:.3f} s away from the time at which it was sent",
        hint="Stamp each transform with rospy.Time.now() at the moment you send it.",
    )


@points(1)
@after("test_the_frames_are_world_and_turtle1")
def test_the_position_follows_the_turtle(turtle, rng):
    """While the turtle drives, the transform's translation is the turtle's position."""
    turtle.drive(2.0, rng.uniform(0.8, 1.6), rng.uniform(-0.4, 0.4))
    for transform in turtle.of_frame("turtle1")[5:]:
        pose = turtle.pose_at(transform.time)
        x, y, z = transform.translation
        expect(
            math.dist((x, y), (pose.y, pose.x)) > 1e-3 or abs(pose.x - pose.y) < 1e-2,
            "x and y are swapped",
            hint="The translation is (msg.x, msg.y, 0).",
        )
        expect_close(
            (x, y, z),
            (pose.x, pose.y, 0.0),
            tolerance=0.05,
            what="the position of turtle1",
            unit="m",
            frame="world",
            hint="The translation is the turtle's position, (msg.x, msg.y, 0): turtles live in the plane.",
        )


@points(2)
@after("test_the_position_follows_the_turtle")
def test_the_orientation_follows_the_turtle(turtle, rng):
    """While the turtle drives a circle, the transform's rotation is the turtle's heading."""
    turtle.drive(3.0, 1.0, rng.choice([-1, 1]) * rng.uniform(0.9, 1.4))
    samples = [
        (transform.rotation, turtle.pose_at(transform.time).theta)
        for transform in turtle.of_frame("turtle1")[5:]
    ]
    # A large angle shows a mistake more clearly than a small one, so it is looked at first.
    for rotation, theta in sorted(samples, key=lambda sample: abs(abs(sample[1]) - 1.2)):
        expect_a_heading(rotation, theta)


def expect_a_heading(rotation, theta):
    """The quaternion is the heading theta; if not, say which usual mistake it is."""
    x, y, z, w = rotation
    norm = math.sqrt(x * x + y * y + z * z + w * w)
    expect(
        not (abs(z - theta) < 1e-3 and abs(theta) > 0.1 and abs(x) + abs(y) < 1e-3),
        f"the angle {theta:.3f} was written into the quaternion itself: {_shown(rotation)}",
        hint="A quaternion does not hold angles: "
        "use tf.transformations.quaternion_from_euler(0, 0, msg.theta).",
    )
    expect(
        abs(norm - 1.0) <= 0.01,
        f"the quaternion {_shown(rotation)} has length {norm:.3f}; tf refuses it",
        hint="Only quaternions of length 1 are rotations: "
        "use tf.transformations.quaternion_from_euler(0, 0, msg.theta).",
    )
    got = yaw_of(rotation)
    if turned(got, theta) > 0.06 or abs(x) > 0.02:
        _name_the_mistake(rotation, got, theta)
    expect_close_angle(
        got,
        theta,
        tolerance=0.06,
        what="the heading of turtle1",
        frame="world",
        hint="The rotation is quaternion_from_euler(0, 0, msg.theta): roll and pitch are zero.",
    )
    expect(
        abs(x) + abs(y) < 0.02,
        f"turtle1 is tilted out of the plane: {_shown(rotation)}",
        hint="The heading is the third angle, the yaw: quaternion_from_euler(0, 0, msg.theta).",
    )


def _name_the_mistake(rotation, got, theta):
    x, y, z, w = rotation
    expect(
        abs(x) < 0.02 or turned(yaw_of((y, z, w, x)), theta) > 0.06,
        f"the quaternion {_shown(rotation)} begins with w",
        hint="ROS writes a quaternion as (x, y, z, w), with the w last.",
    )
    expect(
        turned(got, math.degrees(theta)) > 0.06,
        f"the heading is {got:.3f} rad, but the turtle's is {theta:.3f} rad: degrees were taken for radians",
        hint="msg.theta is in radians, and quaternion_from_euler expects radians: nothing has to be converted.",
    )
    expect(
        turned(got, -theta) > 0.06,
        f"the heading is {got:.3f} rad, but the turtle's is {theta:.3f} rad: the frame turns the other way",
        hint="Angles count counter-clockwise both in msg.theta and in quaternion_from_euler: no minus sign is needed.",
    )


def _shown(rotation):
    return "(" + ", ".join(f"{number:.3f}" for number in rotation) + ")"
