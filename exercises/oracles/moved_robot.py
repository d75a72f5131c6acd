"""A student's robot, moved: where its links and their ends are, according to tf, for given joint angles.

The robot stands on the graph as in RViz: its text is the parameter robot_description, a
robot_state_publisher broadcasts its frames, and the angles come in messages on /joint_states.
"""

from __future__ import annotations

import math

from grader.checks.robots import cylinder_of
from grader.checks.rotations import Point, Rotation, apart, dot, of_quaternion, rotation_of
from grader.errors import CheckFailed
from simkit import Simulation
from simkit.tf import TransformException
from simkit.urdf import Robot

_SETTLE = 0.1
"Time after which tf has heard of new angles [s]."
_NEAR = 1e-3
"How far tf may be from where a link is [m] and [rad]."


class SeenRobot:
    """A robot whose frames are broadcast, to be measured.

    Args:
        sim: The simulation.
        robot: The robot, as it was read.
    """

    def __init__(self, sim: Simulation, robot: Robot) -> None:
        self.sim = sim
        self.robot = robot

    def pose(self, link: str, *, seen_from: str = "world") -> tuple[Point, Rotation]:
        """Where a link's frame is, and its axes as the columns of a rotation matrix.

        Raises:
            CheckFailed: tf does not know.
        """
        try:
            found = self.sim.tf.lookup_transform(seen_from, link).transform
        except TransformException as error:
            raise CheckFailed(
                f"tf does not know where {link} is, seen from {seen_from}: {error}",
                hint="Is each link the child of a joint, and does each joint name the right parent?",
            ) from None
        place, turn = found.translation, found.rotation
        return (place.x, place.y, place.z), of_quaternion(turn)

    def ends(self, link: str) -> tuple[Point, Point]:
        """The two ends of the one cylinder of a link, in world: the lower of its own axis first [m].

        Raises:
            CheckFailed: The link has no cylinder, or tf does not know it.
        """
        visual, cylinder = cylinder_of(self.robot, link)
        half, origin = cylinder.length / 2, visual.origin
        place, turn = self.pose(link)
        along = tuple(row[2] for row in rotation_of(*origin.rpy))
        lower, upper = (
            _moved(place, turn, _stepped(origin.xyz, along, side)) for side in (-half, half)
        )
        return lower, upper


class MovedRobot(SeenRobot):
    """A robot on the graph, to be moved and measured.

    Args:
        sim: A simulation without another robot.
        robot: The robot, as it was read.
        text: The same as the text of its URDF.
    """

    def __init__(self, sim: Simulation, robot: Robot, text: str) -> None:
        super().__init__(sim, robot)
        self._angles: dict[str, float] = {}
        sim.params.set("/robot_description", text)
        sim.rosrun("robot_state_publisher", "robot_state_publisher")
        sim.run(_SETTLE)

    def move(self, **angles: float) -> None:
        """Bring joints to angles [rad]; those that are not named keep theirs.

        Raises:
            CheckFailed: The robot has no such joint, or it cannot be moved.
        """
        for name in angles:
            require_joint(self.robot, name)
        # All of them, also those that stay: tf answers for a time at which it knows of each joint on the way.
        self._angles.update(angles)
        message = {
            "header": "auto",
            "name": list(self._angles),
            "position": list(self._angles.values()),
        }
        node = self.sim.rostopic_pub("/joint_states", "sensor_msgs/JointState", message)
        self.sim.run(_SETTLE)
        node.shutdown()


def expect_to_follow(seen: SeenRobot, text: str, link: str, **angles: float) -> None:
    """Expect tf to have a link where the robot's own file puts it when its joints are at these angles [rad].

    Args:
        seen: The robot as other nodes broadcast it, e.g. those of a launch file.
        text: The text of its URDF.
        link: The link.
        angles: By joint.

    Raises:
        CheckFailed: Its position or its orientation is another one.
    """
    with Simulation(screen=None) as alone:
        moved = MovedRobot(alone, seen.robot, text)
        moved.move(**angles)
        place, turn = moved.pose(link)
    found_place, found_turn = seen.pose(link)
    off = math.dist(place, found_place), apart(turn, found_turn)
    if max(off) > _NEAR:
        told = ", ".join(f"{joint} at {angle:g} rad" for joint, angle in angles.items())
        raise CheckFailed(
            f"with {told} tf has {link} elsewhere than your file puts it: {off[0]:.3f} m and {off[1]:.3f} rad away",
            hint="The node with the sliders publishes on /joint_states, and robot_state_publisher subscribes to it. Does "
            "the launch file load your robot, and leave the names of topics and parameters as they are?",
        )


def require_joint(robot: Robot, name: str) -> None:
    """Expect a joint of that name that can move.

    Raises:
        CheckFailed: There is none.
    """
    moving = [joint.name for joint in robot.joints.values() if joint.moves]
    if name not in moving:
        raise CheckFailed(
            f"no joint {name} can be moved",
            expected=f"a joint named {name} that turns",
            actual=f"joints that move: {', '.join(moving) or 'none'}",
            hint='A fixed joint does not move; one that turns without limits has type="continuous". '
            "Every letter of a name counts, capitals too.",
        )


def _stepped(start: Point, along: tuple[float, ...], length: float) -> Point:
    x, y, z = (s + length * a for s, a in zip(start, along, strict=True))
    return (x, y, z)


def _moved(place: Point, turn: Rotation, point: Point) -> Point:
    x, y, z = (p + dot(row, point) for p, row in zip(place, turn, strict=True))
    return (x, y, z)
