"""Sample robots of plugins, and what the contract tests of plugins have to know of them."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import pytest

from simkit.msgs import message_class
from simkit.plugins import plugins


def link(name: str, shape: str, *, mass: float = 1.0, moment: float = 0.01, extra: str = "") -> str:
    """A link of one solid."""
    return f"""<link name="{name}">
  <inertial><mass value="{mass}"/>
    <inertia ixx="{moment}" iyy="{moment}" izz="{moment}" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry>{shape}</geometry></collision>{extra}
</link>"""


def wheel(name: str, x: float, y: float, shape: str = "") -> str:
    """A wheel and its joint `NAME_joint`, on the link `base`; it rolls forward at a positive speed.

    Its radius is 0.1 m. A cylinder touches the ground at both of its edges, and the one with more weight
    on it does not slip; a ball touches it right below its hub.
    """
    shape = shape or '<cylinder radius="0.1" length="0.02"/>'
    return f"""<link name="{name}">
  <inertial><mass value="0.2"/>
    <inertia ixx="0.0005" iyy="0.001" izz="0.0005" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><origin rpy="1.5707963267948966 0 0"/>
    <geometry>{shape}</geometry></collision>
</link>
<joint name="{name}_joint" type="continuous">
  <parent link="base"/><child link="{name}"/><origin xyz="{x} {y} 0"/><axis xyz="0 1 0"/>
</joint>"""


CASTER = """
  <collision><origin xyz="0.2 0 -0.05"/><geometry><sphere radius="0.05"/></geometry></collision>
  <collision><origin xyz="-0.2 0 -0.05"/><geometry><sphere radius="0.05"/></geometry></collision>"""
SLIPPERY = '<gazebo reference="base"><mu1>0</mu1><mu2>0</mu2></gazebo>'

CAR = "\n".join(
    [
        link("base", '<box size="0.5 0.3 0.06"/>', mass=5.0, moment=0.1, extra=CASTER),
        wheel("left", 0.0, 0.2),
        wheel("right", 0.0, -0.2),
        SLIPPERY,
    ]
)
"""Two wheels 0.4 m apart, and two balls that slide; hubs at 0.1 m."""

ROVER = "\n".join(
    [
        link("base", '<box size="0.4 0.2 0.06"/>', mass=5.0, moment=0.1),
        *(
            wheel(f"{side}_{end}", x, y)
            for end, x in (("front", 0.15), ("rear", -0.15))
            for side, y in (("left", 0.2), ("right", -0.2))
        ),
    ]
)
"""Four wheels; hubs at 0.1 m."""

PENDULUM = f"""<link name="world"/>
<joint name="fixed" type="fixed"><parent link="world"/><child link="base"/><origin xyz="0 0 1"/></joint>
{link("base", '<box size="0.1 0.1 0.1"/>')}
{link("bob", '<sphere radius="0.05"/>', extra="")}
<joint name="swing" type="continuous">
  <parent link="base"/><child link="bob"/><origin xyz="0 0.2 0" rpy="0.3 0 0"/><axis xyz="1 0 0"/>
</joint>""".replace(
    '<inertial><mass value="1.0"/>', '<inertial><origin xyz="0.1 0.3 0"/><mass value="1.0"/>'
)
"""A bob that swings; it never comes to rest."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sample:
    """A robot with one plugin."""

    robot: str
    """What stands in `<robot>` before the plugin."""
    tags: Mapping[str, str] = field(default_factory=dict)
    """What the tag of the plugin says."""
    before: str = "<gazebo>"
    """What stands before the plugin; `{rate}` for its rate [Hz]."""
    after: str = "</gazebo>"
    """What stands after it."""
    rate_tag: str = ""
    """Tag in which its rate stands; empty if that is in `before`, or if it has none."""
    height: float = 0.1
    """Where it is spawned [m]."""
    commands: Mapping[str, Any] = field(default_factory=dict)
    """What is published before it starts: message by topic."""
    parameters: Mapping[str, Any] = field(default_factory=dict)
    """What is on the parameter server; `{urdf}` stands for the URDF, and `{rate}` for its rate [Hz]."""
    calls: tuple[tuple[str, str, Mapping[str, Any]], ...] = ()
    """Services that are called once it is there: name, type, request."""
    begins_anew: bool = True
    """Whether it says the same again after a reset."""

    def urdf(self, filename: str, *, rate: float = 20.0, **tags: str) -> str:
        """The URDF, each tag of the plugin in a line of its own.

        Args:
            filename: Library of the plugin.
            rate: How often it shall say something [Hz].
            **tags: What the tag says besides, or instead.
        """
        said = {**self.tags, **({self.rate_tag: f"{rate:g}"} if self.rate_tag else {}), **tags}
        lines = "\n".join(f"<{name}>{text}</{name}>" for name, text in said.items())
        before = self.before.replace("{rate}", f"{rate:g}")
        return (
            f'<robot name="sample">\n{self.robot}\n{before}\n<plugin name="p" filename="{filename}">\n'
            f"{lines}\n</plugin>{self.after}\n</robot>"
        )


