"""Exercise 3.3, public checks: a second turtle that follows the first."""

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.answers import given_answer
from grader.checks.given import broadcast_turtle, without_broadcasters
from oracles.pursuit import bearing, come_near, drive, gap, samples, usual_bearing
from oracles.turtles import TurtleWatch

SCRIPT = "turtle_tf_listener.py"
LAUNCH = "start_turtles.launch"


@pytest.fixture
def chase(sim, run_node):
    """Turtlesim, both turtles' frames, and the student's node; call it to wait for turtle2."""
    sim.rosrun("turtlesim", "turtlesim_node")
    for turtle in ("turtle1", "turtle2"):
        broadcast_turtle(sim, turtle)

    def begin():
        node = run_node(SCRIPT)
        expect_turtle2(sim)
        return node

    return begin


def expect_turtle2(sim):
    """Let time pass until turtle2 is there."""
    expect(
        sim.run_until(lambda: "/turtle2/pose" in sim.topics() and sim.latest("/turtle2/pose"), 2.0),
        "there is no turtle2 after 2 s",
        hint="Wait for the service spawn, then call it with 4, 2, 0 and 'turtle2'.",
    )


@points(1)
def test_it_spawns_turtle2(sim, run_node):
    """The script asks for a second turtle: turtle2, at x = 4, y = 2, looking along the x axis."""
    sim.rosrun("turtlesim", "turtlesim_node")
    watch = TurtleWatch(sim, ["turtle1", "turtle2"])
    node = run_node(SCRIPT)
    expect_turtle2(sim)
    sim.run(0.1)
    first = watch.poses("turtle2")[0]
    expect_close(
        (first.x, first.y, first.theta),
        (4.0, 2.0, 0.0),
        tolerance=0.05,
        what="the pose (x, y, theta) of the new turtle",
        hint="The arguments of the service are x, y, theta and the name, in this order.",
    )
    expect(
        not node.refusals,
        node.refusals[0] if node.refusals else "",
        hint="This node spawns turtle2, and drives only turtle2.",
    )


@points(1)
@after("test_it_spawns_turtle2")
def test_it_survives_until_the_frames_are_there(sim, run_node):
    """The script goes on when its first lookups fail, and drives as soon as the frames are known."""
    sim.rosrun("turtlesim", "turtlesim_node")
    node = run_node(SCRIPT)
    sim.run(1.5)
    expect(
        node.alive,
        "the script ended while tf did not know the turtles yet; "
        "right after the start every lookup fails, so it belongs in a try block",
        hint="In the except block, sleep and go on: a moment later tf knows the turtles.",
    )
    for turtle in ("turtle1", "turtle2"):
        broadcast_turtle(sim, turtle)
    expect_to_move(sim, 3.0)


def expect_to_move(sim, seconds):
    """Within some seconds turtle2 is no longer where it was."""
    before = sim.latest("/turtle2/pose")
    expect(
        sim.run_until(lambda: gap(sim.latest("/turtle2/pose"), before) > 0.1, seconds),
        "turtle2 does not move, although tf knows both turtles",
        hint="Does the lookup succeed? Ask for the latest transform, rospy.Time(0). Then publish a Twist on "
        "turtle2/cmd_vel each time round the loop; linear.x is the speed.",
    )


@points(1)
@after("test_it_spawns_turtle2")
def test_it_comes_to_turtle1(sim, chase, rng):
    """When turtle1 stands still somewhere, turtle2 comes nearer than 1 m within 20 s."""
    chase()
    sim.call("/turtle1/teleport_absolute", rng.uniform(6, 10), rng.uniform(6, 10), 1.0)
    sim.run(0.1)
    expect_to_move(sim, 3.0)
    nearest = come_near(sim, 1.0, timeout=20.0)
    expect(
        nearest < 1.0,
        f"turtle2 came as near as {nearest:.1f} m to turtle1, and no nearer",
        hint="You need turtle1 seen from turtle2: lookupTransform('turtle2', 'turtle1', ...). "
        "The distance gives the speed, and the direction gives the turn rate.",
    )
    farthest = max(gap(two, one) for one, two in samples(sim, 4.0))
    expect(
        farthest < 1.5,
        f"turtle2 was with turtle1, but then went {farthest:.1f} m away",
        hint="Near turtle1 it must be slow: make the speed 0.5 times the distance.",
    )


