"""Exercise 3.6, hidden checks: the signpost is the one that was meant."""

import math

import pytest

from grader.checks import after, expect_close, points
from grader.checks.robots import RobotFiles, only_visual
from grader.checks.rotations import about_z, apart, rotation_of


@pytest.fixture
def signpost(exercise, submission, package_path):
    """The fixed signpost."""
    return RobotFiles(exercise, submission, package_path).robot("signpost.urdf")


@points(1)
@after("test_the_signpost_is_mended")
def test_the_signpost_is_the_one_that_was_meant(signpost):
    """Once it is fixed, the signpost has the sizes and positions that its author had in mind."""
    pole = only_visual(signpost, "pole")
    hint = "Fix what is wrong, and keep every number that is right."
    expect_close(
        (getattr(pole.geometry, "radius", 0.0), getattr(pole.geometry, "length", 0.0)),
        (0.02, 0.8),
        tolerance=1e-6,
        what="radius and length of the pole",
        unit="m",
        hint=hint,
    )
    expect_close(
        (*pole.origin.xyz, *signpost.joint_above("pole").origin.xyz),
        (0.0, 0.0, 0.4, 0.0, 0.0, 0.1),
        tolerance=1e-6,
        what="the middle of the pole, and the position of its frame",
        unit="m",
        hint=hint,
    )
    for link, size, middle in (
        ("base_link", (0.4, 0.4, 0.1), (0.0, 0.0, 0.05)),
        ("sign", (0.3, 0.02, 0.1), (0.0, 0.0, 0.0)),
    ):
        box = only_visual(signpost, link)
        expect_close(
            (*getattr(box.geometry, "size", (0.0, 0.0, 0.0)), *box.origin.xyz),
            (*size, *middle),
            tolerance=1e-6,
            what=f"the size of the box of {link}, and its middle",
            unit="m",
            hint="Correct the line that is wrong; do not delete it.",
        )
    nail = signpost.joint_above("sign").origin
    expect_close(
        nail.xyz,
        (0.0, 0.0, 0.75),
        tolerance=2e-3,
        what="the position of the nail on the pole",
        unit="m",
        hint=hint,
    )
    expect_close(
        apart(rotation_of(*nail.rpy), about_z(math.pi / 2)),
        0.0,
        tolerance=2e-3,
        what="how far the sign is from a quarter turn about z",
        unit="rad",
        hint="The sign is rotated by a quarter turn about z, and rpy is in radians.",
    )