def twist(linear: float = 0.0, angular: float = 0.0) -> Any:
    """A command to drive [m/s, rad/s]."""
    message: Any = message_class("geometry_msgs/Twist")()
    message.linear.x, message.angular.z = linear, angular
    return message


def tell(stage: Any, linear: float = 0.0, angular: float = 0.0, topic: str = "/cmd_vel") -> None:
    """Command a robot on a stage to drive [m/s, rad/s]."""
    command = twist(linear, angular)
    publisher = stage.listener.advertise(topic, type(command))
    publisher.publish(command)
    publisher.unregister()


def driven(filename: str = "libgazebo_ros_diff_drive.so", robot: str = "", **tags: str) -> str:
    """What stands in the `<robot>` of a sample robot that drives.

    Args:
        filename: Library of its plugin.
        robot: What it is made of, if not of what the sample is.
        **tags: What the tag of the plugin says, besides what the sample needs; None takes a tag away.
    """
    sample = sample_of(filename)
    needed = {
        name: text
        for name, text in sample.tags.items()
        if name.endswith("Joint") or name in ("wheelSeparation", "wheelDiameter")
    }
    said = {**needed, "updateRate": "20", **tags}
    lines = "\n".join(f"<{n}>{text}</{n}>" for n, text in said.items() if text is not None)
    return (
        f'{robot or sample.robot}\n<gazebo><plugin name="drive" filename="{filename}">\n{lines}\n'
        "</plugin></gazebo>"
    )


def in_sensor(kind: str, inside: str = "", *, rate: str = "{rate}") -> str:
    """What stands before the plugin of a sensor on the link `base` or `bob`."""
    return (
        f'<gazebo reference="bob"><sensor name="s" type="{kind}"><always_on>true</always_on>'
        f"<update_rate>{rate}</update_rate>{inside}"
    )


RAY = """<ray><scan><horizontal><samples>9</samples><resolution>1</resolution>
<min_angle>-1.5</min_angle><max_angle>1.5</max_angle></horizontal></scan>
<range><min>0.08</min><max>10</max></range>
<noise><type>gaussian</type><mean>0</mean><stddev>0.01</stddev></noise></ray>"""
NOISY_IMU = """<imu><angular_velocity><x><noise type="gaussian"><mean>0</mean><stddev>0.01</stddev></noise></x>
</angular_velocity></imu>"""
END_OF_SENSOR = "</sensor></gazebo>"

TRANSMISSION = """<transmission name="t"><type>transmission_interface/SimpleTransmission</type>
<joint name="swing"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
<actuator name="motor"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>"""

MANAGER = "/controller_manager"
MANAGER_MSGS = "controller_manager_msgs"


def sample_of(filename: str) -> Sample:
    """The sample of a library: `SAMPLE` in the tests of its module."""
    package, _, name = plugins()[filename].module.rpartition(".")
    try:
        sample: Sample = importlib.import_module(f"tests.{package}.test_{name}").SAMPLE
    except (ImportError, AttributeError):
        pytest.fail(
            f"write SAMPLE = Sample(...) into tests/{package.replace('.', '/')}/test_{name}.py"
        )
    return sample
