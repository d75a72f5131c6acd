"""A student's robot, moved: where its links and their ends are, as tf says for given joint angles.

The robot stands on the graph as in RViz: its text is the parameter robot_description, a
robot_state_publisher broadcasts its frames, and the angles come in messages on /joint_states.
"""

from __future__ import annotations

from grader.checks.rotations import Point, Rotation, dot, of_quaternion, rotation_of
from grader.errors import CheckFailed
from simkit import Simulation
from simkit.tf import TransformException
from simkit.urdf import Cylinder, Robot

_SETTLE = 0.1
"Time after which tf has heard of new angles [s]."


class MovedRobot:
    """A robot on the graph, to be moved and measured.

    Args:
        sim: A simulation without another robot.
        robot: The robot, as it was read.
        text: The same as the text of its URDF.
    """

    def __init__(self, sim: Simulation, robot: Robot, text: str) -> None:
        self._sim = sim
        self._robot = robot
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
            require_joint(self._robot, name)
        # All of them, also those that stay: tf answers for a time at which it knows of each joint on the way.
        self._angles.update(angles)
        message = {
            "header": "auto",
            "name": list(self._angles),
            "position": list(self._angles.values()),
        }
        node = self._sim.rostopic_pub("/joint_states", "sensor_msgs/JointState", message)
        self._sim.run(_SETTLE)
        node.shutdown()

    def pose(self, link: str, *, seen_from: str = "world") -> tuple[Point, Rotation]:
        """Where a link's frame is, and its axes as the columns of a rotation matrix.

        Raises:
            CheckFailed: tf does not know.
        """
        try:
            found = self._sim.tf.lookup_transform(seen_from, link).transform
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
        visuals = self._robot.links[link].visuals if link in self._robot.links else ()
        if len(visuals) != 1 or not isinstance(visuals[0].geometry, Cylinder):
            raise CheckFailed(f"{link} is not one cylinder", hint="Give it one <visual>.")
        half = visuals[0].geometry.length / 2
        origin = visuals[0].origin
        place, turn = self.pose(link)
        along = tuple(row[2] for row in rotation_of(*origin.rpy))
        lower, upper = (
            _moved(place, turn, _stepped(origin.xyz, along, side)) for side in (-half, half)
        )
        return lower, upper


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
            hint='A fixed joint stays; one that turns round and round has type="continuous".',
        )


def _stepped(start: Point, along: tuple[float, ...], length: float) -> Point:
    x, y, z = (s + length * a for s, a in zip(start, along, strict=True))
    return (x, y, z)


def _moved(place: Point, turn: Rotation, point: Point) -> Point:
    x, y, z = (p + dot(row, point) for p, row in zip(place, turn, strict=True))
    return (x, y, z)
