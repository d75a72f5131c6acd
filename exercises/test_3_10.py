"""Exercise 3.10, public checks: motors, a controller, an elbow, and a node that keeps the arm moving."""

import math

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.answers import given_answer, words_of
from grader.checks.nodes import require_handed_in
from grader.checks.robots import RobotFiles, expect_chain, expect_silver_cylinder
from grader.checks.worlds import place_of
from oracles.driven_arm import COMMAND, started_arm
from oracles.folding_arm import LOWER, elbow_and_tip
from oracles.given_arm import given_arm
from oracles.moved_robot import MovedRobot
from oracles.trajectories import Rules, expect_sound, watch
from oracles.weights import expect_collision_as_visual, expect_cylinder_weight
from simkit.urdf import JointType

ROBOT = "hello_gazebo_robot_2.urdf"
CONTROLLERS = "controllers_simple.yaml"
LAUNCH = "spawn_gazebo_2.launch"
SCRIPT = "random_trajectories.py"
MODEL = "hello_ros_robot"
AGAIN = "random_trajectories_again"
"""Name of the node at its second start, which gives it another seed."""
JOINTS = ("hip", "shoulder", "elbow")
RULES = Rules(
    limits={"hip": (-1.5, 1.5), "shoulder": (-1.5, 0.0), "elbow": (0.0, 1.5)},
    longest=2.5,
    every=3.0,
)


@pytest.fixture
def robots(exercise, submission, package_path):
    """The student's URDF files."""
    return RobotFiles(exercise, submission, package_path)


@pytest.fixture
def launched(sim, roslaunch):
    """Start the student's robot, with a controller that moves the joints that are named."""
    return lambda *joints: started_arm(sim, roslaunch, LAUNCH, model=MODEL, joints=joints)


@points(1)
def test_check_urdf_takes_your_robot(robots):
    """check_urdf finds nothing wrong with hello_gazebo_robot_2.urdf, which extends the robot of exercise 3.9."""
    robots.expect_clean(ROBOT)
    expect_chain(robots.robot(ROBOT), "world", "base_link", "torso", "upper_arm")


@points(1)
def test_the_launch_file_starts_the_controller(exercise, submission, launched):
    """After the launch hello_ros_robot is in a world, and arm_controller runs; it moves hip and shoulder."""
    for file in (CONTROLLERS, ROBOT):
        require_handed_in(file, exercise, submission)
    launched("hip", "shoulder")


@points(1)
@after("test_the_launch_file_starts_the_controller")
def test_the_arm_holds_and_goes_where_it_is_told(sim, launched):
    """The arm does not fall, and the book's command takes hip and shoulder to 0.1 and -0.5 at constant speed in 1 s."""
    arm = launched("hip", "shoulder")
    arm.expect_at(
        {"hip": 0.0, "shoulder": 0.0},
        when="before anything was commanded",
        hint="A position controller holds its joints where they are. Does each joint have a transmission, with the "
        "interface for positions?",
    )
    arm.command((1.0, {"hip": 0.1, "shoulder": -0.5}))
    for seconds, share in ((0.5, 0.5), (0.5, 1.0), (0.3, 1.0)):
        sim.run(seconds)
        arm.expect_at(
            {"hip": 0.1 * share, "shoulder": -0.5 * share},
            when=f"after {share * 100:.0f} % of the time",
            hint="position_controllers/JointTrajectoryController moves joints at constant speed from point to point, if "
            "the points have no velocities.",
        )


@points(1)
def test_the_lower_arm_has_its_shape_and_weight(robots):
    """The lower arm is a cylinder like the other links: 0.3 m long, radius 0.05 m, silver, solid, 1 kg."""
    robot = robots.robot(ROBOT)
    expect_silver_cylinder(robot, "lower_arm", length=LOWER, radius=0.05)
    expect_collision_as_visual(robot, "lower_arm")
    expect_cylinder_weight(robot, "lower_arm", mass=1.0, length=LOWER, radius=0.05)


@points(1)
@after("test_the_lower_arm_has_its_shape_and_weight")
def test_the_elbow_is_at_the_end_of_the_upper_arm(sim, robots, rng):
    """The lower arm begins beside the end of the upper arm, goes on straight at 0, and bends down at positive angles."""
    robot = robots.robot(ROBOT)
    moved = MovedRobot(sim, robot, robots.text(ROBOT))
    moved.move(hip=0.0, shoulder=0.0, elbow=0.0)
    expect_lower_arm(
        moved,
        (0.0, 0.0, 0.0),
        joint_hint="The elbow is at the end of the upper arm, 0.4 m along z in the frame of upper_arm, and 0.1 m to the side "
        "that points away from the torso.",
        tip_hint="In the frame of upper_arm z already points along the arm: no quarter turn is needed to continue straight.",
    )
    kind = robot.joints["elbow"].type
    expect(
        kind is JointType.CONTINUOUS,
        f"the elbow is {kind.value}, not continuous",
        hint='A joint that turns without limits has type="continuous".',
    )
    bent = (0.0, 0.0, rng.uniform(0.4, 1.4))
    moved.move(hip=0.0, shoulder=0.0, elbow=bent[2])
    expect_lower_arm(
        moved,
        bent,
        joint_hint="The lower arm turns about its end at the elbow, so that end must stay in place.",
        tip_hint="The elbow turns about the same axis as the shoulder, and a positive angle bends the arm down.",
    )
    angles = tuple(rng.uniform(-3.0, 3.0) for _ in JOINTS)
    moved.move(**dict(zip(JOINTS, angles, strict=True)))
    expect_lower_arm(
        moved,
        angles,
        joint_hint="The upper arm carries the elbow.",
        tip_hint="Each joint carries everything beyond it.",
    )


