"""tf puts every link where the kinematics says, and where somebody else's kinematics says."""

from __future__ import annotations

import math
import random

import pytest
from pytransform3d.urdf import UrdfTransformManager

from simkit import Simulation
from simkit.msgs import message_class
from simkit.urdf import load_robot
from simkit.urdf.kinematics import forward_kinematics

ROUNDS = 5
NEAR = 1e-9


def rows(q):
    """The rotation matrix of a unit quaternion, row by row."""
    x, y, z, w = q
    return [
        *(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        *(2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        *(2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    ]


def seen_from_root(sim, robot, link):
    found = sim.tf.lookup_transform(robot.root, link).transform
    t, q = found.translation, found.rotation
    return (t.x, t.y, t.z), (q.x, q.y, q.z, q.w)


def test_every_link_is_where_the_kinematics_says(urdf):
    text, rng = urdf.read_text(), random.Random(urdf.stem)
    robot = load_robot(text, file=urdf.name)
    moving = [joint.name for joint in robot.joints.values() if joint.moves]
    joint_state = message_class("sensor_msgs/JointState")
    theirs = UrdfTransformManager()
    theirs.load_urdf(text)
    with Simulation(seed=1, screen=None) as sim:
        sim.params.set("/robot_description", text)
        sim.rosrun("robot_state_publisher", "robot_state_publisher")
        publisher = sim.graph.create_node("/joints").advertise("/joint_states", joint_state)
        for _ in range(ROUNDS):
            sim.run(0.1)
            positions = {name: rng.uniform(-math.pi, math.pi) for name in moving}
            message = joint_state(name=list(positions), position=list(positions.values()))
            message.header.stamp = sim.now
            publisher.publish(message)
            sim.run(0.0)
            ours = forward_kinematics(robot, positions)
            for name, position in positions.items():
                theirs.set_joint(name, position)
            for link in sorted(set(robot.links) - {robot.root}):
                translation, rotation = seen_from_root(sim, robot, link)
                matrix = theirs.get_transform(link, robot.root)
                assert translation == pytest.approx(ours[link].translation, abs=NEAR)
                assert rows(rotation) == pytest.approx(rows(ours[link].rotation), abs=NEAR)
                assert translation == pytest.approx(tuple(matrix[:3, 3]), abs=NEAR)
                assert rows(rotation) == pytest.approx([*matrix[:3, :3].ravel()], abs=NEAR)


@pytest.mark.parametrize(
    ("hip", "shoulder", "tip"),
    [
        (0.0, 0.0, (0.4, -0.1, 0.5)),
        (math.pi / 2, 0.0, (0.1, 0.4, 0.5)),
        (0.0, math.pi / 2, (0.0, -0.1, 0.1)),
        (0.0, -math.pi / 2, (0.0, -0.1, 0.9)),
    ],
)
@pytest.mark.parametrize(
    "name", ["hello_ros_robot_3", "hello_gazebo_robot_1", "hello_gazebo_robot_2"]
)
def test_the_tip_of_the_arm(robots, name, hip, shoulder, tip):
    path = robots / f"hello_ros/urdf/{name}.urdf"
    robot = load_robot(path.read_bytes(), file=path.name)
    arm = forward_kinematics(robot, {"hip": hip, "shoulder": shoulder})["upper_arm"]
    matrix = rows(arm.rotation)
    found = [arm.translation[axis] + 0.4 * matrix[3 * axis + 2] for axis in range(3)]
    assert found == pytest.approx(tip, abs=1e-5)  # the book writes 1.5708 for a right angle
