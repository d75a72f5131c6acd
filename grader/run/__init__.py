"""From submissions to results: one checker process each, held to its time, and many at once."""

from grader.run.grade import grade_submission
from grader.run.launch import Launcher, SpawnLauncher, WarmLauncher, default_launcher
from grader.run.supervise import TimeLimits

__all__ = [
    "Launcher",
    "SpawnLauncher",
    "TimeLimits",
    "WarmLauncher",
    "default_launcher",
    "grade_submission",
]
