"""What physics must know of a link: its mass, how hard it is to turn, and the shape that others touch."""

from __future__ import annotations

from grader.checks.expect import expect_close
from grader.checks.robots import link_of, only_visual
from grader.checks.rotations import Rotation, rotation_of
from grader.checks.worlds import turned_inertia
from grader.errors import CheckFailed
from simkit.urdf import Collision, Cylinder, Inertial, Robot

_SLACK = 0.02
"""Share by which an inertia may differ from the formula: numbers in books are rounded."""


def expect_cylinder_weight(
    robot: Robot, link: str, *, mass: float, length: float, radius: float
) -> None:
    """Expect a link to weigh what a full cylinder that stands on its frame weighs, along z.

    Args:
        robot: The robot.
        link: The link.
        mass: [kg].
        length: [m].
        radius: [m].

    Raises:
        CheckFailed: Mass, centre or inertia are others.
    """
    inertial = link_of(robot, link).inertial
    if inertial is None:
        raise CheckFailed(
            f"{link} has no mass", hint="Mass and inertia belong in <inertial>, inside the link."
        )
    expect_close(
        inertial.mass,
        mass,
        tolerance=1e-6,
        what=f"the mass of {link}",
        unit="kg",
        hint='The text gives the mass of each link: <mass value="..."/>.',
    )
    expect_close(
        inertial.origin.xyz,
        (0.0, 0.0, length / 2),
        tolerance=1e-4,
        what=f"the centre of mass of {link}",
        unit="m",
        frame=link,
        hint="It is in the middle of the cylinder, half its length along z: set it with <origin> in <inertial>.",
    )
    across = mass * (3 * radius**2 + length**2) / 12
    along = mass * radius**2 / 2
    right = ((across, 0.0, 0.0), (0.0, across, 0.0), (0.0, 0.0, along))
    found = _tensor(inertial)
    slack = _SLACK * min(across, along)
    for row, (ours, theirs) in enumerate(zip(right, found, strict=True)):
        for column in range(row, 3):
            expect_close(
                theirs[column],
                ours[column],
                tolerance=max(slack, _SLACK * ours[column]),
                what=f"i{'xyz'[row]}{'xyz'[column]} of {link}",
                unit="kg m^2",
                hint="About x and y it is m (3 r^2 + h^2) / 12, about z, along the length, m r^2 / 2.",
            )


def expect_collision_as_visual(robot: Robot, link: str) -> None:
    """Expect others to touch of a link just what is seen of it: one cylinder.

    Raises:
        CheckFailed: It has no such shape, or one of another size or place.
    """
    visual = only_visual(robot, link)
    collisions = link_of(robot, link).collisions
    if len(collisions) != 1:
        raise CheckFailed(
            f"{link} has {len(collisions)} collision shapes, not one",
            hint="Write one <collision> with <geometry> and <origin>, like <visual>.",
        )
    (collision,) = collisions
    seen, felt = visual.geometry, collision.geometry
    if not isinstance(felt, Cylinder) or not isinstance(seen, Cylinder):
        raise CheckFailed(
            f"the collision shape of {link} is not a cylinder",
            hint="Use the same shape as in its visual.",
        )
    expect_close(
        (felt.length, felt.radius),
        (seen.length, seen.radius),
        tolerance=1e-6,
        what=f"length and radius of the collision shape of {link}",
        unit="m",
        hint="It is the same cylinder as in the visual.",
    )
    _expect_place(collision, visual.origin.xyz, link)


def _expect_place(collision: Collision, xyz: tuple[float, float, float], link: str) -> None:
    expect_close(
        collision.origin.xyz,
        xyz,
        tolerance=1e-4,
        what=f"the middle of the collision shape of {link}",
        unit="m",
        frame=link,
        hint="It is where the visual is: give both the same <origin>.",
    )


def _tensor(inertial: Inertial) -> Rotation:
    """The inertia in the axes of the link."""
    own = (
        (inertial.ixx, inertial.ixy, inertial.ixz),
        (inertial.ixy, inertial.iyy, inertial.iyz),
        (inertial.ixz, inertial.iyz, inertial.izz),
    )
    return turned_inertia(own, rotation_of(*inertial.origin.rpy))