@points(1)
@after("test_it_spawns_turtle2")
def test_it_looks_at_turtle1(sim, chase, rng):
    """On its way turtle2 turns towards turtle1, and goes straight to it."""
    chase()
    sim.call("/turtle1/teleport_absolute", rng.uniform(1, 2), rng.uniform(8, 10), 0.0)
    expect_to_move(sim, 3.0)
    sim.run(2.0)
    angles = sorted(bearing(two, one) for one, two in samples(sim, 3.0) if gap(two, one) > 0.5)
    middle = angles[len(angles) // 2] if angles else 0.0
    expect(
        abs(middle) < 0.35,
        f"on its way turtle2 looks {abs(middle):.1f} rad past turtle1, which is on its "
        f"{'left' if middle > 0 else 'right'}",
        hint="The angle to turn by is atan2(y, x) of turtle1 seen from turtle2, y first; "
        "a positive turn rate turns to the left.",
    )


@points(1)
@after("test_it_comes_to_turtle1", "test_it_looks_at_turtle1")
def test_it_follows_a_turtle_that_drives(sim, chase):
    """When turtle1 drives a circle of radius 2 m, turtle2 follows, never more than 2.5 m behind."""
    chase()
    drive(sim, speed=1.0, turn_rate=0.5)
    sim.run(5.0)
    expect_to_follow(samples(sim, 5.0))


def expect_to_follow(seen):
    """For some seconds turtle2 kept near to turtle1, drove, and looked at it."""
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
        hint="Make the turn rate four times the angle to turtle1, and look turtle1 up each time round the loop.",
    )


@points(1)
@after("test_it_comes_to_turtle1")
def test_the_launch_file_starts_it_all(sim, launch_plan, roslaunch):
    """The launch file starts turtlesim, a broadcaster for each turtle, and the listener: turtle2 comes."""
    plan, turtles = without_broadcasters(launch_plan(LAUNCH))
    served = " and ".join(turtles) or "no turtle"
    expect(
        turtles == ["turtle1", "turtle2"],
        f"turtle_tf_broadcaster.py is started for {served}, not for turtle1 and turtle2",
        hint='One <node> for each turtle, the second with args="_turtle:=turtle2".',
    )
    roslaunch(plan)
    for turtle in turtles:
        broadcast_turtle(sim, turtle)
    sim.run(0.5)
    expect(
        "/spawn" in sim.services(),
        "no turtlesim was started",
        hint='turtlesim is a <node> too: pkg="turtlesim" type="turtlesim_node".',
    )
    expect(
        sim.run_until(lambda: "/turtle2/pose" in sim.topics() and sim.latest("/turtle2/pose"), 2.0),
        "the launch file was started, but there is no turtle2",
        hint=f'Is your listener among the nodes? It has pkg="hello_ros" type="{SCRIPT}".',
    )
    nearest = come_near(sim, 1.0, timeout=20.0)
    expect(
        nearest < 1.0,
        f"everything is started, but turtle2 comes no nearer than {nearest:.1f} m",
        hint="Does a namespace (ns=) or a <remap> in the launch file change the names of topics?",
    )


@points(1)
@after("test_it_follows_a_turtle_that_drives")
def test_your_answers(submission, sim, chase):
    """The answers give the broadcaster's argument, and the distance at which turtle2 settles."""
    argument = given_answer(submission, "broadcaster_argument")
    expect(
        isinstance(argument, str) and argument.replace(" ", "").strip("\"'") == "_turtle:=turtle2",
        "broadcaster_argument does not make the node of exercise 3.1 broadcast turtle2",
        hint="A private parameter ~name is set on the command line with _name:=value.",
    )
    chase()
    drive(sim, speed=1.0, turn_rate=0.5)
    sim.run(9.0)  # it is settled to 1 cm
    expect_close(
        given_answer(submission, "settled_distance"),
        gap(sim.latest("/turtle2/pose"), sim.latest("/turtle1/pose")),
        tolerance=0.1,
        what="settled_distance",
        unit="m",
        hint="Read it off at the right end of the plot, where the curve is flat.",
    )
