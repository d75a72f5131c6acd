"""What a student's process may do: the strongest isolation that works here, and its limits."""

from grader.sandbox.confinement import Confinement
from grader.sandbox.detect import find_sandbox
from grader.sandbox.sandbox import Sandbox

__all__ = ["Confinement", "Sandbox", "find_sandbox"]
