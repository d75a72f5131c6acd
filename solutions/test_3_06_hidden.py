"""Exercise 3.6, hidden checks: the signpost is the one that was meant."""

import math

import pytest

from grader.checks import after, expect_close, points
from grader.checks.robots import RobotFiles, only_visual


@pytest.fixture
def signpost(exercise, submission, package_path):
    """The mended signpost."""
    return RobotFiles(exercise, submission, package_path).robot("signpost.urdf")


@points(1)
@after("test_the_signpost_is_mended")
def test_the_signpost_is_the_one_that_was_meant(signpost):
    """Mended, the signpost has the sizes and places that its author had in mind."""
    pole = only_visual(signpost, "pole")
    hint = "Mend what is wrong, and keep every number that is right."
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
        what="the middle of the pole, and the place of its frame",
        unit="m",
        hint=hint,
    )
    nail = signpost.joint_above("sign").origin
    expect_close(
        (*nail.xyz, *nail.rpy),
        (0.0, 0.0, 0.75, 0.0, 0.0, math.pi / 2),
        tolerance=2e-3,
        what="xyz and rpy of the nail",
        hint="The sign is turned by a quarter turn about z: rpy is in radians.",
    )
