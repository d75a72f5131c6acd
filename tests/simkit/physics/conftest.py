"""Robots, things of one solid, and worlds for the tests of physics."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import pytest

from simkit.geometry import Transform
from simkit.physics import ModelPlan, NoEngineError, World, plan_robot
from simkit.urdf import load_robot

ROBOTS = Path(__file__).parent / "robots"
SECOND = 1_000_000_000

SHAPES = {
    "box": '<box size="{0} {1} {2}"/>',
    "cylinder": '<cylinder radius="{0}" length="{1}"/>',
    "sphere": '<sphere radius="{0}"/>',
}


def moments(kind: str, sizes: tuple[float, ...], mass: float) -> tuple[float, float, float]:
    """Moments of inertia of a solid, about its middle."""
    if kind == "box":
        x, y, z = sizes
        return (
            mass * (y * y + z * z) / 12,
            mass * (x * x + z * z) / 12,
            mass * (x * x + y * y) / 12,
        )
    if kind == "cylinder":
        radius, length = sizes
        across = mass * (3 * radius**2 + length**2) / 12
        return (across, across, mass * radius**2 / 2)
    about = 0.4 * mass * sizes[0] ** 2
    return (about, about, about)


@pytest.fixture
def plan_text() -> Callable[[str], ModelPlan]:
    """Makes a plan of the inside of a `<robot>`."""

    def make(inside: str, name: str = "r") -> ModelPlan:
        text = f'<robot name="{name}">{inside}</robot>'
        return plan_robot(load_robot(text, file="r.urdf"))

    return make


@pytest.fixture
def solid(plan_text) -> Callable[..., ModelPlan]:
    """Makes a plan of one solid with even density."""

    def make(kind: str, *sizes: float, mass: float = 1.0, mu: float = 1.0, still: bool = False):
        ixx, iyy, izz = moments(kind, sizes, mass)
        return plan_text(
            f"""<link name="body">
              <inertial><mass value="{mass}"/>
                <inertia ixx="{ixx}" iyy="{iyy}" izz="{izz}" ixy="0" ixz="0" iyz="0"/></inertial>
              <collision><geometry>{SHAPES[kind].format(*sizes)}</geometry></collision>
            </link>
            <gazebo reference="body"><mu1>{mu}</mu1><mu2>{mu}</mu2></gazebo>
            <gazebo><static>{str(still).lower()}</static></gazebo>""",
            name=kind,
        )

    return make


@pytest.fixture
def robot_plan() -> Callable[[str], ModelPlan]:
    """Makes a plan of a robot in the folder `robots`."""

    def make(name: str) -> ModelPlan:
        return plan_robot(load_robot((ROBOTS / f"{name}.urdf").read_text(), file=f"{name}.urdf"))

    return make


@pytest.fixture
def new_world() -> Callable[..., World]:
    """Makes a world; skips where dartpy is not."""

    def make(**options) -> World:
        try:
            return World(**options)
        except NoEngineError as error:
            pytest.skip(str(error))

    return make


@pytest.fixture
def at() -> Callable[..., Transform]:
    """Makes a pose of a place and an angle about an axis."""

    def make(x=0.0, y=0.0, z=0.0, *, angle=0.0, axis=(0.0, 0.0, 1.0)) -> Transform:
        s, length = math.sin(angle / 2), math.hypot(*axis)
        turn = (s * axis[0] / length, s * axis[1] / length, s * axis[2] / length)
        return Transform((x, y, z), (*turn, math.cos(angle / 2)))

    return make
