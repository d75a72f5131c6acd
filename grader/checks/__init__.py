"""What the author of a check needs: marks, expectations, and fixtures by name.

A check is a pytest function. Its docstring is the sentence that the student reads; it asks by
argument for `submission`, `exercise`, `package_path`, `seed`, `rng`, `sim`, `run_node`, `roslaunch` or
`launch_plan`.
"""

from grader.checks.expect import expect, expect_close, expect_close_angle, expect_equal
from grader.checks.marks import after, points
from grader.errors import CheckFailed

__all__ = [
    "CheckFailed",
    "after",
    "expect",
    "expect_close",
    "expect_close_angle",
    "expect_equal",
    "points",
]
