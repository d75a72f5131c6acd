"""Exercise S.1, public checks: a robot with two wheels and a laser that does what it is commanded."""

import math

import pytest

from grader.checks import CheckFailed, after, expect, expect_close, expect_close_angle, points
from grader.checks.answers import given_answer, words_of
from grader.checks.robots import RobotFiles, link_of
from grader.checks.rotations import rotation_of
from grader.checks.worlds import Place, inertia_of
from oracles.driven_robot import (
    DrivenRobot,
    Stand,
    expect_ball,
    heading_of,
    lowest_point,
)

ROBOT = "m2wr.urdf"
LAUNCH = "spawn_urdf.launch"
SCRIPT = "corner.py"
MODEL = "m2wr"
WHEELS = ("link_left_wheel", "link_right_wheel")
SLACK = 0.02
"""By which a turn rate of 0.6 may be off [rad/s]."""
SCAN = "/m2wr/laser/scan"
HALF_WAY, HELD_UP = 0.4, 1.0
"""After how much of its metre the robot is held up [m], and for how long [s]."""
WALL = """
<sdf version="1.6"><model name="wall"><static>true</static><link name="link">
<collision name="c"><geometry><box><size>0.1 2 2</size></box></geometry></collision>
</link></model></sdf>
"""
"""0.1 m thick, 2 m wide and high."""


@pytest.fixture
def robots(exercise, submission, package_path):
    """The student's URDF files."""
    return RobotFiles(exercise, submission, package_path)


@pytest.fixture
def robot(sim, robots):
    """The student's robot on the floor of an empty world."""
    return DrivenRobot(sim, robots.robot(ROBOT), robots.text(ROBOT), name=MODEL)


@pytest.fixture
def launched(sim, roslaunch, launch_plan):
    """The model that the student's launch file has just brought into a world."""
    plan = launch_plan(LAUNCH)
    if not any(node.type == "gzserver" for node in plan.nodes):
        sim.gazebo.unpause()  # as in the tutorial: a world that runs already
    roslaunch(plan)
    if not sim.run_until(lambda: sim.has_world and MODEL in sim.gazebo.spawned, 1.0):
        spawned = sim.gazebo.spawned if sim.has_world else {}
        others = ", ".join(name for name in spawned if name != "ground_plane") or "nothing"
        raise CheckFailed(
            f"a second after the launch {MODEL} is not in the world; apart from the ground it contains: {others}",
            hint="spawn_model of gazebo_ros needs three arguments: -urdf, -param with the name of the parameter, and "
            "-model with the name in the world.",
        )
    sim.gazebo.unpause()
    return sim.gazebo.spawned[MODEL].model


@points(1)
def test_check_urdf_takes_your_robot(robots):
    """check_urdf finds nothing wrong with m2wr.urdf, and there is a link sensor_laser."""
    robots.expect_clean(ROBOT)
    link_of(robots.robot(ROBOT), "sensor_laser")


@points(1)
def test_its_weight_is_where_its_parts_are(robots, robot):
    """Box and wheels have the mass and inertia of solid bodies, and the ball is touched where it is seen."""
    described = robots.robot(ROBOT)
    expect_ball(
        described,
        robot.model,
        link="link_chassis",
        radius=0.05,
        centre=(0.2, 0.0, -0.05),
        wheels=WHEELS,
    )
    _expect_weight(
        described, "link_chassis", 5.0, (0.0395417, 0.1062083, 0.1416667),
        "For a solid box with sides x, y, z: ixx = m (y^2 + z^2) / 12, iyy = m (x^2 + z^2) / 12, izz = m (x^2 + y^2) / 12.",
    )  # fmt: skip
    for wheel in WHEELS:
        _expect_weight(
            described, wheel, 0.2, (0.0005267, 0.001, 0.0005267),
            "The wheel is a cylinder along y: m r^2 / 2 about y, m (3 r^2 + h^2) / 12 about x and z.",
        )  # fmt: skip


