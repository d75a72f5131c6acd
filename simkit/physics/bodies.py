"""Mass and inertia of rigid groups of links, made fit for an engine that checks nothing."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from simkit.geometry import Matrix
from simkit.physics.errors import ModelError
from simkit.physics.lumps import Member, RigidGroup
from simkit.urdf.inertia import Body, eigenvalues, merged, placed_body
from simkit.urdf.model import Inertial, Pose

NO_MASS = 1e-6
"""A smaller mass [kg] is none, as for sdformat."""
LARGEST = 1e9
"""Larger numbers [m, kg, kg m^2] are no robot, and leave the range in which computers are exact."""
FAR = 1e4
"""Larger lengths [m] belong to no robot."""
THINNEST = 1e-7
"""Smallest principal moment of inertia per mass [m^2]: all of it within 0.3 mm of an axis."""


def body_of(lump: RigidGroup) -> Body | None:
    """The body that the links of a lump make, in the frame of the lump; None if it has no mass.

    Raises:
        ModelError: A mass is negative, or a number is none.
    """
    bodies = [
        placed_body(body, member.frame)
        for member in lump.members
        if (body := _own_body(member)) is not None
    ]
    if sum(body.mass for body in bodies) < NO_MASS:
        return None
    return merged(bodies)


def _own_body(member: Member) -> Body | None:
    """The body of one link in its own frame, None if it weighs nothing."""
    inertial = member.link.inertial
    if inertial is None:
        return None
    name = member.link.name
    tensor = _tensor(inertial)
    check_numbers((inertial.mass, *np.ravel(tensor)), f"the inertial of link {name}")
    check_pose(inertial.origin, f"the inertial of link {name}")
    if inertial.mass < 0.0:
        raise ModelError(f"link {name} has a mass of {inertial.mass:g} kg: a mass is positive")
    if inertial.mass < NO_MASS:
        return None
    return placed_body(Body(inertial.mass, (0.0, 0.0, 0.0), tensor), inertial.origin.transform)


def _tensor(inertial: Inertial) -> Matrix:
    one = inertial
    return ((one.ixx, one.ixy, one.ixz), (one.ixy, one.iyy, one.iyz), (one.ixz, one.iyz, one.izz))


def check_numbers(numbers: Iterable[float], what: str) -> None:
    """See that numbers are numbers, and of this world.

    Raises:
        ModelError: One is infinite, not a number, or beyond all size.
    """
    for number in numbers:
        if not math.isfinite(number) or abs(number) > LARGEST:
            raise ModelError(f"{what} holds {number:g}, which no simulator can compute with")


def check_lengths(lengths: Iterable[float], what: str) -> None:
    """See that lengths [m] are such of a robot.

    Raises:
        ModelError: One is not a number, or longer than 10 km.
    """
    for length in lengths:
        if not abs(length) <= FAR:
            raise ModelError(
                f"{what} has a length of {length:g} m, which no simulator can compute with"
            )


def check_pose(pose: Pose, what: str) -> None:
    """See that a pose is one.

    Raises:
        ModelError: A number of it is none, or too large.
    """
    check_lengths(pose.xyz, what)
    check_numbers(pose.rpy, what)


def sound(body: Body, name: str) -> tuple[Body, str]:
    """A body that the engine can turn, and what was changed in it; the note is empty if nothing.

    A tensor with a moment that is zero or negative turns without effort, or away from every push:
    the numbers would leave all bounds within a few steps.
    """
    low, _, _ = eigenvalues(body.tensor)
    least = THINNEST * body.mass
    if low >= least:
        return body, ""
    moments, axes = np.linalg.eigh(np.array(body.tensor))
    raised = np.maximum(moments, least)
    tensor = axes @ np.diag(raised) @ axes.T
    rows = [tuple(float(x) for x in row) for row in (tensor + tensor.T) / 2.0]
    note = (
        f"the inertia of {name} is impossible (its smallest principal moment is {low:.3g} kg m^2): "
        f"simulated with {least:.3g} kg m^2 instead"
    )
    return Body(body.mass, body.centre, (rows[0], rows[1], rows[2])), note  # type: ignore[arg-type]
