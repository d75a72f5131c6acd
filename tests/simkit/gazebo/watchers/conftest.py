"""A world that is watched, and cars in it: right ones, and ones with a fault."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from simkit.gazebo.watchers import watch
from simkit.graph import LogLevel
from simkit.physics import NoEngineError
from tests.simkit.plugins.conftest import Stage
from tests.simkit.plugins.samples import CAR, twist

MASS = """<inertial><mass>{0}</mass><inertia><ixx>{1}</ixx><iyy>{1}</iyy><izz>{1}</izz>
<ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial>"""
BALL = """<collision name="ball{0}"><pose>{0} 0 -0.05 0 0 0</pose><geometry><sphere><radius>0.05</radius></sphere>
</geometry><surface><friction><ode><mu>0</mu><mu2>0</mu2></ode></friction></surface></collision>"""
WHEEL = """<link name="{0}"><pose>0 {1} 0.1 0 0 0</pose>{2}<collision name="rim"><pose>0 0 0 1.5707963267948966 0 0</pose>
<geometry><cylinder><radius>0.1</radius><length>0.02</length></cylinder></geometry></collision></link>
<joint name="{0}_joint" type="revolute"><parent>base</parent><child>{0}</child>
<axis><xyz>0 {3} 0</xyz></axis></joint>"""


def drive_tag(
    *,
    left: str = "left",
    right: str = "right",
    separation: float = 0.4,
    diameter: float = 0.2,
    torque: float = 5,
) -> str:
    """The plugin of a car."""
    return f"""<plugin name="drive" filename="libgazebo_ros_diff_drive.so">
      <leftJoint>{left}_joint</leftJoint><rightJoint>{right}_joint</rightJoint>
      <wheelSeparation>{separation}</wheelSeparation><wheelDiameter>{diameter}</wheelDiameter>
      <wheelTorque>{torque}</wheelTorque><updateRate>20</updateRate></plugin>"""


class Watched(Stage):
    """A world that is watched."""

    def __init__(self) -> None:
        super().__init__()
        self.watch = watch(self.gazebo)

    def car(self, *, z: float = 0.1, more: str = "", robot: str = CAR, **drive):
        """A car of URDF."""
        inside = f"{robot}{more}<gazebo>{drive_tag(**drive)}</gazebo>"
        return self.spawn(inside, name="car", pose=self.at(z=z))

    def sdf_car(self, *, axes: tuple[int, int] = (1, 1), **drive):
        """The same car of SDF, of which `check_urdf` says nothing."""
        wheels = "".join(
            WHEEL.format(name, y, MASS.format(0.2, 0.001), axis)
            for name, y, axis in (("left", 0.2, axes[0]), ("right", -0.2, axes[1]))
        )
        text = f"""<sdf version="1.6"><model name="car"><link name="base"><pose>0 0 0.1 0 0 0</pose>
          {MASS.format(5, 0.1)}{BALL.format(0.2)}{BALL.format(-0.2)}</link>{wheels}{drive_tag(**drive)}</model></sdf>"""
        return self.gazebo.spawn_sdf(text, name="car", file="car.sdf")

    def tell(self, speed: float, turn: float = 0.0) -> None:
        """Command the car [m/s, rad/s]."""
        message = twist(speed, turn)
        self.listener.advertise("/cmd_vel", type(message)).publish(message)

    def found(self, rule: str = "", level: LogLevel = LogLevel.WARN) -> list[str]:
        """What was found, under a rule or at all."""
        return [text for text in self.said(level) if text.startswith(f"[{rule}")]


@pytest.fixture
def new_watched() -> Callable[[], Watched]:
    """Makes a world that is watched; skips where dartpy is not."""

    def make() -> Watched:
        try:
            return Watched()
        except NoEngineError as error:
            pytest.skip(str(error))

    return make


@pytest.fixture
def watched(new_watched) -> Watched:
    """A world that is watched."""
    return new_watched()
