"""A student's robot with driven wheels: stood on the floor, commanded to drive, and measured."""

from __future__ import annotations

import math
from collections.abc import Collection
from typing import Any, NamedTuple

from grader.checks.rotations import Point
from grader.checks.worlds import Solid, place_of, solid_of, spawned_robot
from grader.errors import CheckFailed
from simkit import Simulation
from simkit.gazebo import Spawned
from simkit.graph import Node
from simkit.msgs import message_class
from simkit.physics import Model
from simkit.urdf import Robot

_NEAR_FLOOR = 0.005
"""What is not higher above the floor stands on it [m]."""


class Stand(NamedTuple):
    """Where a robot is on the floor, and which way it looks."""

    x: float
    """[m]."""
    y: float
    """[m]."""
    heading: float
    """From x towards y [rad]."""

    def seen_from(self, start: Stand) -> Stand:
        """How far ahead of a start it is, how far to the left of it, and how much it turned since."""
        dx, dy = self.x - start.x, self.y - start.y
        c, s = math.cos(start.heading), math.sin(start.heading)
        turned = math.remainder(self.heading - start.heading, math.tau)
        return Stand(c * dx + s * dy, c * dy - s * dx, turned)


class DrivenRobot:
    """A robot in an empty world, its lowest point on the floor.

    Args:
        sim: A simulation without another robot.
        robot: The robot, as it was read.
        text: The same as the text of its URDF.
        name: Its name in the world.
        at: Where it begins.

    Raises:
        CheckFailed: There is nothing in it that can be simulated.
        SpawnError: It cannot be spawned.
    """

    def __init__(
        self,
        sim: Simulation,
        robot: Robot,
        text: str,
        *,
        name: str,
        at: Stand = Stand(0.0, 0.0, 0.0),  # noqa: B008  (immutable)
    ) -> None:
        probe = spawned_robot(sim, text, name=name)
        height = -lowest_point(robot, probe.model)
        sim.gazebo.delete(name)
        self.spawned: Spawned = spawned_robot(
            sim, text, name=name, xyz=(at.x, at.y, height), rpy=(0.0, 0.0, at.heading)
        )
        self._sim = sim
        self._commander: Node | None = None

    @property
    def model(self) -> Model:
        """The robot in physics."""
        return self.spawned.model

    @property
    def stand(self) -> Stand:
        """Where its root link is now."""
        x, y, _ = self.model.pose.translation
        return Stand(x, y, heading_of(self.model.pose.rotation))

    def axle(self, *wheels: str) -> Stand:
        """The middle of some wheels on the floor; a robot turns on the spot about the middle of its driven ones.

        Raises:
            CheckFailed: A wheel is not simulated.
        """
        hubs = [place_of(self.model, wheel).origin for wheel in wheels]
        x, y = (sum(hub[axis] for hub in hubs) / len(hubs) for axis in (0, 1))
        return Stand(x, y, self.stand.heading)

    @property
    def is_at_rest(self) -> bool:
        """Whether it neither drives nor turns."""
        linear, angular = self.model.twist
        return math.hypot(*linear) < 0.01 and abs(angular[2]) < 0.02

    def command(self, speed: float, turn_rate: float) -> None:
        """Publish one message on /cmd_vel [m/s, rad/s]."""
        if self._commander is not None:
            self._commander.shutdown()
        told = {"linear": {"x": speed}, "angular": {"z": turn_rate}}
        self._commander = self._sim.rostopic_pub("/cmd_vel", "geometry_msgs/Twist", told)

    def drive(self, speed: float, turn_rate: float, *, settle: float, seconds: float) -> Stand:
        """Drive by one command; how it moved in `seconds` after it had `settle` to speed up [s]."""
        self.command(speed, turn_rate)
        self._sim.run(settle)
        start = self.stand
        self._sim.run(seconds)
        return self.stand.seen_from(start)

    def hold_up(self, seconds: float) -> None:
        """Answer each command with 0, for so long [s]; then the last one holds again.

        Both odometries see it, the one from the wheels too; a script that counts time does not.
        """
        twist = message_class("geometry_msgs/Twist")
        held = self._sim.latest("/cmd_vel")
        node = self._sim.graph.create_node("/hold_up")
        brake = node.advertise("/cmd_vel", twist)

        def on_command(command: Any) -> None:
            nonlocal held
            if command.linear.x or command.angular.z:
                held = command
                brake.publish(twist())

        node.subscribe("/cmd_vel", twist, on_command)
        brake.publish(twist())
        self._sim.run(seconds)
        node.shutdown()
        self.command(held.linear.x, held.angular.z)

    def drag(self, *wheels: str) -> float:
        """Friction on the parts that are not wheels, as a share of the weight on them; now."""
        held = carried = 0.0
        for contact in self._sim.world.contacts():
            for side in (contact.first, contact.second):
                if side.model == self.model.name and side.link not in wheels:
                    x, y, z = contact.force
                    held += math.hypot(x, y)
                    carried += abs(z)
        return held / carried if carried > 0.1 else 0.0


def heading_of(rotation: tuple[float, float, float, float]) -> float:
    """Which way a frame looks [rad], of its quaternion xyzw."""
    x, y, z, w = rotation
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def lowest_point(robot: Robot, model: Model) -> float:
    """Height of the lowest point that can be touched of a robot in the world [m]; of its root if there is none.

    Args:
        robot: The robot, as it was read.
        model: The same in the world.
    """
    heights = [solid.centre[2] - solid.size[2] / 2 for solid in touched_solids(robot, model)]
    return min(heights, default=model.pose.translation[2])


def expect_ball(
    robot: Robot,
    model: Model,
    *,
    radius: float,
    link: str,
    centre: Point,
    wheels: Collection[str],
) -> None:
    """Expect the robot to stand on one ball, at a place of a link, with that radius [m].

    The robot stands upright on the floor and looks along x.

    Args:
        robot: The robot, as it was read.
        model: The same in the world.
        radius: [m].
        link: The link whose frame counts.
        centre: Middle of the ball in that frame [m].
        wheels: Links that do not count; wheels may be balls as well.

    Raises:
        CheckFailed: No ball is on the floor, more than one, or it is in another place.
    """
    origin = place_of(model, link).origin
    balls = [
        (solid.size[0] / 2, *(c - o for c, o in zip(solid.centre, origin, strict=True)))
        for solid in touched_solids(robot, model, without=wheels)
        if solid.kind == "sphere" and solid.centre[2] - solid.size[2] / 2 < _NEAR_FLOOR
    ]
    wanted = (radius, *centre)
    if len(balls) == 1 and math.dist(balls[0], wanted) < 1e-3:
        return
    found = "; ".join(f"radius {r:.3g} m at {x:.3g} {y:.3g} {z:.3g}" for r, x, y, z in balls)
    raise CheckFailed(
        "the collision shape of the ball is not where its visual is",
        expected=f"radius {radius:g} m at {' '.join(f'{c:g}' for c in centre)}, in the frame {link}",
        actual=found or "no ball on the floor",
        hint="The shape in <collision> touches the floor, the one in <visual> is drawn. Give both the same <origin>.",
    )


def touched_solids(robot: Robot, model: Model, *, without: Collection[str] = ()) -> list[Solid]:
    """The collision shapes of a robot, as they stand in the world, but for those of some links."""
    return [
        solid_of(shape, place_of(model, link.name))
        for link in robot.links.values()
        if link.name in model.links and link.name not in without
        for shape in link.collisions
    ]
