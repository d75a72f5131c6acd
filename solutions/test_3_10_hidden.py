"""Exercise 3.10, hidden checks: trajectories of several points, and node and robot together."""

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.robots import RobotFiles, only_visual
from grader.checks.worlds import place_of, solid_of
from oracles.driven_arm import started_arm
from oracles.folding_arm import elbow_and_tip, middle
from oracles.trajectories import Rules, watch

ROBOT = "hello_gazebo_robot_2.urdf"
LAUNCH = "spawn_gazebo_2.launch"
SCRIPT = "random_trajectories.py"
MODEL = "hello_ros_robot"
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


@points(1)
@after(
    "test_the_elbow_is_at_the_end_of_the_upper_arm", "test_joint_states_and_tf_tell_of_all_joints"
)
def test_the_lower_arm_goes_where_the_angles_say(sim, roslaunch, robots, rng):
    """In the world, after a trajectory of two points, the lower arm is where forward kinematics says."""
    arm = started_arm(sim, roslaunch, LAUNCH, model=MODEL, joints=JOINTS)
    first, last = ({name: rng.uniform(*RULES.limits[name]) for name in JOINTS} for _ in range(2))
    order = list(JOINTS)
    rng.shuffle(order)
    arm.command((1.0, first), (2.0, last), order=order)
    for goals in (first, last):
        sim.run(1.0)
        arm.expect_at(
            goals,
            when="on a trajectory of two points",
            hint="position_controllers/JointTrajectoryController reaches each point at its time.",
        )
        visual = only_visual(robots.robot(ROBOT), "lower_arm")
        expect_close(
            solid_of(visual, place_of(arm.model, "lower_arm")).centre,
            middle(elbow_and_tip(*(goals[name] for name in JOINTS))),
            tolerance=0.01,
            what="the middle of the lower arm in the world",
            unit="m",
            frame="world",
            hint="Only its motors should move the arm: does anything else hold it, stop it, or push it?",
        )


@points(1)
@after("test_the_node_sends_random_trajectories")
def test_the_node_waits_for_your_robot(sim, roslaunch, run_node):
    """Started before the robot, the node waits until the controller subscribes; then it drives the arm."""
    node = run_node(SCRIPT)
    sim.run(2.0)
    expect(
        node.alive,
        "the node ended before a controller had subscribed",
        hint="Wait for the controller: get_num_connections() of a publisher returns the number of subscribers.",
    )
    sent_early = (
        sim.latest("/arm_controller/command") if "/arm_controller/command" in sim.topics() else None
    )
    expect(
        sent_early is None,
        "the node sent a trajectory before the controller had subscribed: that trajectory is lost",
        hint="Wait until get_num_connections() of the publisher is not 0, with rospy.sleep in the loop.",
    )
    arm = started_arm(sim, roslaunch, LAUNCH, model=MODEL, joints=JOINTS)
    sent = watch(arm, 3.5, RULES)
    expect(
        sent,
        "the node sends nothing to your robot",
        hint="Send the first trajectory as soon as the controller subscribes, and then one every 3 s.",
    )
    expect(node.alive, "the node ended", hint="Loop while not rospy.is_shutdown().")