@points(1)
def test_the_launch_file_brings_it_into_a_world(sim, robots, launched):
    """After the launch m2wr is in a world, and starts on the floor: neither in it, nor high above it."""
    expect_close(
        lowest_point(robots.robot(ROBOT), launched),
        0.0,
        tolerance=0.02,
        what="the height of its lowest point at the start",
        unit="m",
        frame="world",
        hint="The wheels reach 0.1 m below the origin of link_chassis. spawn_model takes -z with a height.",
    )


@points(1)
def test_it_stands_still(sim, robot):
    """Without a command the robot stays where it is for a second, upright, on both wheels and the ball."""
    start, height = robot.stand, robot.model.pose.translation[2]
    sim.run(1.0)
    moved = robot.stand.seen_from(start)
    expect_close(
        (moved.x, moved.y, robot.model.pose.translation[2] - height),
        (0.0, 0.0, 0.0),
        tolerance=0.003,
        what="how far it moved within a second, without a command",
        unit="m",
        hint="Are the lowest points of its two wheels and the ball at the same height?",
    )
    roll_pitch = robot.model.pose.rotation[:2]
    expect_close(
        (*roll_pitch, moved.heading),
        (0.0, 0.0, 0.0),
        tolerance=0.01,
        what="how far it tilted and turned within a second, without a command",
        unit="rad",
        hint="Is its centre of mass between the two wheels and the ball?",
    )


@points(1)
def test_it_drives_straight_on(robot):
    """Commanded to drive at 0.4 m/s, the robot goes 1 m straight ahead in 2.5 s."""
    moved = robot.drive(0.4, 0.0, settle=0.5, seconds=2.5)
    expect_close(
        (moved.x, moved.y),
        (1.0, 0.0),
        tolerance=0.01,
        what="how far it came ahead and to the left in 2.5 s at 0.4 m/s",
        unit="m",
        hint="If it is too slow, look at <wheelTorque>, and at the damping that uses the torque up. If it goes backward, "
        "look at the axis of a wheel. If it goes too far, it may rear up because its centre of mass is too high.",
    )
    expect_close_angle(
        moved.heading,
        0.0,
        tolerance=math.radians(0.5),
        what="how far it turned meanwhile",
        hint="Do both wheels have the same radius, and the same distance from the middle?",
    )


@points(1)
def test_left_is_left(sim, robot):
    """Commanded to turn at 0.6 rad/s, the robot turns to the left at that rate, on the spot, and the ball slides."""
    moved = robot.drive(0.0, 0.6, settle=0.5, seconds=1.0)
    expect(
        moved.heading > 0,
        f"commanded to turn at +0.6 rad/s, which is to the left, it turns at {moved.heading:.2f} rad/s",
        hint="Left is at positive y. Which joint is <leftJoint>, and where is its origin?",
    )
    drags = robot.drag(*WHEELS)
    rate = (moved.heading + robot.drive(0.0, 0.6, settle=0.0, seconds=1.0).heading) / 2
    share = max(drags, robot.drag(*WHEELS))
    expect(
        share < 0.2,
        f"the ball does not slide: friction holds it back with {share:.0%} of the weight on it",
        hint='Set <mu1> and <mu2> to 0 in <gazebo reference="...">, with the name of the link. Without them the '
        "coefficient of friction is 1.",
    )
    expect_close(
        rate,
        0.6,
        tolerance=SLACK,
        what="its turn rate",
        unit="rad/s",
        hint="<wheelSeparation> is the distance between the two wheels, hub to hub.",
    )


