"""A robot that a trajectory controller drives: started by a launch file, commanded, and measured."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from grader.checks.expect import expect_close
from grader.checks.log import with_complaint
from grader.checks.worlds import started_world
from grader.errors import CheckFailed
from simkit import Simulation
from simkit.physics import Model

CONTROLLER = "arm_controller"
COMMAND = f"/{CONTROLLER}/command"
"""The topic of the commands to the controller."""
_LIST = "/controller_manager/list_controllers"
_START = 0.4
"""Time in which a launch file brings robot and controller [s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class DrivenArm:
    """A robot in a world, with a controller that runs."""

    sim: Simulation
    model: Model
    joints: tuple[str, ...]
    """Those that the controller moves, sorted."""

    def at(self, *joints: str) -> tuple[float, ...]:
        """Where joints are now [rad].

        Raises:
            CheckFailed: The robot in the world has no such joint.
        """
        for name in joints:
            if name not in self.model.joints:
                raise CheckFailed(
                    f"the robot in the world has no joint {name}",
                    expected=f"a joint named {name}",
                    actual=", ".join(sorted(self.model.joints)) or "no joint",
                    hint="Gazebo leaves out a link without mass if its joint can move, and the joint with it.",
                )
        return tuple(self.model.joint(name).position for name in joints)

    def command(
        self, *points: tuple[float, Mapping[str, float]], order: Sequence[str] | None = None
    ) -> None:
        """Send a trajectory; joints that a point does not name stay where they are.

        Args:
            *points: For each point its time [s], and the angles of joints at that time [rad].
            order: The order in which the joints are named; their own if None.
        """
        names = list(order or self.joints)
        here = dict(zip(names, self.at(*names), strict=True))
        rows = [
            {
                "positions": [{**here, **goals}[name] for name in names],
                "time_from_start": {"secs": int(time), "nsecs": round(time % 1 * 1e9)},
            }
            for time, goals in points
        ]
        message = {"joint_names": names, "points": rows}
        node = self.sim.rostopic_pub(COMMAND, "trajectory_msgs/JointTrajectory", message)
        self.sim.run(0.001)
        node.shutdown()

    def expect_at(self, goals: Mapping[str, float], *, when: str, hint: str) -> None:
        """Expect joints to be at angles [rad].

        Raises:
            CheckFailed: They are not; the failure contains what the controller has logged.
        """
        for name, goal in goals.items():
            (position,) = self.at(name)
            try:
                expect_close(
                    position,
                    goal,
                    tolerance=0.01,
                    what=f"the angle of {name} {when}",
                    unit="rad",
                    hint=hint,
                )
            except CheckFailed as failure:
                raise with_complaint(failure, self.sim) from None


def started_arm(
    sim: Simulation, roslaunch: Callable[..., Any], file: str, *, model: str, joints: Sequence[str]
) -> DrivenArm:
    """The robot that a student's launch file brings, with its controller.

    Args:
        sim: The simulation of the check.
        roslaunch: The fixture.
        file: Name of the launch file.
        model: Name of the robot in the world.
        joints: What its controller must move, among others.

    Raises:
        CheckFailed: There is no such robot, or no such controller runs.
    """
    gazebo = started_world(sim, roslaunch, file)
    sim.run(_START)
    if model not in gazebo.spawned:
        others = ", ".join(name for name in gazebo.spawned if name != "ground_plane") or "nothing"
        failure = CheckFailed(
            f"{model} is not in the world; apart from the ground it contains: {others}",
            hint="spawn_model needs three arguments: -urdf, -param with the name of the parameter, and -model with the "
            "name in the world.",
        )
        raise with_complaint(failure, sim)
    moved = _require_controller(sim)
    for name in joints:
        if name not in moved:
            raise CheckFailed(
                f"{CONTROLLER} does not move {name}",
                expected=f"{name} among its joints",
                actual=", ".join(moved) or "no joint",
                hint="The YAML file lists the joints that the controller moves. The launch file must load it: "
                '<rosparam file="..." command="load"/>.',
            )
    return DrivenArm(sim=sim, model=gazebo.spawned[model].model, joints=moved)


def _require_controller(sim: Simulation) -> tuple[str, ...]:
    """The joints of the controller, sorted."""
    if _LIST not in sim.services():
        failure = CheckFailed(
            "there is no controller manager: the service /controller_manager/list_controllers does not exist",
            hint="The plugin libgazebo_ros_control.so in the URDF starts the controller manager. Do not give it a "
            "<robotNamespace>.",
        )
        raise with_complaint(failure, sim)
    found = {one.name: one for one in sim.call(_LIST).controller}
    if CONTROLLER not in found or found[CONTROLLER].state != "running":
        states = ", ".join(f"{one.name} ({one.state})" for one in found.values())
        failure = CheckFailed(
            f"the controller {CONTROLLER} does not run",
            expected=f"{CONTROLLER} (running)",
            actual=states or "no controller",
            hint="Its name in the YAML file and in the args of the spawner must be the same, and each of its joints needs "
            "a transmission with the interface that the type of the controller requires.",
        )
        raise with_complaint(failure, sim)
    claims = found[CONTROLLER].claimed_resources
    return tuple(sorted({name for claim in claims for name in claim.resources}))