def expect_lower_arm(moved, angles, *, joint_hint, tip_hint):
    """Both ends of the lower arm are where forward kinematics says."""
    joint, tip = elbow_and_tip(*angles)
    near, far = sorted(moved.ends("lower_arm"), key=lambda end: math.dist(end, joint))
    at = "hip {:.2f}, shoulder {:.2f}, elbow {:.2f}".format(*angles)
    for end, right, name, hint in (
        (near, joint, "the end of the lower arm at the elbow", joint_hint),
        (far, tip, "the free end of the lower arm", tip_hint),
    ):
        expect_close(
            end,
            right,
            tolerance=2e-3,
            what=f"{name}, with {at},",
            unit="m",
            frame="world",
            hint=hint,
        )


@points(1)
@after("test_the_launch_file_starts_the_controller")
def test_joint_states_and_tf_tell_of_all_joints(sim, launched, rng):
    """The controller moves all three joints, /joint_states contains them, and tf knows lower_arm."""
    arm = launched(*JOINTS)
    goals = {name: rng.uniform(*RULES.limits[name]) for name in JOINTS}
    arm.command((1.0, goals))
    sim.run(1.1)
    arm.expect_at(
        goals,
        when="after a trajectory to all three joints",
        hint="Does each of the three have its own <transmission>?",
    )
    heard = sim.record({"/joint_states": "sensor_msgs/JointState"})
    sim.run(0.25)
    told = {}
    for _, message in heard["/joint_states"]:
        for name, position in zip(message.name, message.position, strict=False):
            told.setdefault(name, []).append(position)
    for name in JOINTS:
        expect(
            name in told,
            f"/joint_states does not contain {name}; it contains: {', '.join(sorted(told)) or 'nothing'}",
            hint="The plugin libgazebo_ros_joint_state_publisher.so publishes the joints that its <jointName> lists, with "
            "commas between them.",
        )
        apart = max(told[name], key=lambda position: abs(position - goals[name]))
        expect_close(
            apart,
            goals[name],
            tolerance=0.01,
            what=f"the position of {name} on /joint_states",
            unit="rad",
            hint="Two publishers on /joint_states contradict each other. In a simulated world the robot itself publishes "
            "them, so start no joint_state_publisher.",
        )
    expect(
        sim.tf.can_transform("world", "lower_arm"),
        "tf does not know lower_arm, seen from world",
        hint="Start robot_state_publisher: it computes the frames from /joint_states and robot_description.",
    )
    found = sim.tf.lookup_transform("world", "lower_arm").transform.translation
    expect_close(
        (found.x, found.y, found.z),
        place_of(arm.model, "lower_arm").origin,
        tolerance=0.01,
        what="the position of lower_arm according to tf",
        unit="m",
        frame="world",
        hint="The robot in the world and the one in robot_description must be the same.",
    )


@points(1)
def test_the_node_sends_random_trajectories(sim, run_node):
    """Every 3 s the node sends a new trajectory, within the limits, and the arm follows it; each start sends others."""
    arm = given_arm(sim, *JOINTS, model=MODEL)
    node = run_node(SCRIPT)
    sent = watch(arm, 6.1, RULES)
    expect(
        len(sent) >= 2,
        f"the node sent {len(sent)} trajector{'y' if len(sent) == 1 else 'ies'} within 6.1 s",
        hint="Publish on /arm_controller/command as soon as the controller subscribes, and every 3 s from then on.",
    )
    expect(node.alive, "the node ended", hint="Publish in a loop: while not rospy.is_shutdown().")
    ends = [dict(zip(one.joint_names, one.points[-1].positions, strict=True)) for _, one in sent]
    for name in JOINTS:
        expect(
            len({round(end[name], 4) for end in ends}) == len(ends),
            f"{name} is sent to the same angle twice",
            hint="Draw a new random number for every joint, in every point of every trajectory.",
        )
    node.shutdown()
    heard = sim.record({COMMAND: "trajectory_msgs/JointTrajectory"})
    run_node(SCRIPT, f"__name:={AGAIN}")  # another start draws other numbers
    sim.run_until(lambda: heard[COMMAND], 3.0)
    expect(
        heard[COMMAND],
        "started a second time, the node sends nothing within 3 s",
        hint="Publish as soon as the controller subscribes, at every start of the node.",
    )
    end = expect_sound(heard[COMMAND][0][1], RULES)
    same = [name for name in JOINTS if round(end[name], 4) == round(ends[0][name], 4)]
    expect(
        not same,
        f"started a second time, the node sends {', '.join(same)} to the same angle as the first time",
        hint="Draw the numbers with random.uniform while the node runs. A list of your own, or a fixed random.seed, gives "
        "the same sequence at every start.",
    )


@points(1)
def test_your_answers(submission):
    """The answers give positions, the greatest speed, the effect of swapped names, and that of a missing one."""
    for name, right, tolerance, hint in (
        (
            "halfway",
            (0.05, -0.25),
            0.003,
            "Without velocities the joints move at constant speed: after half the time they are half way.",
        ),
        (
            "fastest",
            0.75,
            0.02,
            "A cubic that begins and ends at rest is fastest in the middle, and the plot shows it. The sign does not matter.",
        ),
        ("swapped", -0.5, 0.003, "Which number belongs to which name?"),
    ):
        expect_close(
            absolute(given_answer(submission, name))
            if name == "fastest"
            else given_answer(submission, name),
            right,
            tolerance=tolerance,
            what=name,
            hint=hint,
        )
    expect(
        words_of(given_answer(submission, "not_told")) == ["a"],
        "not_told is not right",
        hint="The controller does not subscribe to /joint_states. Which node does? Try it.",
    )


def absolute(value):
    """A number without its sign; anything else as it is."""
    return abs(value) if type(value) in (int, float) else value
