"""A robot with the joints of the arm and its controller, so that a node that drives it is judged by itself.

It is not a solution: balls on a stick, a metre apart.
"""

from __future__ import annotations

from collections.abc import Sequence

from oracles.driven_arm import CONTROLLER, DrivenArm
from simkit import Simulation

_SETTLE = 0.3
"""Time in which its controller starts [s]."""


def given_arm(sim: Simulation, *joints: str, model: str) -> DrivenArm:
    """Bring a robot with a trajectory controller into a world.

    Args:
        sim: A simulation without another robot.
        *joints: Names of its joints; each is attached to the one before it.
        model: Its name in the world.
    """
    text = _urdf(joints)
    sim.params.set("/robot_description", text)
    sim.params.set(f"/{CONTROLLER}/type", "position_controllers/JointTrajectoryController")
    sim.params.set(f"/{CONTROLLER}/joints", list(joints))
    spawned = sim.gazebo.spawn_urdf(text, name=model, file="given_arm.urdf")
    sim.rosrun("controller_manager", "spawner", CONTROLLER)
    sim.rosrun("robot_state_publisher", "robot_state_publisher")
    sim.run(_SETTLE)
    return DrivenArm(sim=sim, model=spawned.model, joints=tuple(sorted(joints)))


def _urdf(joints: Sequence[str]) -> str:
    parts, parent = ['<robot name="given_arm"><link name="world"/>'], "world"
    for name in joints:
        parts.append(_ball(f"{name}_ball"))
        parts.append(
            f'<joint name="{name}" type="continuous"><parent link="{parent}"/><child link="{name}_ball"/>'
            '<origin xyz="0 0 1"/><axis xyz="0 1 0"/></joint>'
        )
        parts.append(_motor(name))
        parent = f"{name}_ball"
    names = ",".join(joints)
    parts.append(
        '<gazebo><plugin name="c" filename="libgazebo_ros_control.so"/>'
        '<plugin name="j" filename="libgazebo_ros_joint_state_publisher.so">'
        f"<jointName>{names}</jointName></plugin></gazebo></robot>"
    )
    return "".join(parts)


def _ball(link: str) -> str:
    return (
        f'<link name="{link}"><inertial><mass value="1"/>'
        '<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>'
    )


def _motor(joint: str) -> str:
    interface = "<hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>"
    return (
        f'<transmission name="{joint}_motor"><type>transmission_interface/SimpleTransmission</type>'
        f'<joint name="{joint}">{interface}</joint>'
        f'<actuator name="{joint}_actuator">{interface}</actuator></transmission>'
    )