@points(1)
@after("test_the_launch_file_brings_it_into_a_world")
def test_the_laser_sees_the_wall(sim, launched, rng):
    """A scan on /m2wr/laser/scan shows a wall at the right place in the frame sensor_laser, and nothing of the robot."""
    expect(
        "sensor_laser" in launched.links,
        "the model in the world has no link sensor_laser",
        hint="The sensor is attached to that link: add the link, and a fixed joint that holds it.",
    )
    pose = launched.link_pose("sensor_laser")
    expect_close_angle(
        heading_of(pose.rotation), 0.0, tolerance=0.01, what="the direction in which the laser looks",
        hint="The laser looks along the x axis of its link.",
    )  # fmt: skip
    (x, y, _), distance, shift = pose.translation, rng.uniform(1.0, 2.0), rng.choice((-0.6, 0.6))
    sim.spawn(WALL, xyz=(x + distance + 0.05, y + shift, 1.0))
    expect(
        SCAN in sim.topics(),
        f"there is no topic {SCAN}",
        hint="The plugin of the laser sets it as <topicName>. If the sensor's link is missing, Gazebo drops sensor and plugin.",
    )
    scans = sim.record([SCAN])
    expect(
        sim.run_until(lambda: bool(scans.raw(SCAN)), 1.0),
        f"no message arrived on {SCAN} within a second",
        hint="<update_rate> of the sensor sets how often it measures: 20 times a second.",
    )
    scan = scans[SCAN][0][1]
    expect(
        scan.header.frame_id.strip("/") == "sensor_laser",
        f"the frame_id of the scan is {scan.header.frame_id!r}",
        hint="<frameName> is the link that the laser is attached to: sensor_laser.",
    )
    _expect_wall(scan, distance, shift)
    expect(
        sim.run_until(lambda: sim.tf.can_transform("odom", "sensor_laser"), 1.0),
        "tf does not know where sensor_laser is, seen from odom",
        hint="The drive plugin broadcasts link_chassis in odom; a robot_state_publisher, which the launch file starts, "
        "broadcasts sensor_laser in link_chassis.",
    )


@points(1)
@after("test_it_drives_straight_on", "test_left_is_left")
def test_it_drives_round_the_corner(sim, robots, run_node, rng):
    """From any starting pose, and held up on its way, corner.py drives 1 m ahead, turns a quarter turn to the left, and stops."""
    # It looks back, so that its heading passes from pi to -pi in the turn.
    start = Stand(rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(1.8, 2.9))
    robot = DrivenRobot(sim, robots.robot(ROBOT), robots.text(ROBOT), name=MODEL, at=start)
    sim.run(0.2)
    begun = robot.axle(*WHEELS)
    node = run_node(SCRIPT)
    sim.run_until(lambda: not robot.is_at_rest, 3.0)
    expect(
        not robot.is_at_rest,
        "3 s after the start of corner.py the robot has not moved",
        hint="Does the script receive messages on /odom, and does it publish on /cmd_vel?",
    )
    if sim.run_until(lambda: robot.axle(*WHEELS).seen_from(begun).x > HALF_WAY, 10.0):
        robot.hold_up(HELD_UP)
    _wait_for_rest(sim, robot, node)
    moved = robot.axle(*WHEELS).seen_from(begun)
    expect(
        robot.is_at_rest,
        "20 s after the start of corner.py the robot still moves",
        hint="A command holds until the next one, so the last one must be 0. Or does the heading jump from pi to -pi "
        "during the turn, so that the loop never ends?",
    )
    expect_close_angle(
        moved.heading,
        math.pi / 2,
        tolerance=math.radians(5),
        what="how far it turned",
        hint="Compare the heading with the one at the start of the turn, and bring the difference into the range from "
        "-pi to pi.",
    )
    expect_close(
        (moved.x, moved.y),
        (1.0, 0.0),
        tolerance=0.05,
        what="how far the point midway between its wheels came ahead and to the left, from where it began",
        unit="m",
        hint="Measure from where the robot began, which is not 0 0, and slow down before the end. Something held the robot "
        f"up for {HELD_UP:g} s on its way: go by /odom, not by the clock.",
    )


