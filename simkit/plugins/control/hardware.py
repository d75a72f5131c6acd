"""The motors of a robot, as controllers see them: joints by interface, read and written in each step.

Source: gazebo_ros_control `DefaultRobotHWSim`, texts and order.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from simkit.errors import near_names
from simkit.graph import Node
from simkit.physics import Model
from simkit.plugins.control.joint_drive import JointDrive, JointHandle
from simkit.plugins.control.limits import limits_of
from simkit.plugins.control.pid import Pid, read_gains
from simkit.plugins.control.registry import (
    CONTROLLER_TYPES,
    EFFORT,
    FAMILIES,
    PREFIX,
    STATE,
    ControllerType,
)
from simkit.plugins.control.transmission import Transmission
from simkit.urdf import Robot


class RobotHardware:
    """The joints of a model that have motors.

    Args:
        drives: The joints, by name in the order of their transmissions.
    """

    def __init__(self, drives: Mapping[str, JointDrive]) -> None:
        self.drives = dict(drives)
        self.is_stopped = False
        """Whether the emergency stop is on."""
        self._all = tuple(self.drives.values())

    def joints_of(self, interface: str) -> dict[str, JointHandle]:
        """The joints of an interface, by name."""
        return {
            name: drive.handle
            for name, drive in self.drives.items()
            if interface in (STATE, drive.handle.interface)
        }

    def why_no_joint(self, name: str, *, controller: str, type_: ControllerType) -> str:
        """Why a controller cannot have a joint: its transmission, the YAML file, or the type does not fit.

        Args:
            name: The joint that it asks for.
            controller: Its name.
            type_: Its type.
        """
        wanted = type_.interface
        if name in self.drives:
            offered = self.drives[name].handle.interface
            text = (
                f"the transmission of {name} offers {offered}, and {type_.name} needs {wanted}: "
                f"write {PREFIX}{wanted} in the transmission"
            )
            other = f"{FAMILIES[offered]}/{type_.bare_name}"
            return (
                f"{text}, or type: {other} in the YAML file" if other in CONTROLLER_TYPES else text
            )
        near = near_names(name, self.drives)
        if near:
            return (
                f"no transmission is for {name}; did you mean {near[0]}? The name in the joints of "
                f"{controller} and the one in <transmission><joint name=...> must be the same"
            )
        there = f"; there are transmissions for: {', '.join(self.drives)}" if self.drives else ""
        return (
            f"no transmission is for {name}: add a <transmission> to the URDF with <joint name={name!r}> "
            f"and <hardwareInterface>{PREFIX}{wanted}</hardwareInterface> in it{there}"
        )

    def read(self) -> None:
        """Read position, velocity and effort of all joints."""
        for drive in self._all:
            drive.read()

    def write(self, period_s: float) -> None:
        """Carry all commands out; so much time has passed since the last time [s]."""
        for drive in self._all:
            drive.write(period_s, is_stopped=self.is_stopped)

    def release(self) -> None:
        """Let all joints go."""
        for drive in self._all:
            drive.release()


def make_hardware(
    node: Node,
    model: Model,
    robot: Robot | None,
    transmissions: Iterable[Transmission],
    *,
    namespace: str,
    gains_namespace: str,
) -> RobotHardware:
    """The motors that transmissions ask for; one that cannot be made is logged, and left out.

    Args:
        node: Whose log and whose parameters are used.
        model: The robot in the world.
        robot: Its URDF, for kinds and limits of joints; None if it is invalid.
        transmissions: Its transmissions.
        namespace: Where the parameters `joint_limits/...` are, without a slash at its end.
        gains_namespace: Where the parameters `gazebo_ros_control/pid_gains/...` are.
    """
    drives: dict[str, JointDrive] = {}
    for one in transmissions:
        if one.joint not in model.joints:
            node.error(
                f'This robot has a joint named "{one.joint}" which is not in the gazebo model.'
            )
            node.warn(f"hint: no controller can move it{_near(one.joint, model)}")
            continue
        joint = None if robot is None else robot.joints.get(one.joint)
        parameters = _parameters(node, f"{namespace}/joint_limits/{one.joint}")
        limits = limits_of(joint, parameters)
        if limits is not None and limits.velocity == 0.0:
            node.warn(
                f'hint: the <limit> of the joint {one.joint} says velocity="0": it cannot be moved; '
                "write the largest speed in rad/s or m/s"
            )
        drives[one.joint] = JointDrive(
            model.joints[one.joint],
            one.interface,
            kind=None if joint is None else joint.type,
            limits=limits,
            pid=_pid(node, one, f"{gains_namespace}/gazebo_ros_control/pid_gains/{one.joint}"),
        )
    return RobotHardware(drives)


def _pid(node: Node, transmission: Transmission, namespace: str) -> Pid | None:
    if transmission.interface == EFFORT:
        return None
    gains = read_gains(node.graph.params, namespace)
    if gains is None:
        # Gazebo says it in red, though nothing is wrong; here it is for those who look for it.
        node.debug(
            f"No p gain specified for pid.  Namespace: {namespace}. Harmless: the joint "
            f"{transmission.joint} goes as it is told, without gains"
        )
        return None
    return Pid(gains)


def _parameters(node: Node, name: str) -> Mapping[str, Any]:
    found = node.graph.params.get(name, {})
    return found if isinstance(found, dict) else {}


def _near(name: str, model: Model) -> str:
    near = near_names(name, model.joints)
    if near:
        return f"; did you mean {near[0]}?"
    return f": those that move are {', '.join(model.joints)}" if model.joints else ""