@points(1)
def test_your_answers(submission):
    """The answers give the turn rate as found, what the robot does without commands, and where its beams point."""
    expect_close(
        given_answer(submission, "found_turn_rate"),
        -0.81,
        tolerance=0.13,
        what="found_turn_rate",
        unit="rad/s",
        hint="Measure it on the file as you found it, or compute it: the wheels are 0.3 m apart, the plugin assumes "
        "0.4 m, and left is right.",
    )
    expect(
        words_of(given_answer(submission, "no_more_commands")) == ["c"],
        "no_more_commands is not right",
        hint="Try it: publish one command with rostopic_pub, shut its node down, and let time pass.",
    )
    expect(
        words_of(given_answer(submission, "first_beam")) == ["right"],
        "first_beam is not right",
        hint="Its angle is angle_min, about -1.57. Angles count to the left.",
    )
    beams = given_answer(submission, "middle_beams")
    expect_close(
        sorted(beams) if isinstance(beams, list | tuple) and _are_numbers(beams) else beams,
        (359, 360),
        tolerance=0,
        what="middle_beams",
        hint="720 is even, so no beam points exactly straight ahead. The first beam has the number 0, the last one 719.",
    )


def _are_numbers(values):
    return all(type(value) in (int, float) for value in values)


def _expect_weight(robot, link, mass, inertia, hint):
    """Mass, centre of mass and the three moments about the axes of a link are these."""
    inertial = link_of(robot, link).inertial
    expect(
        inertial is not None, f"{link} has no mass", hint="Mass and inertia belong in <inertial>."
    )
    expect_close(inertial.mass, mass, tolerance=1e-3, what=f"the mass of {link}", unit="kg",
                 hint="The table at the beginning lists the masses.")  # fmt: skip
    expect_close(
        inertial.origin.xyz,
        (0.0, 0.0, 0.0),
        tolerance=1e-3,
        what=f"the centre of mass of {link}",
        unit="m",
        frame=link,
        hint="It is in the middle of the shape, and the middle is the origin of the link.",
    )
    found = inertia_of(robot.links[link], Place((0.0, 0.0, 0.0), rotation_of(0.0, 0.0, 0.0)))
    for axis, right in enumerate(inertia):
        name = "xyz"[axis]
        expect_close(found[axis][axis], right, tolerance=0.02 * right,
                     what=f"i{name}{name} of {link}", unit="kg m^2", hint=hint)  # fmt: skip


def _expect_wall(scan, distance, shift):
    """The beams show a wall ahead at this distance, 2 m wide, its middle so far to the left; and nothing else."""
    places, others = [], []
    for number, reach in enumerate(scan.ranges):
        angle = scan.angle_min + number * scan.angle_increment
        aside = math.tan(angle) * distance - shift if abs(angle) < 1.5 else math.inf
        if abs(aside) < 0.9:
            places.append(reach * math.cos(angle))
        elif abs(aside) > 1.1:
            others.append(reach)
    near = [reach for reach in [*others, *places] if reach < 0.6]
    expect(
        not near,
        f"{len(near)} of {len(scan.ranges)} beams hit something less than 0.6 m away: the laser sees the robot",
        hint="The laser must stand on the box, not in it, so that no part of the robot is in the plane of its beams.",
    )
    seen = [place for place in places if math.isfinite(place)]
    expect(
        len(seen) >= 10 and len(seen) == len(places) and not any(map(math.isfinite, others)),
        f"a wall is ahead, its middle {abs(shift):g} m to the {'left' if shift > 0 else 'right'}: the scan does not "
        "show it there",
        hint="Is the laser upright, and does it look forward? The beams are numbered from right to left.",
    )
    expect_close(
        sum(seen) / len(seen),
        distance,
        tolerance=0.02,
        what="how far ahead of the laser the scan shows the wall",
        unit="m",
        frame="sensor_laser",
        hint="The <pose> of the sensor in its link should be 0 0 0.",
    )


def _wait_for_rest(sim, robot, node):
    """Until the script has ended or waits, and the robot stands; at most 20 s."""
    still = 0
    for _ in range(80):
        sim.run(0.25)
        still = still + 1 if robot.is_at_rest else 0
        if still >= 8 or (still >= 2 and not node.alive):
            return
